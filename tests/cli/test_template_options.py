"""glare template: what each option does to the picture and its numbers."""

import hashlib
import json
import math
import unittest

import images
from cli import APERTURE, SMALL, GlareTest

FLOAT_SUM = 1e-5  # Sums of up to 1e4 pixels, each rounded to 24 bits and scattered in sign.


def solid_angle(picture):
    return math.radians(picture.attributes["glare:pixelPitch_deg"]) ** 2


class File(GlareTest):
    TYPES = {
        "chromaticities": "chromaticities", "glare:formatVersion": "int",
        "glare:pixelPitch_deg": "float", "glare:center_px": "v2f", "glare:colorSpace": "string",
        "glare:normalization": "string", "glare:perSteradian": "float",
        "glare:capturedEnergy": "float", "glare:lampXYZ": "v3f", "glare:lamp": "string",
        "glare:observer": "string", "glare:wavelengthRange_nm": "v2f",
        "glare:apertureWidth_mm": "float", "glare:apertureArea_mm2": "float",
        "glare:recipe": "string", "glare:software": "string"}

    def test_every_attribute_has_its_type(self):
        picture = self.make()
        self.assertEqual({n: picture.types.get(n) for n in self.TYPES}, self.TYPES)

    def test_attributes_of_the_picture(self):
        a = self.make("--size", "80x50", size=("--fov-deg", "2")).attributes
        self.assertEqual(a["glare:formatVersion"], 1)
        self.assertAlmostEqual(a["glare:pixelPitch_deg"], 2 / 80, delta=1e-8)
        self.assertEqual(a["glare:center_px"], (40, 25))
        self.assertEqual(a["glare:colorSpace"], "lin_rec709")
        self.assertEqual(a["glare:normalization"], "peak")
        self.assertTrue(0.5 < a["glare:capturedEnergy"] < 1)
        self.assertEqual(a["compression"], 3)

    def test_attributes_of_the_light(self):
        a = self.make().attributes
        self.assertEqual((a["glare:lamp"], a["glare:observer"]), ("D65", "cie1931-2deg"))
        self.assertEqual(a["glare:wavelengthRange_nm"], (380, 780))
        for value, expected in zip(a["glare:lampXYZ"], (0.9504, 1, 1.0888)):
            self.assertAlmostEqual(value, expected, delta=1e-3)  # CIE's tables to 360 nm and 830 nm.

    def test_attributes_of_the_aperture(self):
        a = self.make().attributes
        self.assertEqual(a["glare:apertureWidth_mm"], 0.5)
        open_pixels = sum(v == 255 for row in images.disc(64) for v in row)
        self.assertAlmostEqual(a["glare:apertureArea_mm2"], open_pixels * (0.5 / 64) ** 2, delta=1e-7)

    def test_software_is_what_version_says(self):
        version = self.glare("--version").out.strip()
        self.assertEqual(self.make().attributes["glare:software"], version)

    def test_float_by_default_and_half_on_request(self):
        whole = self.make()
        half = self.make("--half", output="half.exr", warnings=len(self.last.lines("warning")))
        self.assertEqual(set(whole.channel_types.values()), {"float"})
        self.assertEqual(set(half.channel_types.values()), {"half"})
        for name, values in whole.channels.items():
            for a, b in zip(values, half.channels[name]):
                self.assertLessEqual(abs(a - b), abs(a) * 2 ** -11 + 2 ** -25)

    def test_half_that_overflows_is_refused(self):
        self.assert_template_refused(2, ["half"], "--half", "--normalize", "absolute")

    def test_half_that_loses_the_dark_warns(self):
        eye = self.make("--half", "--normalize", "energy", aperture=(), size=("--size", "64"),
                        warnings=1)
        self.assertIn("half", self.last.err)
        self.assertEqual(eye.channel_types["R"], "half")


class Size(GlareTest):
    def test_odd_and_oblong_sizes(self):
        for text, size in (("33", (33, 33)), ("65x32", (65, 32)), ("32x65", (32, 65)),
                           ("1", (1, 1)), ("1x7", (1, 7)), ("2x1", (2, 1))):
            picture = self.make("--size", text, size=("--fov-deg", "0.2"))
            self.assertEqual(picture.size, size)
            self.assertEqual(picture.attributes["glare:center_px"], (size[0] // 2, size[1] // 2))

    def test_the_axis_is_the_brightest_pixel(self):
        for text in ("64x48", "65x49"):
            picture = self.make("--size", text, size=("--fov-deg", "2"))
            luminance = picture.luminance()
            width, height = picture.size
            self.assertEqual(luminance.index(max(luminance)), height // 2 * width + width // 2)

    def test_a_larger_picture_of_the_same_pitch_holds_the_smaller(self):
        small = self.make("--normalize", "absolute", "--size", "32x32", "--fov-deg", "1", size=())
        large = self.make("--normalize", "absolute", "--size", "64x48", "--fov-deg", "2", size=())
        for y in range(32):
            for x in range(32):
                a = small.channels["G"][y * 32 + x]
                b = large.channels["G"][(y + 8) * 64 + x + 16]
                self.assertLessEqual(abs(a - b), 2e-3 * abs(a) + 1e-6 * max(small.channels["G"]))

    def test_right_and_down_are_those_of_the_aperture(self):
        """A slit that is longer down spreads its light sideways."""
        slit = [[255 if 28 <= x < 36 and 4 <= y < 60 else 0 for x in range(64)] for y in range(64)]
        self.write("pupil.png", images.png(slit))
        luminance = self.make().luminance()
        along_x = sum(luminance[32 * 64 + x] for x in range(40, 64))
        along_y = sum(luminance[y * 64 + 32] for y in range(40, 64))
        self.assertGreater(along_x, 10 * along_y)


class Normalization(GlareTest):
    def setUp(self):
        super().setUp()
        self.pictures = {n: self.make("--normalize", n, output=n + ".exr")
                         for n in ("peak", "energy", "absolute")}

    def test_each_is_named(self):
        for name, picture in self.pictures.items():
            self.assertEqual(picture.attributes["glare:normalization"], name)

    def test_each_sum_and_peak(self):
        self.assertAlmostEqual(max(self.pictures["peak"].luminance()), 1, delta=1e-6)
        self.assertAlmostEqual(sum(self.pictures["energy"].luminance()), 1, delta=FLOAT_SUM)
        self.assertEqual(self.pictures["absolute"].attributes["glare:perSteradian"], 1)

    def test_each_leads_back_to_absolute(self):
        absolute = self.pictures["absolute"].luminance()
        for picture in self.pictures.values():
            factor = picture.attributes["glare:perSteradian"]
            for a, b in zip(absolute, picture.luminance()):
                self.assertAlmostEqual(a, b * factor, delta=1e-6 * max(absolute))

    def test_captured_energy_is_the_light_on_the_pixels(self):
        for picture in self.pictures.values():
            a = picture.attributes
            energy = sum(picture.luminance()) * a["glare:perSteradian"] * solid_angle(picture)
            self.assertAlmostEqual(energy, a["glare:capturedEnergy"], delta=FLOAT_SUM)


class Aperture(GlareTest):
    def test_eyelashes_and_pupil_multiply(self):
        lashes = [[0 if x % 16 == 5 else 255 for x in range(64)] for y in range(64)]
        both = [[p * (l > 0) for p, l in zip(*rows)] for rows in zip(images.disc(64), lashes)]
        self.write("lashes.png", images.png(lashes))
        self.write("both.png", images.png(both))
        stacked = self.make("--eyelashes", "lashes.png")
        for option in ("--pupil", "--eyelashes"):
            self.assert_same_pixels(
                stacked, self.make(aperture=(option, "both.png", "--width-mm", "0.5")))

    def test_different_pixel_counts_of_the_same_shape(self):
        self.write("lashes.png", images.png(images.constant(32, 32, 255)))
        self.assert_same_pixels(self.make(), self.make("--eyelashes", "lashes.png"), 1e-6)

    def test_different_shapes_are_refused(self):
        self.write("lashes.png", images.png(images.constant(64, 32, 255)))
        self.assert_template_refused(3, ["shape", "64 x 32"], "--eyelashes", "lashes.png")

    def test_width_scales_the_field(self):
        """Twice the width, half the angle: the same picture."""
        narrow = self.make("--width-mm", "0.5", "--fov-deg", "2", "--size", "64",
                           aperture=("--pupil", "pupil.png"), size=())
        wide = self.make("--width-mm", "1", "--fov-deg", "1", "--size", "64",
                         aperture=("--pupil", "pupil.png"), size=())
        self.assert_same_pixels(narrow, wide, 1e-5)

    def test_an_image_needs_a_width_and_a_width_an_image(self):
        self.assert_template_refused(2, ["--width-mm"], aperture=("--pupil", "pupil.png"))
        self.assert_template_refused(2, ["--width-mm"], aperture=("--width-mm", "8"))

    def test_an_empty_file_name_is_no_missing_option(self):
        """A script's empty variable must not lead to the built-in eye."""
        for option in ("--pupil", "--eyelashes"):
            self.assert_template_refused(2, [option], option, "", aperture=())
        for option in ("--preview", "--ocio"):
            self.assert_template_refused(2, [option], option, "")

    def test_built_in_eye(self):
        size = ("--size", "64", "--fov-deg", "1")
        eye = self.make(aperture=(), size=size)
        self.assert_same_pixels(eye, self.make("--pupil-mm", "6.5", "--seed", "1", aperture=(),
                                               size=size))
        other_lashes = self.make("--seed", "2", aperture=(), size=size)
        self.assertNotEqual(eye.channels["G"], other_lashes.channels["G"])
        smaller = self.make("--pupil-mm", "3", aperture=(), size=size)
        self.assertLess(smaller.attributes["glare:apertureArea_mm2"], math.pi * 1.5 ** 2)
        self.assertAlmostEqual(smaller.attributes["glare:apertureWidth_mm"], 3.12, delta=0.1)

    def test_built_in_eye_and_images_exclude_each_other(self):
        for option in ("--pupil-mm", "--seed"):
            self.assert_template_refused(2, [option], option, "3")


class Light(GlareTest):
    def test_every_observer(self):
        seen = set()
        for observer in ("cie1931-2deg", "cie1964-10deg", "cie2015-2deg", "cie2015-10deg"):
            picture = self.make("--observer", observer)
            self.assertEqual(picture.attributes["glare:observer"], observer)
            seen.add(picture.attributes["glare:lampXYZ"])
        self.assertEqual(len(seen), 4)

    def test_wavelength_range(self):
        red = self.make("--wavelength-range-nm", "650", "700").attributes
        self.assertEqual(red["glare:wavelengthRange_nm"], (650, 700))
        x, y, z = red["glare:lampXYZ"]
        self.assertGreater(x, 2)  # The red end: x = 0.72, y = 0.28.
        self.assertLess(z, 0.01)

    def test_range_beyond_the_tables_is_what_they_cover(self):
        a = self.make("--wavelength-range-nm", "100", "2000", "--fov-deg", "1").attributes
        self.assertEqual(a["glare:wavelengthRange_nm"], (360, 830))

    def test_white_lamp_makes_the_sum_white(self):
        for space in ("lin_rec709", "acescg", "lin_rec2020"):
            red, green, blue = self.make("--lamp", "A", "--white", "lamp", "--colorspace", space,
                                         "--size", "128", "--fov-deg", "2.7", size=()).sums()
            # What falls outside the picture is redder than what falls inside, by some percent.
            self.assertAlmostEqual(red / green, 1, delta=0.04)
            self.assertAlmostEqual(blue / green, 1, delta=0.04)

    def test_white_lamp_leaves_the_file_the_lamps_own_colour(self):
        plain, white = self.make("--lamp", "A"), self.make("--lamp", "A", "--white", "lamp")
        self.assertEqual(plain.attributes["glare:lampXYZ"], white.attributes["glare:lampXYZ"])
        self.assertGreater(plain.sums()[0], 1.5 * plain.sums()[2])

    def test_desaturate_keeps_luminance_and_leaves_no_negative(self):
        light = ("--lamp", "HP1", "--normalize", "absolute")
        keep, mapped = self.make(*light), self.make(*light, "--gamut", "desaturate")
        self.assertLess(min(map(min, keep.channels.values())), 0)
        self.assertGreaterEqual(min(map(min, mapped.channels.values())), 0)
        for a, b in zip(keep.luminance(), mapped.luminance()):
            self.assertAlmostEqual(a, b, delta=1e-6 * a + 1e-12)


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


if __name__ == "__main__":
    unittest.main()
