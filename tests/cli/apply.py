"""Pictures and templates for the tests of glare apply."""

import array
import math

import exr
from cli import GlareTest

# The program convolves in single precision: a result is known to a few roundings of the largest
# value that goes into it.
FLOAT = 2e-6
FOV_DEG = 2  # Of the templates, across their width.
TEMPLATES = {"t.exr": "64x64", "odd.exr": "47x31"}
SRGB = (0.64, 0.33, 0.30, 0.60, 0.15, 0.06, 0.3127, 0.3290)
BT2020 = (0.708, 0.292, 0.170, 0.797, 0.131, 0.046, 0.3127, 0.3290)


def solved(rows, right):
    """The solution of three linear equations (Cramer's rule)."""
    def determinant(m):
        a, b, c = m
        return (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
                + a[2] * (b[0] * c[1] - b[1] * c[0]))
    whole = determinant(rows)
    return [determinant([[right[i] if j == k else row[j] for j in range(3)]
                         for i, row in enumerate(rows)]) / whole for k in range(3)]


def xyz_from_rgb(chromaticities):
    """The matrix, by rows, after SMPTE RP 177."""
    columns = [(x / y, 1, (1 - x - y) / y) for x, y in zip(chromaticities[::2],
                                                           chromaticities[1::2])]
    primaries = [[columns[k][i] for k in range(3)] for i in range(3)]
    scales = solved(primaries, columns[3])
    return [[value * scales[k] for k, value in enumerate(row)] for row in primaries]


def times(matrix, vector):
    return [sum(a * b for a, b in zip(row, vector)) for row in matrix]


def kernel(template, chromaticities=SRGB):
    """The shares that a template says, {name: values row by row}, in an RGB space: at its pitch."""
    to_xyz = xyz_from_rgb(template.attributes["chromaticities"])
    to_rgb = xyz_from_rgb(chromaticities)
    a = template.attributes
    factor = a["glare:perSteradian"] * math.radians(a["glare:pixelPitch_deg"]) ** 2
    luminance = a["glare:lightXYZ"][1]
    light = solved(to_rgb, a["glare:lightXYZ"])
    if all(abs(value / luminance - 1) < 1e-3 for value in light):  # White to rounding: is white.
        light = [luminance] * 3
    pixels = [solved(to_rgb, times(to_xyz, rgb)) for rgb in template.pixels()]
    return {n: [p[k] * factor / light[k] for p in pixels] for k, n in enumerate("RGB")}


def black(width, height):
    return {n: [0.0] * (width * height) for n in "RGB"}


def impulse(width, height, x, y, light=(1000.0, 1000.0, 1000.0)):
    channels = black(width, height)
    for name, value in zip("RGB", light):
        channels[name][y * width + x] = value
    return channels


class ApplyTest(GlareTest):
    made = {}  # Templates, made once: their content.

    def setUp(self):
        super().setUp()
        if not self.made:
            for name, size in TEMPLATES.items():
                self.make(size=("--size", size, "--fov-deg", FOV_DEG), output=name)
                self.made[name] = self.path(name).read_bytes()
        for name, content in self.made.items():
            self.write(name, content)

    def picture(self, channels, width, height, name="in.exr", **options):
        return self.write(name, exr.encode(channels, width, height, **options))

    def apply(self, *arguments, picture="in.exr", output="out.exr", template="t.exr", warnings=0,
              **options):
        """Applies a template, which must succeed, and reads the result."""
        result = self.glare("apply", picture, "--template", template, "-o", output, *arguments,
                            **options)
        self.assertEqual((result.status, result.out), (0, ""), result.err)
        self.assertEqual(len(result.lines("warning")), warnings, result.err)
        if "--verbose" not in arguments:
            self.assertEqual(len(result.err.splitlines()), warnings, result.err)
        self.last = result
        return exr.read(self.path(output)) if str(output).endswith(".exr") else None

    def assert_refused_for(self, status, mentions, *arguments, picture="in.exr", template="t.exr",
                           output="out.exr"):
        return self.assert_refused(status, mentions, "apply", picture, "--template", template,
                                   "-o", output, *arguments)

    def assert_near(self, values, expected, within):
        self.assertEqual(len(values), len(expected))
        worst = max(abs(a - b) for a, b in zip(values, expected))
        self.assertLessEqual(worst, within)

    def added(self, result, channels):
        return {n: [b - a for a, b in zip(channels[n], result.channels[n])] for n in "RGB"}


def with_kernel(channels, width, height, x, y, shares, size):
    """The picture of one impulse with its glare, by the definition."""
    across, down = size
    result = {}
    for name, values in channels.items():
        light = values[y * width + x]
        out = array.array("d", values)
        for j in range(down):
            for i in range(across):
                to_x, to_y = x + i - across // 2, y + j - down // 2
                if 0 <= to_x < width and 0 <= to_y < height:
                    out[to_y * width + to_x] += light * shares[name][j * across + i]
        out[y * width + x] -= light * sum(shares[name])
        result[name] = out
    return result
