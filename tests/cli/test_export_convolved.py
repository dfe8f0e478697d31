"""glare export: a small HDR picture convolved with each program's file by a plain sum, in that
program's documented way (docs/kernels.md), is what glare apply gives."""

import math
import struct
import unittest

import exr
from apply import ApplyTest

SIZE, PICTURE = 15, (13, 10)
CAPTURED = 0.8
# Half rounds each value, and the centre, to 2^-12 of itself; single precision's roundings are small
# beside those of the transforms that glare apply makes.
HALF, SINGLE = 2.5e-4, 2e-6
# Whether the program gathers (correlation) or spreads, and what it divides by: its kernel's sum, or
# what it is told.
PROGRAMS = {"unreal": (False, "sum", HALF), "blender": (True, "sum", SINGLE),
            "nuke": (False, "sum", SINGLE), "vray": (False, 1, SINGLE),
            "sapphire": (False, 1, SINGLE), "godot": (False, 4096, HALF)}


def lopsided(name, x, y):
    """Light that no mirror image, turn or swap of channels leaves as it is; 0 where a fade ends."""
    u, v = x - SIZE // 2, y - SIZE // 2
    if math.hypot(u, v) >= SIZE // 2:
        return 0.0
    around = 1 + 0.6 * math.cos(math.atan2(v, u) - 0.7)
    return around / (1 + u * u + v * v) ** {"R": 1.0, "G": 1.3, "B": 1.6}[name]


def convolved(values, size, kernel, kernel_size, gathers, divisor):
    """The plain sum; the axis is pixel (width / 2, height / 2), beyond the border is black."""
    (width, height), (across, down) = size, kernel_size
    out = [0.0] * (width * height)
    sign = -1 if gathers else 1
    for i, light in enumerate(values):
        for j, share in enumerate(kernel):
            x = i % width + sign * (j % across - across // 2)
            y = i // width + sign * (j // across - down // 2)
            if 0 <= x < width and 0 <= y < height:
                out[y * width + x] += light * share / divisor
    return out


class Convolved(ApplyTest):
    def setUp(self):
        super().setUp()
        header, _ = exr.read_header(self.path("t.exr").read_bytes())
        made = exr.read(self.path("t.exr"))
        unit = (made.attributes["glare:perSteradian"]
                * math.radians(made.attributes["glare:pixelPitch_deg"]) ** 2)
        channels = {}
        for name in "RGB":
            shape = [lopsided(name, x, y) for y in range(SIZE) for x in range(SIZE)]
            channels[name] = [CAPTURED * v / sum(shape) / unit for v in shape]
        kept = {n: a for n, a in header.items() if n.startswith("glare:") or n == "chromaticities"}
        kept["glare:center_px"] = ("v2f", struct.pack("<2f", SIZE // 2, SIZE // 2))
        self.write("lopsided.exr", exr.encode(channels, SIZE, SIZE, kept))
        width, height = PICTURE
        self.light = {}
        for k, name in enumerate("RGB"):
            values = [0.1 + 0.01 * x + 0.005 * y * k for y in range(height) for x in range(width)]
            values[0], values[4 * width + 8], values[7 * width + 3] = 40, 500 - 200 * k, 90 + 60 * k
            self.light[name] = values
        self.picture(self.light, *PICTURE)
        pitch_deg = made.attributes["glare:pixelPitch_deg"]
        self.expected = self.apply("--pixel-deg", repr(pitch_deg), template="lopsided.exr")

    def export(self, program, roll_off):
        result = self.glare("export", "lopsided.exr", "--for", program, "-o", "k.exr", "--roll-off",
                            roll_off, "--verbose")
        self.assertEqual(result.status, 0, result.err)
        told = next(line for line in result.err.splitlines() if "roll-off" in line)
        return exr.read(self.path("k.exr")), float(told.split("leaves ")[1].split()[0])

    def assert_convolves_alike(self, program, roll_off):
        gathers, divisor, rounding = PROGRAMS[program]
        kernel, moved = self.export(program, roll_off)
        for name, light in self.light.items():
            shares = kernel.channels[name]
            out = convolved(light, PICTURE, shares, kernel.size, gathers,
                            sum(shares) if divisor == "sum" else divisor)
            # What the fade took stays in its pixel: each pixel lacks at most that share, and keeps
            # at most that of its own, of the brightest light (%.3g rounds what is told).
            self.assert_near(out, self.expected.channels[name],
                             (1.01 * moved + rounding) * max(light))

    def test_without_a_fade(self):
        for program in PROGRAMS:
            with self.subTest(program):
                self.assert_convolves_alike(program, 0)

    def test_with_the_usual_fade(self):
        for program in PROGRAMS:
            with self.subTest(program):
                self.assert_convolves_alike(program, 0.25)


if __name__ == "__main__":
    unittest.main()
