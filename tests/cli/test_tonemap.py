"""glare tonemap: pictures and templates brought to a display."""

import struct
import unittest
import zlib

import exr
import images
from cli import GlareTest

# Two roles, a view that halves and one that takes the square root.
CONFIG = """ocio_profile_version: 2
strictparsing: true
roles: {default: reference, cie_xyz_d65_interchange: reference}
displays:
  Monitor:
    - !<View> {name: Half, colorspace: half}
    - !<View> {name: Root, colorspace: root}
colorspaces:
  - !<ColorSpace> {name: reference}
  - !<ColorSpace>
    name: half
    from_scene_reference: !<MatrixTransform>
      matrix: [0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 1]
  - !<ColorSpace>
    name: root
    from_scene_reference: !<ExponentTransform> {value: [0.5, 0.5, 0.5, 1]}
"""


def paeth(a, b, c):
    p = a + b - c
    return min((abs(p - a), 0, a), (abs(p - b), 1, b), (abs(p - c), 2, c))[2]


def png_pixels(data):
    """Rows of (R, G, B) of an 8 or 16-bit RGB file."""
    width, height, bits, kind = struct.unpack_from(">IIBB", data, 16)
    assert kind == images.RGB
    at, deflated = 8, b""
    while at < len(data):
        size, = struct.unpack_from(">I", data, at)
        if data[at + 4:at + 8] == b"IDAT":
            deflated += data[at + 8:at + 8 + size]
        at += size + 12
    raw, step = zlib.decompress(deflated), 3 * bits // 8
    row, rows = bytearray(width * step), []
    for y in range(height):
        start = y * (width * step + 1)
        line = bytearray(raw[start + 1:start + 1 + width * step])
        for i in range(len(line)):
            left = line[i - step] if i >= step else 0
            corner = row[i - step] if i >= step else 0
            line[i] = (line[i] + {0: 0, 1: left, 2: row[i], 3: (left + row[i]) // 2,
                                  4: paeth(left, row[i], corner)}[raw[start]]) & 255
        samples = struct.unpack(f">{3 * width}{'H' if bits == 16 else 'B'}", line)
        rows.append([samples[i:i + 3] for i in range(0, len(samples), 3)])
        row = line
    return rows


def srgb(linear):
    return 12.92 * linear if linear <= 0.0031308 else 1.055 * linear ** (1 / 2.4) - 0.055


def sigmoid(x, g=1, k=16, maximum=255):
    return min(1, maximum / 255 * (x ** g + 1 / k) / (x ** g + k))


def luminance(rgb):
    return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2]


class Tonemap(GlareTest):
    PIXELS = [(0, 0, 0), (10, 10, 10), (160, 160, 160), (30, 20, 10), (1e6, 1e6, 1e6)]

    def setUp(self):
        super().setUp()
        self.write_picture("in.exr", self.PIXELS)

    def write_picture(self, name, pixels, names="RGB"):
        self.write(name, exr.encode({n: [p[i] for p in pixels] for i, n in enumerate(names)},
                                    len(pixels), 1))

    def shown(self, *arguments, picture="in.exr"):
        """The PNG's pixels in 0 to 1, of 16 bits."""
        result = self.glare("tonemap", picture, "-o", "out.png", "--bits", "16", *arguments)
        self.assertEqual((result.status, result.err, result.out), (0, "", ""))
        rows = png_pixels(self.path("out.png").read_bytes())
        return [tuple(v / 65535 for v in pixel) for pixel in rows[0]]

    def assert_near(self, actual, expected):
        # What tone_mapped promises, and half a step of 16 bits.
        for a, e in zip(actual, expected, strict=True):
            for x, y in zip(a, e, strict=True):
                self.assertAlmostEqual(x, y, delta=6e-5, msg=f"{actual} {expected}")


class Curves(Tonemap):
    def test_the_sigmoid_by_hand(self):
        # L_wa = 10: D / k^2, D / k, and x = k: D (1 + 1 / k^2) / 2.
        actual = self.shown("--adaptation-luminance", "10", "--transfer", "none")
        self.assert_near(actual[:3], [(1 / 256,) * 3, (1 / 16,) * 3, (257 / 512,) * 3])
        self.assertAlmostEqual(actual[4][0], (1e5 + 1 / 16) / (1e5 + 16), delta=6e-5)

    def test_its_parameters(self):
        actual = self.shown("--adaptation-luminance", "40", "--gamma", "0.6", "--k", "8",
                            "--display-maximum", "200", "--exposure-stops", "1", "--transfer",
                            "none")
        expected = [(sigmoid(p[0] * 2 / 40, 0.6, 8, 200),) * 3 for p in self.PIXELS]
        self.assert_near(actual[:3] + actual[4:], expected[:3] + expected[4:])

    def test_light_is_encoded_for_srgb(self):
        actual = self.shown("--adaptation-luminance", "10")
        self.assert_near(actual[:3], [(srgb(v),) * 3 for v in (1 / 256, 1 / 16, 257 / 512)])
        self.assertIn(b"sRGB", self.path("out.png").read_bytes())

    def test_luminance_keeps_the_colour_and_channels_do_not(self):
        color = self.PIXELS[3]
        options = ("--adaptation-luminance", "10", "--transfer", "none")
        factor = sigmoid(luminance(color) / 10) / luminance(color)
        self.assert_near(self.shown(*options)[3:4], [tuple(v * factor for v in color)])
        self.assert_near(self.shown(*options, "--per-channel")[3:4],
                         [tuple(sigmoid(v / 10) for v in color)])

    def test_the_median_is_the_adaptation_unless_told(self):
        # Of 10, 21.41, 160 and 1e6 the upper one in the middle.
        result = self.glare("tonemap", "in.exr", "-o", "out.png", "--verbose")
        self.assertEqual(result.lines("note"),
                         ["glare: note: adaptation luminance 160, the picture's median"])
        self.assert_near(self.shown("--transfer", "none")[2:3], [(1 / 16,) * 3])

    def test_linear_is_exposure_alone(self):
        actual = self.shown("--curve", "linear", "--exposure-stops", "-5")
        self.assert_near(actual, [tuple(srgb(min(1, v / 32)) for v in p) for p in self.PIXELS])

    def test_scale(self):
        self.assert_near(self.shown("--curve", "linear", "--scale", "0.03125"),
                         self.shown("--curve", "linear", "--exposure-stops", "-5"))


class Files(Tonemap):
    def test_exr_holds_the_displays_light(self):
        result = self.glare("tonemap", "in.exr", "-o", "out.exr", "--adaptation-luminance", "10")
        self.assertEqual((result.status, result.err), (0, ""))
        picture = exr.read(self.path("out.exr"))
        self.assertEqual(picture.attributes["glare:colorSpace"], "lin_rec709")
        self.assertAlmostEqual(picture.channels["G"][2], 257 / 512, delta=5e-5)

    def test_eight_bits_are_the_default(self):
        done = self.glare("tonemap", "in.exr", "-o", "out.png", "--adaptation-luminance", "0.001")
        self.assertEqual(done.status, 0)
        data = self.path("out.png").read_bytes()
        self.assertEqual(data[24], 8)
        self.assertEqual(png_pixels(data)[0][4], (255, 255, 255))

    def test_xyz_and_ordinary_pictures(self):
        self.write_picture("xyz.exr", [(0.95047 / 2, 0.5, 1.08883 / 2)], "XYZ")
        for v in self.shown("--curve", "linear", picture="xyz.exr")[0]:
            self.assertAlmostEqual(v, srgb(0.5), delta=3e-4)  # D65 of five decimals and of four.
        self.write("in.png", images.png([[(10, 100, 200)]], kind=images.RGB))
        self.assert_near(self.shown("--curve", "linear", picture="in.png"),
                         [(10 / 255, 100 / 255, 200 / 255)])  # There and back.

    def test_a_template_and_its_veil(self):
        template = self.make()
        peak = max(template.luminance())
        per_steradian = template.attributes["glare:perSteradian"]
        lux = 0.5 / (peak * per_steradian)
        veil = self.shown("--illuminance-lux", repr(lux), "--curve", "linear", "--transfer", "none",
                          picture="out.exr")
        self.assertEqual(len(veil), 64)
        rows = png_pixels(self.path("out.png").read_bytes())
        largest = max(luminance([v / 65535 for v in p]) for row in rows for p in row)
        self.assertAlmostEqual(largest, 0.5, delta=1e-3)

    def test_warnings_of_the_picture(self):
        self.write_picture("in.exr", [(1, 2, 3, 4)], "RGBZ")
        result = self.glare("tonemap", "in.exr", "-o", "out.png")
        self.assertEqual(len(result.lines("warning")), 1, result.err)
        self.assertIn("in.exr: only some of the channels", result.err)
        self.assertEqual(self.glare("tonemap", "in.exr", "-o", "out.png", "--quiet").err, "")

    def test_same_bytes_on_any_number_of_threads(self):
        for name in ("out.png", "out.exr"):
            files = set()
            for threads in ("1", "2"):
                self.glare("tonemap", "in.exr", "-o", name, "--threads", threads)
                files.add(self.path(name).read_bytes())
            self.assertEqual(len(files), 1, name)


class Views(Tonemap):
    def setUp(self):
        super().setUp()
        self.write("config.ocio", CONFIG)
        self.write_picture("in.exr", [(0.5, 0.25, 0.125)], "XYZ")

    def test_display_and_view(self):
        options = ("--ocio", "config.ocio")
        self.assert_near(self.shown(*options), [(0.25, 0.125, 0.0625)])
        self.assert_near(self.shown(*options, "--display", "Monitor", "--view", "Root"),
                         [(0.5 ** 0.5, 0.5, 0.125 ** 0.5)])
        self.assert_near(self.shown(*options, "--exposure-stops", "1"), [(0.5, 0.25, 0.125)])

    def test_config_of_the_environment(self):
        self.environment["OCIO"] = str(self.path("config.ocio"))
        self.assert_near(self.shown("--view", "Root"), [(0.5 ** 0.5, 0.5, 0.125 ** 0.5)])

    def test_errors(self):
        def refused(status, mentions, *arguments, output="out.png"):
            self.assert_refused(status, mentions, "tonemap", "in.exr", "-o", output, *arguments)
        refused(2, ["unknown display 'TV'", "Monitor"], "--ocio", "config.ocio", "--display", "TV")
        refused(2, ["unknown view 'Film'", "Half, Root"], "--ocio", "config.ocio", "--view", "Film")
        refused(2, ["--ocio"], "--view", "Root")
        refused(3, ["none.ocio"], "--ocio", "none.ocio")
        refused(2, [".png"], "--ocio", "config.ocio", output="out.exr")
        refused(2, ["--gamma"], "--ocio", "config.ocio", "--gamma", "2")
        refused(2, ["input"], "--ocio", "config.png", output="config.png")


class Refusals(Tonemap):
    def refused(self, status, mentions, *arguments, picture="in.exr", output="out.png"):
        self.assert_refused(status, mentions, "tonemap", picture, "-o", output, *arguments)

    def test_options(self):
        for option, value in (("--gamma", "0"), ("--k", "0.5"), ("--display-maximum", "-1"),
                              ("--adaptation-luminance", "0"), ("--exposure-stops", "1000"),
                              ("--scale", "0"), ("--scale", "nan"), ("--bits", "10"),
                              ("--curve", "film"), ("--transfer", "gamma"), ("--gamma", "nan")):
            self.refused(2, [], option, value)
        self.refused(2, ["--scale"], "--illuminance-lux", "1", "--scale", "2")
        self.refused(2, ["--illuminance-lux"], "--illuminance-lux", "-1")

    def test_files(self):
        self.refused(3, ["none.exr"], picture="none.exr")
        self.write("text.exr", "no picture")
        self.refused(3, ["text.exr", "text"], picture="text.exr")
        self.write("cut.exr", images.cut(self.path("in.exr").read_bytes()))
        self.refused(3, ["cut.exr"], picture="cut.exr")
        self.write_picture("nan.exr", [(1, float("nan"), 1)])
        self.refused(3, ["(0, 0)", "finite"], picture="nan.exr")
        self.refused(3, ["in.exr", "no glare template"], "--illuminance-lux", "1")

    def test_outputs(self):
        before = self.path("in.exr").read_bytes()
        self.refused(2, ["input"], output="./in.exr")
        self.assertEqual(self.path("in.exr").read_bytes(), before)
        self.refused(2, [".png"], output="out.jpg")
        self.refused(4, ["no"], output="no/out.png")


if __name__ == "__main__":
    unittest.main()
