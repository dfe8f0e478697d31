"""glare template: observer, wavelengths, white and gamut."""

from cli import GlareTest



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
        a = self.make("--wavelength-range-nm", "100", "2000", "--lamp",
                      "blackbody:3000").attributes
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
