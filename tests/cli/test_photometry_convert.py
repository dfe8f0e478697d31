"""glare photometry convert: intensities as an image, and back."""

import math
import pathlib
import signal
import subprocess
import time
import unittest

import exr
from cli import PROGRAM
from photometry import PhotometryTest, ies, span
from test_interruption import watches_for

SHIPPED = pathlib.Path(__file__).resolve().parents[2] / "data" / "photometry"
LOW = SHIPPED / "halogen_low_right_hand_traffic.ies"
GRID = ("--h-deg", "-50", "50", "--v-deg", "-15", "15", "--size", "201x61")


class Convert(PhotometryTest):
    def convert(self, file, *arguments, output="out.exr"):
        result = self.glare("photometry", "convert", file, "-o", output, *arguments)
        self.assertEqual((result.status, result.err, result.out), (0, "", ""))
        return exr.read(self.path(output))

    def test_pixels_are_candela_at_their_centres(self):
        picture = self.convert(LOW, *GRID)
        self.assertEqual((picture.size, set(picture.channels)), ((201, 61), {"Y"}))
        places = [(0, 0), (100, 30), (110, 34), (37, 50), (200, 60)]
        directions = [(-50 + column / 2, 15 - row / 2) for column, row in places]
        self.assert_close([picture.channels["Y"][row * 201 + column] for column, row in places],
                          self.intensities(LOW, *directions), 1e-6)  # 32-bit floats.

    def test_there_and_back(self):
        self.convert(LOW, *GRID)
        told = self.told("out.exr")
        self.assertEqual(told["format"], "image")
        self.assertEqual(told["horizontal_angles_deg"], {"count": 201, "first": -50, "last": 50})
        self.assertEqual(told["vertical_angles_deg"], {"count": 61, "first": -15, "last": 15})
        again = self.convert("out.exr", *GRID, output="again.exr")
        self.assert_same_pixels(exr.read(self.path("out.exr")), again, relative=1e-6)
        directions = [(h, v) for h in (-20.5, 0, 3.5) for v in (-4, -1.5, 0.5)]  # Pixels' centres.
        self.assert_close(self.intensities("out.exr", *directions),
                          self.intensities(LOW, *directions), 1e-6)

    def test_whole_hemisphere_by_default(self):
        # Both are what bilinear interpolation makes of the same values, but for steps of 0.1
        # degrees that don't hit each measured angle.
        beam = SHIPPED / "hid_high.ies"
        self.assertEqual(self.glare("photometry", "convert", beam, "-o", "out.exr").status, 0)
        told = self.told("out.exr")
        for name in ("horizontal_angles_deg", "vertical_angles_deg"):
            self.assertEqual(told[name], {"count": 1801, "first": -90, "last": 90})
        self.assertAlmostEqual(told["total_flux_lm"] / self.told(beam)["total_flux_lm"], 1,
                               delta=1e-4)

    def test_mounting(self):
        self.write("spot.ies", ies("A", span(-60, 60, 1), span(-60, 60, 1), lambda h, v: 1000
                                   * math.exp(-((h - 4) / 5) ** 2 - (v / 5) ** 2)))
        grid = ("--h-deg", "-30", "30", "--v-deg", "-30", "30", "--size", "61")
        for options, direction in ((("--yaw-deg", "10"), [14, 0]),
                                   (("--pitch-deg", "-7"), [4, -7]),
                                   (("--roll-deg", "90"), [0, -4])):
            self.convert("spot.ies", *grid, *options)
            peak = self.told("out.exr")["peak_direction_deg"]
            self.assert_close([x + 100 for x in peak], [x + 100 for x in direction], 1e-9)

    def test_where_gamma_zero_is(self):
        self.write("c.ies", ies("C", [0], span(0, 180, 5), lambda c, g: 180 - g))
        self.convert("c.ies", "--size", "37", "--gamma-zero", "forward")
        self.assertEqual(self.told("out.exr")["peak_direction_deg"], [0, 0])
        self.convert("c.ies", "--size", "37")
        self.assertEqual(self.told("out.exr")["peak_direction_deg"][1], -90)
        self.assert_refused(2, ["--gamma-zero", "type A"], "photometry", "convert", LOW, "-o",
                            "a.exr", "--gamma-zero", "down")

    def test_dim_and_dark_images_come_back(self):
        for candela in (0.5, 0):
            self.write("dim.ies", ies("A", [-10, 10], [-10, 10], lambda h, v, cd=candela: cd))
            self.convert("dim.ies", *GRID)
            self.assertEqual(self.told("out.exr")["peak_intensity_cd"], candela)
            self.glare("photometry", "info", "out.exr", "--plot", "plot.svg")
            self.assertTrue(self.path("plot.svg").exists())

    def test_interrupted(self):
        self.write("out.exr", "old")
        before = self.files()
        with subprocess.Popen([PROGRAM, "photometry", "convert", LOW, "-o", "out.exr", "--size",
                               "6000"], cwd=self.folder, stderr=subprocess.PIPE) as process:
            end = time.monotonic() + 15
            while not watches_for(signal.SIGINT, process.pid) and time.monotonic() < end:
                time.sleep(0.01)
            process.send_signal(signal.SIGINT)
            _, err = process.communicate(timeout=60)
        self.assertEqual((process.returncode, err), (130, b""))
        self.assertEqual(self.files(), before)

    def test_the_same_bytes_each_time(self):
        self.convert(LOW, *GRID)
        self.convert(LOW, *GRID, output="again.exr")
        self.assertEqual(self.path("out.exr").read_bytes(), self.path("again.exr").read_bytes())

    def test_images_without_degrees_need_them(self):
        self.write("grid.exr", exr.encode({"Y": [100, 200, 300, 0, 50, 0]}, 3, 2))
        picture = self.convert("grid.exr", "--input-h-deg", "-10", "10", "--input-v-deg", "-5", "5",
                               "--h-deg", "-5", "5", "--v-deg", "-5", "5", "--size", "3x2")
        self.assert_close(picture.channels["Y"], [150, 200, 250, 25, 50, 25], 1e-6)
        self.assert_refused(2, ["--input-h-deg"], "photometry", "convert", "grid.exr", "-o",
                            "a.exr", *GRID)

    def test_refused(self):
        self.write("in.exr", self.path("pupil.png").read_bytes())
        self.write("bad.ies", "TILT=NONE\n1 2\n")
        for status, words, arguments in (
                (2, ["input"], (LOW, "-o", LOW)),
                (2, [".exr"], (LOW, "-o", "out.png")),
                (2, ["input"], ("in.exr", "-o", "./in.exr")),
                (2, ["--size"], (LOW, "-o", "out.exr", "--size", "0x5")),
                (2, ["ascending"], (LOW, "-o", "out.exr", "--h-deg", "5", "-5")),
                (2, ["--v-deg"], (LOW, "-o", "out.exr", "--v-deg", "5")),
                (2, ["within -90 to 90"], (LOW, "-o", "out.exr", "--v-deg", "-100", "0")),
                (2, ["no image"], (LOW, "-o", "out.exr", "--white-cd", "5")),
                (2, ["--lamp-set"], (LOW, "-o", "out.exr", "--lamp-set", "1")),
                (2, ["--yaw-deg"], (LOW, "-o", "out.exr", "--yaw-deg", "400")),
                (2, ["--roll-deg"], (LOW, "-o", "out.exr", "--roll-deg", "nan")),
                (2, ["ascending"], (LOW, "-o", "out.exr", "--h-deg", "nan", "5")),
                (3, ["bad.ies:2"], ("bad.ies", "-o", "out.exr")),
                (3, ["no such file"], ("nothing.ies", "-o", "out.exr")),
                (4, ["folder"], (LOW, "-o", "nowhere/out.exr"))):
            with self.subTest(words):
                self.assert_refused(status, words, "photometry", "convert", *arguments)


if __name__ == "__main__":
    unittest.main()
