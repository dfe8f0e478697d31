"""data/photometry: the beams are what their script makes, and within the regulations' limits.

Limits: UN Regulation No. 112, 01 series of amendments, paragraphs 6.2.4 (passing beam, class B) and
6.3.3 (driving beam, class B) and annex 9 (the cut-off); H-3, 6, 9 and 12: UN Regulation No. 149, 01
series, table 5. H right and V up positive, for right-hand traffic.
"""

import bisect
import importlib.util
import math
import pathlib
import re
import tempfile
import unittest

FOLDER = pathlib.Path(__file__).resolve().parents[2] / "data" / "photometry"
LOW, HIGH = ("halogen_low", "hid_low", "led_low"), ("halogen_high", "hid_high")
SIDES = {"_right_hand_traffic": 1, "_left_hand_traffic": -1}

# name: H, V, least, most
LOW_POINTS = {"B50L": (-3.43, 0.57, 0, 350), "BR": (2.5, 1, 0, 1750),
              "75R": (1.15, -0.57, 10100, math.inf), "75L": (-3.43, -0.57, 0, 10600),
              "50L": (-3.43, -0.86, 0, 13200), "50R": (1.72, -0.86, 10100, math.inf),
              "50V": (0, -0.86, 5100, math.inf), "25L": (-9, -1.72, 1700, math.inf),
              "25R": (9, -1.72, 1700, math.inf), "7": (-8, 0, 65, math.inf),
              "8": (-4, 0, 125, math.inf)}
LOW_SUMS = {"1 + 2 + 3": ([(-8, 4), (0, 4), (8, 4)], 190),
            "4 + 5 + 6": ([(-4, 2), (0, 2), (4, 2)], 375)}
ZONE_III = [(-8, 1), (-8, 4), (8, 4), (8, 2), (6, 1.5), (1.5, 1.5), (0, 0), (-4, 0)]
ZONE_III_MOST, ZONE_IV_LEAST = 625, 2500
HIGH_POINTS = {"H-2.5": (2.5, 20300), "H-3": (3, 17500), "H-5": (5, 5100), "H-6": (6, 5000),
               "H-9": (9, 3400), "H-12": (12, 1500)}
MAXIMUM, MAXIMUM_MOST = 40500, 215000


class Beam:
    """A file of one beam, read with nothing but its angles and values; bilinear between them."""

    def __init__(self, path):
        numbers = [float(word) for word in path.read_text().split("TILT=NONE")[1].split()]
        v_count, h_count, self.photometric_type = (int(n) for n in numbers[3:6])
        self.v, rest = numbers[13:13 + v_count], numbers[13 + v_count:]
        self.h, values = rest[:h_count], rest[h_count:]
        assert len(values) == h_count * v_count
        self.columns = [values[i * v_count:(i + 1) * v_count] for i in range(h_count)]
        self.symmetric = self.h[0] == 0

    @staticmethod
    def place(angles, angle):
        i = min(max(bisect.bisect_right(angles, angle) - 1, 0), len(angles) - 2)
        return i, (angle - angles[i]) / (angles[i + 1] - angles[i])

    def __call__(self, h, v):
        i, s = self.place(self.h, abs(h) if self.symmetric else h)
        j, t = self.place(self.v, v)
        a, b = self.columns[i], self.columns[i + 1]
        return (1 - s) * ((1 - t) * a[j] + t * a[j + 1]) + s * ((1 - t) * b[j] + t * b[j + 1])

    def flux_lm(self):
        """The integral of the bilinear values over the hemisphere."""
        def weights(angles, density):
            """Of each angle's value in the integral of linear values times the density."""
            total = [0.0] * len(angles)
            for i, (a, b) in enumerate(zip(angles, angles[1:])):
                for k in range(8):  # Narrow enough for the midpoint rule to be exact to 1e-4.
                    t = (k + 0.5) / 8
                    part = density(math.radians(a + t * (b - a))) * math.radians(b - a) / 8
                    total[i] += (1 - t) * part
                    total[i + 1] += t * part
            return total
        across = weights(self.h, lambda _: 2.0 if self.symmetric else 1.0)
        up = weights(self.v, math.cos)
        return sum(w * sum(u * value for u, value in zip(up, column))
                   for w, column in zip(across, self.columns))


def steps(lo, hi, step):
    return [lo + k * step for k in range(round((hi - lo) / step) + 1)]


def in_zone_iii(h, v):
    """By the even-odd rule, borders within a thousandth of a degree included."""
    def inside(x, y):
        crossings = 0
        for (x0, y0), (x1, y1) in zip(ZONE_III, ZONE_III[1:] + ZONE_III[:1]):
            if (y0 > y) != (y1 > y) and x < (x1 - x0) * (y - y0) / (y1 - y0) + x0:
                crossings += 1
        return crossings % 2 == 1
    return any(inside(h + dx, v + dy) for dx in (-1e-3, 1e-3) for dy in (-1e-3, 1e-3))


def low_values(beam, side):
    """What README.md tells of a low beam, row by row."""
    rows = {name: beam(side * h, v) for name, (h, v, _, _) in LOW_POINTS.items()}
    rows |= {name: sum(beam(side * h, v) for h, v in points)
             for name, (points, _) in LOW_SUMS.items()}
    rows["zone III"] = max(beam(side * h, v) for h in steps(-8, 8, 0.1) for v in steps(0, 4, 0.05)
                           if in_zone_iii(h, v))
    rows["zone IV"] = min(beam(side * h, v) for h in steps(-5.15, 5.15, 0.05)
                          for v in steps(-1.72, -0.86, 0.02))
    rows["zone I"] = max(beam(side * h, v) for h in steps(-9, 9, 0.1)
                         for v in steps(-4, -1.72, 0.04))
    return rows | general_values(beam)


def high_values(beam):
    rows = {"H-V": beam(0, 0)}
    rows |= {name: min(beam(-h, 0), beam(h, 0)) for name, (h, _) in HIGH_POINTS.items()}
    return rows | general_values(beam)


def general_values(beam):
    return {"maximum": max(map(max, beam.columns)), "flux": beam.flux_lm()}


class Beams(unittest.TestCase):
    def low_beams(self):
        return [(name + side, Beam(FOLDER / f"{name}{side}.ies"), sign)
                for name in LOW for side, sign in SIDES.items()]

    def test_files_are_what_the_script_makes(self):
        spec = importlib.util.spec_from_file_location("make_beams", FOLDER / "make_beams.py")
        script = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(script)
        files = {path.stem: path.read_text() for path in FOLDER.glob("*.ies")}
        self.assertEqual(files.keys(), script.BEAMS.keys())
        for name, beam in script.BEAMS.items():
            self.assertTrue(script.ies(beam) == files[name], f"{name}: run make_beams.py")
            self.assertLess(len(files[name]), 120_000)

    def test_low_beams_at_the_test_points(self):
        for file, beam, side in self.low_beams():
            for name, (h, v, least, most) in LOW_POINTS.items():
                self.assertTrue(least <= beam(side * h, v) <= most, f"{file}: {name}")
            for name, (points, least) in LOW_SUMS.items():
                self.assertGreaterEqual(sum(beam(side * h, v) for h, v in points), least, file)

    def test_low_beams_in_the_zones(self):
        for file, beam, side in self.low_beams():
            rows = low_values(beam, side)
            self.assertLessEqual(rows["zone III"], ZONE_III_MOST, file)
            self.assertGreaterEqual(rows["zone IV"], ZONE_IV_LEAST, file)
            self.assertLessEqual(rows["zone I"], 2 * rows["50R"], file)

    def test_cut_offs_are_sharp_enough_and_one_per_cent_down(self):
        for file, beam, side in self.low_beams():
            for h in (-1.5, -2.5, -3.5):
                scan = {v: math.log10(beam(side * h, v)) - math.log10(beam(side * h, v + 0.1))
                        for v in steps(-1.5, 0.5, 0.02)}
                steepest = max(scan, key=scan.get)
                self.assertTrue(0.13 <= scan[steepest] <= 0.4, file)
                # Half the interval of the scan, and half the file's, may lie between.
                self.assertAlmostEqual(steepest + 0.05, -0.573, delta=0.1, msg=file)

    def test_the_sides_are_mirrored(self):
        for name in LOW:
            right, left = (Beam(FOLDER / f"{name}{side}.ies") for side in SIDES)
            self.assertEqual(left.columns, right.columns[::-1])
            self.assertEqual(left.h, right.h)
            self.assertGreater(right(3, 0), 2 * right(-3, 0), name)  # The rising side.

    def test_high_beams_at_the_test_points(self):
        for file in HIGH:
            rows = high_values(Beam(FOLDER / f"{file}.ies"))
            self.assertTrue(MAXIMUM <= rows["maximum"] <= MAXIMUM_MOST, file)
            self.assertGreaterEqual(rows["H-V"], 0.8 * rows["maximum"], file)
            for name, (_, least) in HIGH_POINTS.items():
                self.assertGreaterEqual(rows[name], least, f"{file}: {name}")

    def test_no_direction_is_dark_and_poles_are_one_direction(self):
        for path in FOLDER.glob("*.ies"):
            beam = Beam(path)
            self.assertEqual(beam.photometric_type, 3)  # A, in LM-63.
            self.assertGreater(min(map(min, beam.columns)), 0)
            for end in (0, -1):
                self.assertEqual(len({column[end] for column in beam.columns}), 1)

    def test_readme_has_the_values(self):
        text = (FOLDER / "README.md").read_text(encoding="utf-8")
        columns = [low_values(Beam(FOLDER / f"{n}_right_hand_traffic.ies"), 1) for n in LOW]
        self.check_rows(text, "point of the low beam", columns)
        self.check_rows(text, "point of the high beam",
                        [high_values(Beam(FOLDER / f"{n}.ies")) for n in HIGH])

    def check_rows(self, text, heading, columns):
        table = text[text.index(f"| {heading}"):].split("\n\n")[0]
        rows = {cells[0].strip(): [float(cell) for cell in cells[-len(columns):]]
                for cells in (re.findall(r"[^|]+", line) for line in table.splitlines()[2:])}
        self.assertEqual(rows.keys(), columns[0].keys())
        for name, told in rows.items():
            for number, column in zip(told, columns):
                self.assertAlmostEqual(number, column[name], delta=0.501, msg=name)


def readme_rows():
    """The rows of README.md's two tables, to paste: python3 -c 'import test_beams as t; ...'."""
    lows = [low_values(Beam(FOLDER / f"{n}_right_hand_traffic.ies"), 1) for n in LOW]
    highs = [high_values(Beam(FOLDER / f"{n}.ies")) for n in HIGH]
    return "\n".join(f"| {name} | | {' | '.join(f'{c[name]:.0f}' for c in columns)} |"
                     for columns in (lows, highs) for name in columns[0])


if __name__ == "__main__":
    unittest.main()
