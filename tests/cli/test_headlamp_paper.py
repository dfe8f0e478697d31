"""The paper's mode of glare headlamp: relative luminance times the template, and its curve."""

import math
import struct
import unittest

import images
from headlamps import ADDED, HeadlampTest


def rgb16(data):
    """The pixels of a 16-bit RGB PNG file, in 0 to 1."""
    width, height, bits, kind, raw = images.png_size(data)
    assert (bits, kind) == (16, images.RGB)
    step, line, rows = 6, 6 * width, []
    above = bytes(line)
    for y in range(height):
        start = y * (line + 1)
        row, kind = bytearray(raw[start + 1:start + 1 + line]), raw[start]
        for i in range(line):
            a = row[i - step] if i >= step else 0
            c = above[i - step] if i >= step else 0
            b = above[i]
            nearest = min((abs(b - c), 0, a), (abs(a - c), 1, b), (abs(a + b - 2 * c), 2, c))[2]
            row[i] = (row[i] + (0, a, b, (a + b) // 2, nearest)[kind]) & 255
        rows.append(above := bytes(row))
    values = [v / 65535 for row in rows for v in struct.unpack(f">{3 * width}H", row)]
    return width, height, list(zip(values[0::3], values[1::3], values[2::3]))


class Paper(HeadlampTest):
    def relative(self, column, row, luminance):
        """L0 times the template, whose brightest pixel is 1."""
        width, height = self.template.size
        at = (row + height // 2) * width + column + width // 2
        peak = max(self.template.luminance())
        return [luminance * self.template.channels[c][at] / peak for c in "RGB"]

    def dark_scene(self, lamps=None, **tables):
        fov = 2 * math.degrees(math.atan(65 / 2 * self.pitch()))
        self.scene(lamps=lamps, background={"size_px": [65, 49], "horizontal_fov_deg": fov},
                   **tables)

    def test_relative_luminance(self):
        self.dark_scene(mode="paper", paper={"reference_intensity_cd": 40000})
        added = self.added(self.picture(), background=0)
        for place in ((0, 0), (2, 3)):
            self.assert_close(added(32 + place[0], 24 + place[1]), self.relative(*place, 0.25),
                              ADDED)
        row, = self.report()
        self.assertEqual(row["relative_luminance"], 0.25)

    def test_distance_does_not_matter(self):
        for distance in (10, 1000):
            self.dark_scene([{"position_m": [0, 0, distance]}])
            self.run_headlamp("--mode", "paper", "-o", f"{distance}.exr")
        self.assertEqual(self.path("10.exr").read_bytes(), self.path("1000.exr").read_bytes())

    def test_ways_to_tell_it(self):
        self.dark_scene([{"position_m": [0, 0, 50]},
                         {"position_m": [1, 0, 50], "intensity_cd": 500},
                         {"position_m": [2, 0, 50], "relative_luminance": 7}])
        rows = self.report("--mode", "paper")
        self.assertEqual([row["relative_luminance"] for row in rows], [1000, 50, 7])
        rows = self.report("--mode", "paper", "--l0", "3")
        self.assertEqual([row["relative_luminance"] for row in rows], [3, 3, 3])

    def test_curve(self):
        self.dark_scene(mode="paper", tone_mapping={"gamma": 0.8})
        self.run_headlamp("-o", "p.png", "--bits", "16", "--l0", "0.002")
        width, _, pixels = rgb16(self.path("p.png").read_bytes())
        linear = self.added(self.picture("--l0", "0.002"), background=0)
        for place in ((32, 24), (33, 24), (35, 29), (0, 0)):
            for light, shown in zip(linear(*place), pixels[place[1] * width + place[0]]):
                x = (max(light, 0) / 3e-4)**0.8
                # 5e-5 is the library's bound of its curve; half a step of 16 bits.
                self.assertAlmostEqual(shown, (x + 1 / 16) / (x + 16), delta=6e-5)

    def test_curve_of_the_mode_in_cd_m2(self):
        """One curve for the luminance, L_wa the background's mean, encoded for sRGB."""
        self.scene(lamps=[{"position_m": [0, 0, 50], "intensity_cd": 0}])
        self.run_headlamp("-o", "p.png", "--bits", "16")
        grey = (1 + 1 / 16) / (1 + 16)
        encoded = 1.055 * grey**(1 / 2.4) - 0.055
        _, _, pixels = rgb16(self.path("p.png").read_bytes())
        for value in pixels[0]:
            self.assertAlmostEqual(value, encoded, delta=1e-4)

    def test_l0_is_of_the_papers_mode(self):
        self.dark_scene()
        self.assert_refused(2, ["--l0", "paper"], "headlamp", "scene.toml", "-o", "a.png", "--l0",
                            1)


if __name__ == "__main__":
    unittest.main()
