"""Scenes of headlamps for the tests of glare headlamp."""

import csv
import json
import math

import exr
from cli import GlareTest

# Float pixels: a background of 2 is known to 1e-7, and a veil is compared where it is not small.
FLOAT = 2e-6
# The bound of the issue for what a frame adds; perspective against direction sines is within it.
ADDED = 0.005


def toml(**tables):
    """A scene of tables; a list is an array of tables."""
    def value(v):
        return json.dumps(v)
    lines = []
    for name, content in tables.items():
        if not isinstance(content, (dict, list)):
            lines.append(f"{name} = {value(content)}")
            continue
        for table in content if isinstance(content, list) else [content]:
            lines.append(f"[[{name}]]" if isinstance(content, list) else f"[{name}]")
            lines += [f"{k} = {value(v)}" for k, v in table.items()]
    return "\n".join(lines) + "\n"


class HeadlampTest(GlareTest):
    templates = {}  # Made once: its content.

    def setUp(self):
        super().setUp()
        if not self.templates:
            self.make("--normalize", "energy", output="t.exr")
            self.templates["t.exr"] = self.path("t.exr").read_bytes()
        self.write("t.exr", self.templates["t.exr"])
        self.template = exr.read(self.path("t.exr"))
        self.environment["XDG_CACHE_HOME"] = str(self.path("cache"))

    def scene(self, name="scene.toml", lamps=None, background=None, **tables):
        plain = {"luminance_cd_m2": 2, "size_px": [65, 49], "horizontal_fov_deg": 2}
        lamp = {"template": "t.exr", "intensity_cd": 10000}
        lamps = [lamp | changes for changes in lamps or [{"position_m": [0, 0, 50]}]]
        tables = tables | {"background": background or plain, "lamps": lamps}
        return self.write(name, toml(**tables))

    def aligned_scene(self, lamps=None, width=65, **tables):
        """The picture's pixels, at its axis, are the template's."""
        fov = 2 * math.degrees(math.atan(width / 2 * self.pitch()))
        plain = {"luminance_cd_m2": 2, "size_px": [width, 49], "horizontal_fov_deg": fov}
        return self.scene(lamps=lamps, background=plain, **tables)

    def run_headlamp(self, *arguments, scene="scene.toml"):
        result = self.glare("headlamp", scene, "--quiet", *arguments)
        self.assertEqual((result.status, result.out, result.err), (0, "", ""))
        return result

    def report(self, *arguments, **options):
        """The rows of the report, numbers as numbers."""
        self.run_headlamp("--report", "report.csv", *arguments, **options)
        with open(self.path("report.csv"), encoding="utf-8") as file:
            return [{k: float(v) if v and k != "lamp" else v for k, v in row.items()}
                    for row in csv.DictReader(file)]

    def picture(self, *arguments, output="frame.exr", **options):
        self.run_headlamp("-o", output, *arguments, **options)
        return exr.read(self.path(output))

    def added(self, picture, background=2):
        """What the lamps added, channel by channel, at (column, row)."""
        width, _ = picture.size
        return lambda column, row: [picture.channels[c][row * width + column] - background
                                    for c in "RGB"]

    def veil(self, column, row, lux):
        """Of a template's pixel, counted from its axis."""
        width, height = self.template.size
        at = (row + height // 2) * width + column + width // 2
        scale = lux * self.template.attributes["glare:perSteradian"]
        return [scale * self.template.channels[c][at] for c in "RGB"]

    def pitch(self):
        return math.radians(self.template.attributes["glare:pixelPitch_deg"])

    def assert_close(self, found, expected, relative):
        self.assertEqual(len(found), len(expected))
        worst = max(abs(a - b) for a, b in zip(found, expected))
        self.assertLessEqual(worst, relative * max(map(abs, expected)))
