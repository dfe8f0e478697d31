"""glare template: aberrations and the Stiles-Crawford effect."""

import json

from cli import GlareTest

TABLE = "pupil_diameter_mm,0.6\nj,coefficient_um\n8,0.2\n4,-0.1\n"
ALL = ("--defocus-d", "-0.5", "--zernike", "eye.csv", "--chromatic-aberration", "--focused-nm",
       "550", "--stiles-crawford", "--stiles-crawford-rho-per-mm2", "0.06",
       "--stiles-crawford-peak-mm", "0.1", "-0.05")


class Optics(GlareTest):
    def setUp(self):
        super().setUp()
        self.write("eye.csv", TABLE)

    def test_the_recipe_makes_the_same_file_again(self):
        picture = self.make(*ALL)
        recipe = json.loads(picture.attributes["glare:recipe"])
        self.assertEqual([i["file"] for i in recipe["inputs"]], ["pupil.png", "eye.csv"])
        result = self.glare(*recipe["command"][1:], "-o", "again.exr")
        self.assertEqual((result.status, result.err), (0, ""))
        self.assertEqual(self.path("again.exr").read_bytes(), self.path("out.exr").read_bytes())
        for word in ("-0.5 D", "8:0.2", "550 nm", "0.06"):
            self.assertIn(word, picture.attributes["glare:aberrations"])

    def test_without_there_is_no_attribute(self):
        self.assertNotIn("glare:aberrations", self.make().attributes)

    def test_defocus_dims_the_peak_and_stiles_crawford_alone_hardly(self):
        plain = self.make("--normalize", "absolute").channels["G"]
        blurred = self.make("--normalize", "absolute", "--defocus-d", "-5").channels["G"]
        weighed = self.make("--normalize", "absolute", "--stiles-crawford").channels["G"]
        self.assertLess(max(blurred), 0.9 * max(plain))
        self.assertNotEqual(max(weighed), max(plain))
        self.assertAlmostEqual(max(weighed) / max(plain), 1, delta=0.02)

    def test_several_lamps_are_as_alone(self):
        result = self.glare("template", "-o", "m_{lamp}.exr", "--lamp", "A", "--lamp", "hid",
                            "--defocus-d", "2", "--pupil", "pupil.png", "--width-mm", "0.5",
                            "--size", "64", "--fov-deg", "2")
        self.assertEqual(result.status, 0, result.err)
        self.make("--lamp", "hid", "--defocus-d", "2")
        self.assertEqual(self.path("m_hid.exr").read_bytes(), self.path("out.exr").read_bytes())

    def test_refusals(self):
        self.assert_template_refused(2, ["defocus", "51"], "--defocus-d", "51")
        self.assert_template_refused(2, ["stiles-crawford"], "--stiles-crawford-rho-per-mm2", "0.1")
        self.assert_template_refused(2, ["rho", "2"], "--stiles-crawford",
                                     "--stiles-crawford-rho-per-mm2", "2")
        self.assert_template_refused(3, ["no.csv"], "--zernike", "no.csv")
        self.write("bad.csv", "pupil_diameter_mm,6\n4,0.1\n4,0.2\n")
        self.assert_template_refused(3, ["bad.csv:3", "already"], "--zernike", "bad.csv")
        self.write("narrow.csv", "pupil_diameter_mm,0.2\n4,0.1\n")
        self.assert_template_refused(2, ["0.2 mm", "open"], "--zernike", "narrow.csv")
        self.write("steep.csv", "pupil_diameter_mm,0.6\n4,50\n")
        self.assert_template_refused(2, ["pixel", "um"], "--zernike", "steep.csv")
