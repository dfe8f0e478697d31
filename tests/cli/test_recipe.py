"""The recipe in a template: its command makes the same file again."""

import hashlib
import json

import images
from cli import APERTURE, SMALL, GlareTest



class Recipe(GlareTest):
    def remade(self, recipe, output, **options):
        command = recipe["command"]
        self.assertEqual(command[:2], ["glare", "template"])
        result = self.glare(*command[1:], "-o", output, **options)
        self.assertEqual(result.status, 0, result.err)
        return self.path(output).read_bytes()

    def check(self, *arguments, aperture=APERTURE, size=SMALL):
        picture = self.make(*arguments, aperture=aperture, size=size)
        recipe = json.loads(picture.attributes["glare:recipe"])
        self.assertEqual(self.remade(recipe, "again.exr"), self.path("out.exr").read_bytes())
        return recipe

    def test_defaults_are_in_it(self):
        recipe = self.check(aperture=(), size=("--size", "32"))
        text = " ".join(recipe["command"])
        for option in ("--pupil-mm 6.5", "--seed 1", "--lamp D65", "--observer cie1931-2deg",
                       "--wavelength-range-nm 380 780", "--size 32", "--fov-deg 5",
                       "--colorspace lin_rec709", "--white none", "--normalize peak",
                       "--gamut keep"):
            self.assertIn(option, text)
        self.assertEqual(recipe["inputs"], [])

    def test_every_option_makes_the_same_file_again(self):
        self.write("lamp.csv", "nm,power\n400,1\n550,3.25\n760,2\n")
        self.write("lashes.png", images.png(images.constant(64, 64, 250)))
        recipe = self.check(
            "--eyelashes", "lashes.png", "--lamp", "lamp.csv", "--observer", "cie1964-10deg",
            "--wavelength-range-nm", "400.5", "700.125", "--size", "40x30", "--fov-deg",
            "1.2345678901234567", "--colorspace", "acescg", "--white", "lamp", "--normalize",
            "energy", "--gamut", "desaturate", size=())
        for text in ("1.2345678901234567", "700.125", "40x30", "lashes.png", "acescg"):
            self.assertIn(text, recipe["command"])
        self.assertEqual({i["file"]: i["sha256"] for i in recipe["inputs"]},
                         {n: hashlib.sha256(self.path(n).read_bytes()).hexdigest()
                          for n in ("pupil.png", "lashes.png", "lamp.csv")})
        self.assertEqual({i["option"] for i in recipe["inputs"]},
                         {"--pupil", "--eyelashes", "--lamp"})

    def test_half_eye_and_black_body(self):
        self.check("--half", "--lamp", "blackbody:3200", "--pupil-mm", "2.5", "--seed",
                   "18446744073709551615", "--quiet", aperture=(), size=("--size", "32"))

    def test_file_names_that_look_like_options(self):
        self.write("-pupil x.png", self.path("pupil.png").read_bytes())
        self.write("-lamp.csv", "400,1\n760,2\n")
        self.check("--lamp=-lamp.csv", aperture=("--pupil=-pupil x.png", "--width-mm", "0.5"))

    def test_a_lamp_file_named_like_a_lamp(self):
        self.write("D65", "400,1\n760,20\n")
        self.check("--lamp", "./D65")

    def test_unicode_file_names(self):
        self.write("Auge – глаз.png", self.path("pupil.png").read_bytes())
        recipe = self.check(aperture=("--pupil", "Auge – глаз.png", "--width-mm", "0.5"))
        self.assertEqual(recipe["inputs"][0]["file"], "Auge – глаз.png")
