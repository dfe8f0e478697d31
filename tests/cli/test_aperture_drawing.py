"""glare aperture eye and diaphragm: pictures that templates can be made of, and sequences."""

import json

import images
from cli import GlareTest

QUICK = ("--clear-media", "--size", "256")


def text_of(png, name):
    """The text of a tEXt chunk."""
    begin = png.index(b"tEXt" + name.encode() + b"\0") + 5 + len(name)
    size = int.from_bytes(png[begin - 9 - len(name):begin - 5 - len(name)], "big")
    return png[begin:begin + size - len(name) - 1].decode()


class Drawing(GlareTest):
    def drawn(self, kind, *arguments):
        result = self.glare("aperture", kind, *arguments)
        self.assertEqual((result.status, result.out, result.err), (0, "", ""))

    def content(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def test_pupil_and_lashes_make_a_template_without_a_width(self):
        self.drawn("eye", "--pupil-out", "p.exr", "--eyelashes-out", "e.png", *QUICK)
        result = self.glare("template", "--pupil", "p.exr", "--eyelashes", "e.png", "-o", "t.exr",
                            "--size", "64", "--fov-deg", "0.2")
        self.assertEqual((result.status, result.err), (0, ""))
        told = float(text_of(self.content("e.png"), "glare:apertureWidth_mm"))
        self.assertAlmostEqual(self.info("t.exr")["aperture_width_mm"], told, 5)

    def test_the_recipe_draws_it_again(self):
        self.drawn("eye", "-o", "a.png", "--seed", "7", "--upper-lashes", "60", *QUICK)
        recipe = json.loads(text_of(self.content("a.png"), "glare:recipe"))
        self.drawn("eye", *recipe["command"][3:], "-o", "b.png")
        self.assertEqual(self.content("a.png"), self.content("b.png"))
        self.drawn("eye", "-o", "c.png", "--seed", "8", "--upper-lashes", "60", *QUICK)
        self.assertNotEqual(self.content("a.png"), self.content("c.png"))

    def test_the_pupil_follows_from_the_luminance(self):
        # Watson and Yellott (2012): a wide, bright field at 30 years makes a small pupil.
        self.drawn("eye", "-o", "p.png", "--adapting-luminance-cd-m2", "1000", "--age", "30", *QUICK)
        options = json.loads(text_of(self.content("p.png"), "glare:recipe"))["command"]
        diameter = float(options[options.index("--pupil-mm") + 1])
        self.assertTrue(2 < diameter < 3, diameter)

    def test_diaphragm(self):
        self.drawn("diaphragm", "-o", "d.png", "--blades", "5", "--diameter-mm", "4", "--size", "128")
        self.assertEqual(images.png_size(self.content("d.png"))[:2], (128, 128))
        result = self.glare("template", "--pupil", "d.png", "-o", "t.exr", "--size", "64",
                            "--fov-deg", "0.2")
        self.assertEqual((result.status, result.err), (0, ""))

    def test_sequence(self):
        self.drawn("eye", "-o", "s_{frame}.png", "--frames", "3", "--fps", "1", *QUICK)
        frames = [self.content(f"s_000{i}.png") for i in (1, 2, 3)]
        self.assertEqual(len({bytes(frame) for frame in frames}), 3)
        self.assertEqual({images.png_size(frame)[:2] for frame in frames}, {(256, 256)})
        self.drawn("eye", "-o", "one.png", "--time-s", "2", *QUICK)
        self.assertEqual(self.content("one.png"), frames[2])

    def test_sequence_of_templates_has_one_scale(self):
        result = self.glare("template", "-o", "t_{frame}.exr", "--frames", "2", "--fps", "1",
                            "--clear-media", "--size", "32", "--fov-deg", "0.5")
        self.assertEqual((result.status, result.err), (0, ""))
        first, second = (self.info(f"t_000{i}.exr") for i in (1, 2))
        self.assertEqual(first["per_steradian"], second["per_steradian"])
        self.assertNotEqual(first["aperture_area_mm2"], second["aperture_area_mm2"])

    def test_closed_eye_is_black(self):
        result = self.glare("template", "-o", "t.exr", "--lid-opening-mm", "0.1", "--clear-media",
                            "--lid-share-above", "0", "--pupil-down-mm", "-1", "--pupil-mm", "1",
                            "--size", "16", "--fov-deg", "0.5", "--preview", "t.png")
        self.assertEqual((result.status, result.err), (0, ""))
        info = self.info("t.exr")
        self.assertEqual((info["captured_energy"], info["aperture_area_mm2"]), (0, 0))

    def test_bad_values(self):
        for mentions, arguments in (
                (["--output"], ["eye"]),
                ([".exr", ".png"], ["eye", "-o", "a.jpg"]),
                (["{frame}"], ["eye", "-o", "a.png", "--frames", "2"]),
                (["pupil"], ["eye", "-o", "a.png", "--pupil-mm", "0.5"]),
                (["age"], ["eye", "-o", "a.png", "--adapting-luminance-cd-m2", "1", "--age", "5"]),
                (["same name"], ["eye", "-o", "a.png", "--pupil-out", "./a.png"]),
                (["--size"], ["eye", "-o", "a.png", "--size", "70000"]),
                (["--pixel-um"], ["eye", "-o", "a.png", "--pixel-um", "0"]),
                (["blade_count"], ["diaphragm", "-o", "a.png", "--blades", "2"]),
                (["roundness"], ["diaphragm", "-o", "a.png", "--roundness", "nan"])):
            with self.subTest(arguments=arguments):
                self.assert_refused(2, mentions, "aperture", *arguments)
        self.assert_refused(2, ["--seed"], "template", "--pupil", "p.png", "--seed", "1", "-o",
                            "t.exr")
