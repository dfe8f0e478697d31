"""The file that glare template writes: attributes, sizes, normalisations."""

import math

import images
from cli import GlareTest


FLOAT_SUM = 1e-5  # Sums of up to 1e4 pixels, each rounded to 24 bits and scattered in sign.


def solid_angle(picture):
    return math.radians(picture.attributes["glare:pixelPitch_deg"]) ** 2


class File(GlareTest):
    TYPES = {
        "chromaticities": "chromaticities", "glare:formatVersion": "int",
        "glare:pixelPitch_deg": "float", "glare:center_px": "v2f", "glare:colorSpace": "string",
        "glare:normalization": "string", "glare:perSteradian": "float",
        "glare:capturedEnergy": "float", "glare:lampXYZ": "v3f",
        "glare:lightXYZ": "v3f", "glare:lamp": "string",
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
            # The CIE sums from 360 to 830 nm, and in steps.
            self.assertAlmostEqual(value, expected, delta=1e-3)

    def test_attributes_of_the_aperture(self):
        a = self.make().attributes
        self.assertEqual(a["glare:apertureWidth_mm"], 0.5)
        open_pixels = sum(v == 255 for row in images.disc(64) for v in row)
        self.assertAlmostEqual(a["glare:apertureArea_mm2"], open_pixels * (0.5 / 64) ** 2,
                               delta=1e-7)

    def test_software_is_what_version_says(self):
        version = self.glare("--version").out.strip()
        self.assertEqual(self.make().attributes["glare:software"], version)

    def test_float_by_default_and_half_on_request(self):
        whole = self.make()
        half = self.make("--half", output="half.exr", warnings=1)
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
