"""Photometric files of a function, and what the commands tell of them."""

import json

from cli import GlareTest

TYPES = {"A": 3, "B": 2, "C": 1}


def span(lo, hi, step):
    return [lo + k * step for k in range(round((hi - lo) / step) + 1)]


def ies(kind, horizontal, vertical, candela, *, version="IESNA:LM-63-2002", lumens=-1, factor=1,
        tilt="NONE", ballast=1, lines=()):
    """LM-63: `candela(h, v)` at each pair of angles, each horizontal angle on a line of its own."""
    head = [version, "[TEST] by hand", "[MANUFAC] nobody", *lines] if version else ["By hand"]
    head += [f"TILT={tilt}", f"1 {lumens} {factor} {len(vertical)} {len(horizontal)} "
             f"{TYPES[kind]} 2 0.1 0.2 0", f"{ballast} 1 10"]
    rows = [vertical, horizontal] + [[f"{candela(h, v):.9g}" for v in vertical] for h in horizontal]
    return "\n".join(head + [" ".join(map(str, row)) for row in rows]) + "\n"


def ldt(symmetry, planes, gammas, stored, *, sets=((1, 1000),), factor="1", decimal=","):
    """EULUMDAT: rows of cd/klm as they are stored; `sets` are lamps and their lumens."""
    step = planes[1] - planes[0] if len(planes) > 1 else 0
    fields = ["nobody", 2, symmetry, len(planes), step, len(gammas), gammas[1] - gammas[0],
              "by hand", "name", "", "", "", *[0] * 9, 100, 100, factor, 0, len(sets)]
    for count, lumens in sets:
        fields += [count, "lamp", lumens, "", "", 10]
    fields += [0] * 10 + list(planes) + list(gammas) + [value for row in stored for value in row]
    return "\r\n".join(str(field).replace(".", decimal) if isinstance(field, float) else str(field)
                       for field in fields) + "\r\n"


class PhotometryTest(GlareTest):
    def told(self, file, *arguments, warnings=0):
        result = self.glare("photometry", "info", file, "--json", *arguments)
        self.assertEqual(result.status, 0, result.err)
        self.assertEqual(len(result.lines("warning")), warnings, result.err)
        self.assertEqual(len(result.err.splitlines()), warnings, result.err)
        return json.loads(result.out)

    def intensities(self, file, *directions):
        """In candela, in each direction."""
        options = [word for h, v in directions for word in ("--at", h, v)]
        return [at["intensity_cd"] for at in self.told(file, *options)["at"]]

    def assert_close(self, values, expected, relative):
        self.assertEqual(len(values), len(expected))
        for value, right in zip(values, expected):
            self.assertAlmostEqual(value, right, delta=relative * abs(right) + 1e-12)
