"""Pictures of every kind that hold the same aperture give the same template."""

import exr
import images
from cli import GlareTest


class Formats(GlareTest):
    def aperture(self, name, data):
        self.write(name, data)
        return ("--pupil", name, "--width-mm", "0.5")

    def test_formats_agree(self):
        disc = images.disc(64)
        share = images.mapped(disc, lambda v: v / 255)
        wide = images.mapped(disc, lambda v: v * 257)
        plain = self.make()
        for name, data in {
                "grey16.png": images.png(wide, 16), "rgb.png": images.png(
                    images.mapped(disc, lambda v: (v, v, v)), kind=images.RGB),
                "rgba.png": images.png(images.mapped(disc, lambda v: (v, v, v, 255)),
                                       kind=images.RGBA),
                "palette.png": images.png(images.mapped(disc, lambda v: int(v > 0)),
                                          kind=images.PALETTE, palette=((0,) * 3, (255,) * 3)),
                "8.pgm": images.pgm(disc), "16.pgm": images.pgm(wide, 65535),
                "100.pgm": images.pgm(images.mapped(disc, lambda v: 100 * (v > 0)), 100),
                "f.pfm": images.pfm(share), "24.bmp": images.bmp(disc), "8.tif": images.tiff(disc),
                "16.tif": images.tiff(wide, "H"), "f.tif": images.tiff(share, "f"),
                "y.exr": exr.encode({"Y": images.flat(share)}, 64, 64),
                "rgb.exr": exr.encode({c: images.flat(share) for c in "RGB"}, 64, 64),
                "content_tells.txt": images.png(disc)}.items():
            with self.subTest(name):
                # 1e-6: the luminance weights of three equal channels sum to 1 but for rounding.
                self.assert_same_pixels(plain, self.make(
                    "--quiet", aperture=self.aperture(name, data)), 1e-6)

    def test_values_are_used_as_stored(self):
        """No sRGB decoding: half of 255 lets a quarter of the light through."""
        full, half = (self.make("--normalize", "absolute", aperture=self.aperture(
            "p.png", images.png(images.disc(64, open_value=v)))) for v in (250, 125))
        self.assertAlmostEqual(half.attributes["glare:apertureArea_mm2"],
                               full.attributes["glare:apertureArea_mm2"] / 4, delta=1e-7)

    def test_three_channels_weigh_as_rec709(self):
        for color, weight in (((255, 0, 0), 0.2126), ((0, 255, 0), 0.7152), ((0, 0, 255), 0.0722)):
            rows = images.mapped(images.disc(64), lambda v: color if v else (0, 0, 0))
            picture = self.make(aperture=self.aperture("c.png", images.png(rows, kind=images.RGB)))
            area = sum(v > 0 for v in images.flat(images.disc(64))) * (0.5 / 64) ** 2
            self.assertAlmostEqual(picture.attributes["glare:apertureArea_mm2"],
                                   area * weight ** 2, delta=1e-6)

    def test_alpha_is_ignored_with_a_warning(self):
        rows = images.mapped(images.disc(64), lambda v: (v, v, v, 128))
        rows[0][0] = (0, 0, 0, 7)
        aperture = self.aperture("a.png", images.png(rows, kind=images.RGBA))
        self.assert_same_pixels(self.make(), self.make(aperture=aperture, warnings=1), 1e-6)
        self.assertIn("alpha", self.last.lines("warning")[0])
        self.make("--quiet", aperture=aperture)

    def test_alpha_alone_is_the_transmittance(self):
        rows = images.mapped(images.disc(64), lambda v: (0, 0, 0, v))
        aperture = self.aperture("a.png", images.png(rows, kind=images.RGBA))
        self.assert_same_pixels(self.make(), self.make("--quiet", aperture=aperture), 1e-6)
        grey = images.mapped(images.disc(64), lambda v: (255, v))
        aperture = self.aperture("g.png", images.png(grey, kind=images.GREY_ALPHA))
        self.assert_same_pixels(self.make(), self.make("--quiet", aperture=aperture), 1e-6)

    def test_a_warning_names_its_file(self):
        rows = images.mapped(images.disc(64), lambda v: (v, v, v, v))
        self.make(aperture=self.aperture("named.png", images.png(rows, kind=images.RGBA)),
                  warnings=1)
        self.assertIn("named.png", self.last.err)

    def test_a_reach_of_slack_for_rounding(self):
        """1.0005 is rounding of whoever wrote the file; it is limited to 1."""
        rows = images.mapped(images.disc(64), lambda v: 1.0005 if v else 0.0)
        aperture = self.aperture("f.pfm", images.pfm(rows))
        self.assert_same_pixels(self.make(), self.make(aperture=aperture))
