"""glare photometry info: what files of every kind hold."""

import math
import pathlib
import re
import unittest

import exr
import images
from photometry import PhotometryTest, ies, ldt, span

DOCS = pathlib.Path(__file__).resolve().parents[2] / "docs" / "photometry.md"
SHIPPED = DOCS.parents[1] / "data" / "photometry"
KEYS = {"file", "format", "version", "photometric_type", "symmetry", "horizontal_angles_deg",
        "vertical_angles_deg", "total_flux_lm", "stated_flux_lm", "lamp_count", "lamp_flux_lm",
        "light_output_ratio", "absolute_photometry", "peak_intensity_cd", "peak_direction_deg",
        "beam_width_50_percent_deg", "beam_width_10_percent_deg", "at", "intensity_factor",
        "input_watts", "luminous_size_m", "tilt", "keywords", "warnings"}


class PhotometryInfo(PhotometryTest):
    def test_keys_are_these_and_documented(self):
        self.write("lamp.ies", ies("C", [0], span(0, 180, 10), lambda c, g: 100))
        self.assertEqual(self.told("lamp.ies").keys(), KEYS)
        text = DOCS.read_text(encoding="utf-8")
        for key in KEYS:
            self.assertIn(f"`{key}`", text)

    def test_an_isotropic_lamp(self):
        self.write("lamp.ies", ies("C", [0], span(0, 180, 10), lambda c, g: 100, lumens=2000))
        told = self.told("lamp.ies")
        self.assertEqual((told["format"], told["version"], told["photometric_type"],
                          told["symmetry"]),
                         ("IES LM-63", "IESNA:LM-63-2002", "C", "rotational"))
        self.assertEqual(told["vertical_angles_deg"], {"count": 19, "first": 0, "last": 180})
        # The integral of a constant between samples is exact.
        self.assertAlmostEqual(told["total_flux_lm"], 400 * math.pi, delta=1e-6)
        self.assertAlmostEqual(told["light_output_ratio"], 0.2 * math.pi, delta=1e-9)
        self.assertEqual(told["lamp_flux_lm"], 2000)
        self.assertEqual(told["peak_intensity_cd"], 100)
        self.assertEqual(told["beam_width_50_percent_deg"], [None, None])
        self.assertEqual(told["luminous_size_m"], [0.1, 0.2, 0])
        self.assertEqual(told["input_watts"], 10)
        self.assertIn({"name": "TEST", "text": "by hand"}, told["keywords"])

    def test_multiplier_and_ballast_factor(self):
        self.write("lamp.ies", ies("C", [0], [0, 90], lambda c, g: 100, factor=2.5, ballast=0.8))
        told = self.told("lamp.ies")
        self.assertEqual((told["peak_intensity_cd"], told["intensity_factor"]), (200, 2))

    def test_without_a_version_line(self):
        self.write("old.ies", ies("C", [0], [0, 90], lambda c, g: 100, version=""))
        told = self.told("old.ies")
        self.assertEqual((told["format"], told["version"]), ("IES LM-63", ""))

    def test_type_a_of_one_side(self):
        beam = lambda h, v: 1000 + 10 * h + v
        self.write("half.ies", ies("A", span(0, 40, 10), span(-20, 20, 10), beam))
        told = self.told("half.ies")
        self.assertEqual((told["photometric_type"], told["symmetry"]), ("A", "lateral"))
        self.assertEqual(told["horizontal_angles_deg"], {"count": 9, "first": -40, "last": 40})
        self.assert_close(self.intensities("half.ies", (15, 5), (-15, 5), (0, -20), (41, 0)),
                          [1155, 1155, 980, 0], 1e-6)

    def test_the_same_lamp_in_types_a_b_and_c(self):
        # About the forward axis, of the angle's cosine; C and gamma are of that axis too.
        cosine = lambda h, v: math.cos(math.radians(h)) * math.cos(math.radians(v))
        self.write("a.ies", ies("A", span(-90, 90, 2), span(-90, 90, 2), cosine, factor=1000))
        self.write("b.ies", ies("B", span(-90, 90, 2), span(-90, 90, 2), cosine, factor=1000))
        self.write("c.ies", ies("C", [0], span(0, 90, 2), lambda c, g: math.cos(math.radians(g)),
                                factor=1000))
        for name in ("a.ies", "b.ies", "c.ies"):
            told = self.told(name)
            # Steps of 2 degrees make the integral smaller by up to 2 x (2 deg)^2 / 12 = 2e-4.
            self.assertAlmostEqual(told["total_flux_lm"] / (1000 * math.pi), 1, delta=3e-4)
            for width in told["beam_width_50_percent_deg"]:
                self.assertAlmostEqual(width, 120, delta=0.1)

    def test_eulumdat_with_decimal_commas_and_several_sets(self):
        planes, gammas = span(0, 270, 90), [0.0, 22.5, 45.0, 90.0]
        rows = [[100.5, 80.25, 50.0, 0.0]]
        self.write("one.ldt", ldt(1, planes, gammas, rows, sets=((2, 4000),)))
        told = self.told("one.ldt", warnings=1)  # The step isn't 22.5 to the end.
        self.assertEqual((told["format"], told["photometric_type"], told["symmetry"]),
                         ("EULUMDAT", "C", "rotational"))
        self.assertEqual((told["lamp_count"], told["lamp_flux_lm"]), (2, 4000))
        self.assertAlmostEqual(told["peak_intensity_cd"], 402, delta=1e-6)
        self.write("two.ldt", ldt(1, planes, gammas[:3], [rows[0][:3]],
                                  sets=((1, 1000), (1, 3000))))
        self.assertAlmostEqual(self.told("two.ldt", warnings=1)["peak_intensity_cd"], 100.5)
        second = self.told("two.ldt", "--lamp-set", "2")
        self.assertAlmostEqual(second["peak_intensity_cd"], 301.5)
        self.assert_refused(2, ["set", "3"], "photometry", "info", "two.ldt", "--lamp-set", "3")

    def test_tilt(self):
        self.write("t.ies", ies("C", [0], [0, 90], lambda c, g: 1,
                                tilt="INCLUDE\n1\n3\n0 45 90\n1 0.9 0.8"))
        self.assertEqual(self.told("t.ies")["tilt"],
                         {"lamp_to_luminaire_geometry": 1, "angles_deg": [0, 45, 90],
                          "multipliers": [1, 0.9, 0.8]})

    def test_images(self):
        # 3 x 2 pixels: columns at H -10, 0, 10; the first row at V 5, the second at V -5.
        self.write("grid.exr", exr.encode({"Y": [100, 200, 300, 0, 50, 0]}, 3, 2))
        ranges = ("--h-deg", "-10", "10", "--v-deg", "-5", "5")
        told = self.told("grid.exr", *ranges, "--at", "10", "5", "--at", "-5", "0")
        self.assertEqual((told["format"], told["photometric_type"]), ("image", "A"))
        self.assertEqual(told["peak_direction_deg"], [10, 5])
        self.assertEqual([at["intensity_cd"] for at in told["at"]], [300, 87.5])
        self.assert_refused(2, ["--h-deg", "--v-deg"], "photometry", "info", "grid.exr")
        self.assert_refused(2, ["go together"], "photometry", "info", "grid.exr", *ranges[:3])
        self.write("grey.png", images.png([[255, 51], [0, 102]]))
        told = self.told("grey.png", *ranges, "--white-cd", "5000")
        self.assertAlmostEqual(told["peak_intensity_cd"], 5000, delta=1e-3)
        self.assert_refused(3, ["grey.png", "white"], "photometry", "info", "grey.png", *ranges)

    def test_directions_that_are_none(self):
        for angles in (("nan", "0"), ("0", "inf"), ("1e9", "0"), ("5",), ("a", "b")):
            self.assert_refused(2, ["--at"], "photometry", "info", SHIPPED / "hid_high.ies",
                                "--at", *angles)

    def test_text(self):
        result = self.glare("photometry", "info", SHIPPED / "halogen_high.ies", "--at", "0", "0")
        self.assertEqual((result.status, result.err), (0, ""))
        for words in ("photometric type      A", "symmetry              lateral", "73155 cd at H 0",
                      "absolute photometry", "58 W", "  LUMINAIRE"):
            self.assertIn(words, result.out)
        flux = float(re.search(r"total flux +([\d.]+) lm", result.out)[1])
        self.assertAlmostEqual(flux, 926, delta=1)  # As data/photometry/README.md tells.

    def test_control_characters_stay_in_the_file(self):
        lines = ("[OTHER] \x1b[31m red \x07",)
        self.write("c.ies", ies("C", [0], [0, 90], lambda c, g: 1, lines=lines))
        result = self.glare("photometry", "info", "c.ies")
        self.assertFalse([c for c in result.out if c != "\n" and (c < " " or c == "\x7f")])

    def test_warnings_can_be_silenced(self):
        self.write("w.ies", ies("C", [0], [0, 80], lambda c, g: 1))
        loud = self.glare("photometry", "info", "w.ies")
        quiet = self.glare("photometry", "info", "w.ies", "--quiet")
        self.assertEqual(len(loud.lines("warning")), 1)
        self.assertIn("w.ies", loud.err)
        self.assertEqual((quiet.status, quiet.err, quiet.out), (0, "", loud.out))


if __name__ == "__main__":
    unittest.main()
