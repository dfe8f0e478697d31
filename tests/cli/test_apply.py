"""glare apply: what it makes of a picture's light."""

import math
import unittest

import exr
from apply import FLOAT, FOV_DEG, ApplyTest, black, impulse, kernel, with_kernel

LIGHT = 1000.0


def widths(values, width, x, y):
    """How wide light lies about a pixel, across and down: the fourth root of the sum of light times
    the distance to the fourth. So far from the pixel, its own size hardly counts."""
    return [sum(v * distance(i) ** 4 for i, v in enumerate(values)) ** 0.25
            for distance in (lambda i: i % width - x, lambda i: i // width - y)]


class Impulse(ApplyTest):
    def test_gives_the_template(self):
        for name, (across, down) in {"t.exr": (64, 64), "odd.exr": (47, 31)}.items():
            template = exr.read(self.path(name))
            for width, height, x, y in ((90, 71, 40, 33), (51, 30, 49, 2)):
                channels = impulse(width, height, x, y, (LIGHT, 2 * LIGHT, 0.0))
                self.picture(channels, width, height)
                result = self.apply("--pixel-deg", FOV_DEG / across, template=name)
                expected = with_kernel(channels, width, height, x, y, kernel(template),
                                       (across, down))
                for n in "RGB":
                    self.assert_near(result.channels[n], expected[n], FLOAT * 2 * LIGHT)

    def test_keeps_all_light(self):
        self.picture(impulse(150, 140, 70, 71), 150, 140)
        for pitch in (FOV_DEG / 64, FOV_DEG / 100, FOV_DEG / 13.7):
            result = self.apply("--pixel-deg", pitch)
            for total in result.sums():  # Of 21000 roundings of values far below the largest.
                self.assertAlmostEqual(total, LIGHT, delta=10 * FLOAT * LIGHT)

    def test_is_half_as_wide_where_pixels_are_twice_as_wide(self):
        channels = impulse(161, 161, 80, 80)
        self.picture(channels, 161, 161)
        glare = []
        for factor in (0.5, 1, 2):
            result = self.apply("--pixel-deg", factor * FOV_DEG / 64, "--only-glare")
            glare.append(widths(result.channels["G"], 161, 80, 80))
        for wide, narrow in zip(glare, glare[1:]):
            for a, b in zip(wide, narrow):  # The field ends within a pixel of 16 from the axis.
                self.assertAlmostEqual(a / b, 2, delta=2 / 16 / 2)

    def test_wide_pixels_have_the_light_of_narrow_ones(self):
        self.picture(impulse(161, 161, 80, 80), 161, 161)
        narrow = self.apply("--pixel-deg", FOV_DEG / 64).channels["G"]
        wide = self.apply("--pixel-deg", 3 * FOV_DEG / 64).channels["G"]
        for y in range(60, 101):
            for x in range(60, 101):
                left, top = 80 + 3 * (x - 80) - 1, 80 + 3 * (y - 80) - 1
                block = sum(narrow[(top + j) * 161 + left + i]
                            for j in range(3) for i in range(3))
                self.assertAlmostEqual(wide[y * 161 + x], block, delta=9 * FLOAT * LIGHT)

    def test_tells_scales(self):
        self.picture(impulse(100, 50, 40, 30), 100, 50)
        self.apply("--fov-deg", 10, "--verbose")
        for word in ("0.1 degrees per pixel", "--fov-deg", "0.03125", "20 x 20 pixels"):
            self.assertIn(word, self.last.err)
        self.apply("--fov-deg", 60, "--verbose", warnings=2)  # 3 pixels; and the middle's pitch.
        self.assertIn("--perspective", self.last.err)
        self.apply("--fov-deg", 60, "--perspective", "--verbose", warnings=1)
        self.assertIn(f"{math.degrees(2 * math.tan(math.radians(30)) / 100):.6g} degrees",
                      self.last.err)


    def test_of_much_finer_pixels_is_told_and_has_its_limits(self):
        self.picture(impulse(40, 30, 20, 15), 40, 30)
        self.apply("--pixel-deg", FOV_DEG / 64 / 2.6, warnings=1)
        self.assertIn("2.6 times as wide", self.last.err)
        for whole in (("--edge", "extend"), ("--roll-off", 0.2)):  # 12 GB and its like.
            for pitch in ("1e-5", "1e-300"):
                result = self.glare("apply", "in.exr", "--template", "t.exr", "-o", "none.exr",
                                    "--pixel-deg", pitch, *whole, "--memory-limit", "1GB")
                self.assertEqual(result.status, 5, result.err)
                self.assertIn("MB are allowed", result.err)
                self.assertFalse(self.path("none.exr").exists())


class Constant(ApplyTest):
    def test_stays(self):
        width, height = 150, 120
        channels = {n: [v] * (width * height) for n, v in zip("RGB", (3.0, 1.0, 0.25))}
        self.picture(channels, width, height)
        extended = self.apply("--pixel-deg", FOV_DEG / 64, "--edge", "extend")
        plain = self.apply("--pixel-deg", FOV_DEG / 64)
        for n, value in zip("RGB", (3.0, 1.0, 0.25)):
            self.assert_near(extended.channels[n], channels[n], 10 * FLOAT * value)
            middle = [plain.channels[n][y * width + x] for y in range(33, height - 33)
                      for x in range(33, width - 33)]
            self.assert_near(middle, [value] * len(middle), 10 * FLOAT * value)
            self.assertLess(plain.channels[n][0], 0.9 * value)  # Light left over two borders.

    def test_stays_where_the_template_is_larger(self):
        for width, height in ((1, 1), (9, 5), (2, 70)):
            self.picture({n: [3.0] * (width * height) for n in "RGB"}, width, height)
            result = self.apply("--pixel-deg", FOV_DEG / 64, "--edge", "extend")
            for n in "RGB":
                self.assert_near(result.channels[n], [3] * (width * height), 30 * FLOAT)

    def test_nothing_wraps_around(self):
        width, height = 100, 90
        self.picture(impulse(width, height, 0, 0), width, height)
        for edge in ("black", "extend"):
            result = self.apply("--pixel-deg", FOV_DEG / 64, "--edge", edge)
            for n in "RGB":
                far = [v for i, v in enumerate(result.channels[n])
                       if i % width > 32 or i // width > 32]
                self.assert_near(far, [0] * len(far), FLOAT * LIGHT)


class Light(ApplyTest):
    SIZE = (80, 60)

    def setUp(self):
        super().setUp()
        self.channels = impulse(*self.SIZE, 30, 25)
        for i in range(80 * 60):
            for k, n in enumerate("RGB"):
                self.channels[n][i] += 1 + 0.1 * ((i * 7 + k) % 11)
        self.picture(self.channels, *self.SIZE)
        self.whole = self.changed()

    def changed(self, *arguments, **options):
        return self.apply("--pixel-deg", FOV_DEG / 64, *arguments, **options)

    def test_only_glare_and_strength(self):
        added = self.added(self.whole, self.channels)
        only = self.changed("--only-glare")
        triple = self.changed("--strength", 3, "--only-glare")
        self.assert_same_pixels(self.changed("--strength", 0), exr.read(self.path("in.exr")))
        for n in "RGB":
            self.assert_near(only.channels[n], added[n], FLOAT * LIGHT)
            self.assert_near(triple.channels[n], [3 * v for v in added[n]], 3 * FLOAT * LIGHT)
        self.assertLess(min(only.channels["G"]), 0)

    def test_exposure(self):
        brighter = self.changed("--exposure", 2)
        for n in "RGB":
            self.assert_near(brighter.channels[n], [4 * v for v in self.whole.channels[n]],
                             4 * FLOAT * LIGHT)

    def test_threshold(self):
        self.assert_same_pixels(self.changed("--threshold", 4000), exr.read(self.path("in.exr")))
        sharp = self.changed("--threshold", 500, "--knee", 0, "--only-glare")
        color = [self.channels[n][25 * 80 + 30] for n in "RGB"]
        luminance = sum(w * c for w, c in zip((0.212639, 0.715169, 0.072192), color))
        light = [c * (luminance - 500) / luminance for c in color]
        template = exr.read(self.path("t.exr"))
        alone = impulse(*self.SIZE, 30, 25, light)
        expected = with_kernel(alone, *self.SIZE, 30, 25, kernel(template), (64, 64))
        for n in "RGB":
            self.assert_near(sharp.channels[n], [e - a for e, a in zip(expected[n], alone[n])],
                             3 * FLOAT * LIGHT)

    def test_roll_off(self):
        """cos^2 towards the nearest border, 31.5 pixels from the axis; what it takes stays."""
        width = height = 150
        self.picture(impulse(width, height, 70, 71), width, height)
        plain = self.changed().channels
        for edge in ("black", "extend"):
            faded = self.changed("--roll-off", 0.4, "--edge", edge)
            self.assert_near(faded.sums(), [LIGHT] * 3, 10 * FLOAT * LIGHT)
            for n in "RGB":
                for i, (a, b) in enumerate(zip(plain[n], faded.channels[n])):
                    r = math.hypot(i % width - 70, i // width - 71) / 31
                    fade = min(max((r - 0.6) / 0.4, 0), 1)
                    if r > 0:
                        self.assertAlmostEqual(b, a * math.cos(math.pi / 2 * fade) ** 2,
                                               delta=FLOAT * LIGHT)
        self.picture(impulse(20, 9, 10, 4), 20, 9)  # Less than the kernel: the same shares.
        small = self.changed("--roll-off", 0.4).channels
        for n in "RGB":
            whole = [faded.channels[n][(71 - 4 + j) * width + 60 + i]
                     for j in range(9) for i in range(20)]
            self.assert_near(small[n], whole, 10 * FLOAT * LIGHT)
        for more in (("2",), ("nan",), ("0.5", "--sources", "auto")):
            self.assert_refused_for(2, ["--roll-off"], "--fov-deg", 2, "--roll-off", *more)

    def test_lamp_color(self):
        self.make("--lamp", "A", output="a.exr")
        self.picture(impulse(150, 140, 70, 71), 150, 140)
        white = self.changed(template="a.exr").sums()
        self.assert_near(white, [LIGHT] * 3, 10 * FLOAT * LIGHT)
        red, _, blue = self.changed("--lamp-color", "keep", template="a.exr").sums()
        self.assertGreater(red, 1.5 * LIGHT)
        self.assertLess(blue, 0.5 * LIGHT)


class BadPixels(ApplyTest):
    def test_are_told_and_stay_and_spread_nothing(self):
        width, height = 70, 60
        clean = impulse(width, height, 30, 30)
        bad = {n: list(v) for n, v in clean.items()}
        places = {100: math.nan, 2000: math.inf, 2001: -math.inf, 3003: -5.0, 4004: -1.0}
        for place, value in places.items():
            bad["R"][place] = value
        self.picture(clean, width, height, "clean.exr")
        self.picture(bad, width, height)
        expected = self.apply("--fov-deg", 2, picture="clean.exr")
        result = self.apply("--fov-deg", 2, warnings=1)
        for word in ("NaN: 1,", "infinite: 2,", "negative channel: 2"):
            self.assertIn(word, self.last.err)
        for n in "RGB":
            for i, (value, other) in enumerate(zip(result.channels[n], expected.channels[n])):
                if i not in places or n != "R":
                    if i in places and not math.isfinite(places[i]):
                        continue  # A pixel that isn't finite gets no light in any channel.
                    self.assertAlmostEqual(value, other, delta=FLOAT * LIGHT)
        self.assertTrue(math.isnan(result.channels["R"][100]))
        self.assertEqual(result.channels["R"][2000:2002].tolist(), [math.inf, -math.inf])
        for place in (3003, 4004):
            self.assertAlmostEqual(result.channels["R"][place],
                                   places[place] + expected.channels["R"][place],
                                   delta=FLOAT * LIGHT)
        self.apply("--fov-deg", 2, "--quiet")


class Sources(ApplyTest):
    """By points: the same to 0.1 % of the light that is added."""

    SIZE = (90, 64)
    SCALE = ("--pixel-deg", FOV_DEG / 64)

    def setUp(self):
        super().setUp()
        self.channels = black(*self.SIZE)
        for i in range(40):
            for k, n in enumerate("RGB"):
                self.channels[n][(i * 7919 + 13) % (90 * 64)] = 50.0 + 13 * i + 5 * k
        for i in range(0, 90 * 64, 3):
            self.channels["G"][i] += 0.002  # Far less than 0.05 % of the light.
        self.picture(self.channels, *self.SIZE)

    def assert_agrees(self, result, whole):
        for n in "RGB":
            worst = sum(abs(a - b) for a, b in zip(result.channels[n], whole.channels[n]))
            added = sum(abs(b - a) for a, b in zip(self.channels[n], whole.channels[n]))
            self.assertGreater(added, LIGHT)
            self.assertLessEqual(worst, 0.001 * added)

    def test_auto(self):
        for options in ((), ("--strength", 2, "--exposure", -1), ("--threshold", 100)):
            whole = self.apply(*self.SCALE, *options)
            points = self.apply(*self.SCALE, *options, "--sources", "auto", "--verbose")
            self.assertIn("points", self.last.err)
            self.assert_agrees(points, whole)
            self.assertTrue(points.channels != whole.channels)

    def test_auto_where_there_are_too_many(self):
        self.picture({n: [1.0] * (90 * 64) for n in "RGB"}, *self.SIZE)
        whole = self.apply(*self.SCALE)
        same = self.apply(*self.SCALE, "--sources", "auto", "--verbose")
        self.assertIn("convolved", self.last.err)
        self.assert_same_pixels(same, whole)

    def test_file(self):
        rows = [f"{i % 90}, {i // 90}, " + ", ".join(str(self.channels[n][i]) for n in "RGB")
                for i in range(90 * 64) if self.channels["B"][i] > 0]
        self.write("points.csv", "x_px,y_px,red,green,blue\n# a comment\n" + "\n".join(rows))
        self.assert_agrees(self.apply(*self.SCALE, "--sources", "points.csv"),
                           self.apply(*self.SCALE))

    def test_new_points_between_pixels(self):
        self.picture(black(*self.SIZE), *self.SIZE)
        self.write("points.csv", "45.25,30.5,100,200,300\n")
        result = self.apply(*self.SCALE, "--sources", "points.csv", "--new-sources")
        for n, light in zip("RGB", (100, 200, 300)):
            values = result.channels[n]
            total = sum(values)
            self.assertAlmostEqual(total, light, delta=0.06 * light)  # Some left the picture.
            center = [sum(v * (i % 90) for i, v in enumerate(values)) / total,
                      sum(v * (i // 90) for i, v in enumerate(values)) / total]
            # What left over the borders was not as far on one side as on the other.
            self.assertAlmostEqual(center[0], 45.25, delta=0.1)
            self.assertAlmostEqual(center[1], 30.5, delta=0.3)

    def test_errors(self):
        for row, words in (("1,2,3,4", ["points.csv:2", "five"]), ("1,2,3,4,x", ["points.csv:2"]),
                           ("1,2,3,-4,5", ["points.csv:2", "light"]),
                           ("1e9,2,3,4,5", ["points.csv:2", "place"]),
                           ("nan,2,3,4,5", ["points.csv:2", "place"]),
                           ("1,2,inf,4,5", ["points.csv:2", "light"]), ("", ["no rows"])):
            self.write("points.csv", "x_px,y_px,red,green,blue\n" + row + "\n")
            self.assert_refused_for(3, words, *self.SCALE, "--sources", "points.csv")
        self.assert_refused_for(3, ["none.csv"], *self.SCALE, "--sources", "none.csv")
        self.write("points.csv", "1,2,3,4,5\n")
        self.assert_refused_for(2, ["--new-sources"], *self.SCALE, "--sources", "auto",
                                "--new-sources")
        for more in (("--threshold", "2"), ("--edge", "extend")):
            self.assert_refused_for(2, [more[0]], *self.SCALE, "--sources", "points.csv", *more)


if __name__ == "__main__":
    unittest.main()
