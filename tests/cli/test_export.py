"""glare export: a kernel's file for each program, and the three lines of what to set there."""

import unittest

import exr
from cli import GlareTest

# Program -> its file's channels, type, sum and whether its size is a power of two.
CONTRACTS = {"unreal": ("BGR", "half", 4096, True), "blender": ("ABGR", "float", 1, False),
             "nuke": ("ABGR", "float", 1, False), "vray": ("BGR", "float", 1, False),
             "sapphire": ("BGR", "float", 1, False), "godot": ("BGR", "half", 4096, False)}
BT709 = (0.64, 0.33, 0.30, 0.60, 0.15, 0.06, 0.3127, 0.3290)


class Export(GlareTest):
    def setUp(self):
        super().setUp()
        self.template = self.make("--lamp", "hid", output="t.exr")

    def export(self, program, *arguments, warnings=0):
        result = self.glare("export", "t.exr", "--for", program, "-o", "k.exr", *arguments)
        self.assertEqual(result.status, 0, result.err)
        self.assertEqual(len(result.err.splitlines()), warnings, result.err)
        self.lines = result.out.splitlines()
        self.assertEqual(len(self.lines), 3, result.out)
        return exr.read(self.path("k.exr"))

    def test_contracts(self):
        for program, (channels, kind, total, power_of_two) in CONTRACTS.items():
            with self.subTest(program):
                k = self.export(program, "--quiet")
                width, height = k.size
                self.assertEqual("".join(sorted(k.channels)), channels)
                self.assertEqual(set(k.channel_types.values()), {kind})
                self.assertEqual((width, height), (64, 64) if power_of_two else (65, 65))
                for found, expected in zip(k.attributes["chromaticities"], BT709):
                    self.assertAlmostEqual(found, expected, delta=1e-5)
                self.assertEqual(k.attributes["glare:kernelFor"], program)
                self.assertEqual(k.attributes["glare:kernelCenter_px"], "32 32")
                self.assertEqual(float(k.attributes["glare:kernelSum"]), total)
                self.assertAlmostEqual(float(k.attributes["glare:kernelPixel_deg"]), 2 / 64)
                for values in k.channels.values():
                    # The rounding of the centre: half's 2^-12, single's and that of the others.
                    self.assertAlmostEqual(sum(values) / total, 1,
                                           delta=2.5e-4 if kind == "half" else 2e-6)
                    self.assertEqual(max(values), values[32 * width + 32])
                    self.assertLess(max(map(abs, values)), 65504)
                    border = [v for i, v in enumerate(values)
                              if i % width in (0, width - 1) or i // width in (0, height - 1)]
                    self.assertEqual(set(border), {0.0})

    def test_inside_is_the_template_in_its_own_colours(self):
        k = self.export("nuke", "--quiet")
        t = self.template
        unit = t.attributes["glare:perSteradian"] * (2 / 64 * 3.14159265358979 / 180) ** 2
        ratios = {name: k.channels[name][(32 - 5) * 65 + 32 + 7] /
                  (unit * t.channels[name][(32 - 5) * 64 + 32 + 7]) for name in "RGB"}
        # Each channel is divided by the lamp's own, so that white light stays white: luminance of
        # the lamp is 1, so the ratios' inverses are the lamp's R, G, B.
        weights = exr.luminance_weights(t.attributes["chromaticities"])
        self.assertAlmostEqual(sum(w / ratios[n] for w, n in zip(weights, "RGB")), 1, delta=1e-4)
        self.assertGreater(max(ratios.values()) / min(ratios.values()), 1.05)

    def test_blender_is_turned(self):
        nuke = self.export("nuke", "--quiet")
        blender = self.export("blender", "--quiet")
        for name in "RGB":
            self.assertEqual(list(reversed(nuke.channels[name])), list(blender.channels[name]))
        self.assertEqual(sorted(blender.channels["A"])[-2:], [0, 1])

    def test_sizes_and_scale_are_told(self):
        self.export("unreal", "--quiet", "--fov-deg", "40", "--picture-width", "1280", "--size",
                    "32")
        self.assertIn("32 x 32 pixels of 0.03125 degrees", self.lines[0])
        self.assertIn("Convolution Scale 0.025 (32 of the picture's 1280 pixels; 40 degrees across)",
                      self.lines[1])
        self.assertIn("0.515625, 0.515625", self.lines[1])
        self.export("unreal", "--quiet", "--fov-deg", "90", "--perspective")
        self.assertIn("90 degrees across, perspective)", self.lines[1])
        self.export("vray", "--quiet", "--pixel-deg", "0.1", "--picture-width", "100")
        self.assertIn("Size 21 ", self.lines[1])  # 2 degrees are 20 pixels about a middle one.
        k = self.export("sapphire", "--quiet", "--size", "31")
        self.assertEqual(k.size, (31, 31))

    def test_warnings(self):
        result = self.glare("export", "t.exr", "--for", "unreal", "-o", "k.exr",
                            "--picture-width", "40")
        self.assertIn("limits the Convolution Scale", result.err)

    def test_colour_space(self):
        self.export("blender", "--quiet", "--colorspace", "acescg")
        self.assertIn("colour space acescg", self.lines[0])
        k = self.export("nuke", "--quiet", "--colorspace", "acescg")
        self.assertAlmostEqual(k.attributes["chromaticities"][0], 0.713, delta=1e-3)

    def test_refusals(self):
        command = ("export", "t.exr", "-o", "k.exr")
        self.assert_refused(2, ["--for"], *command)
        self.assert_refused(2, ["gimp"], *command, "--for", "gimp")
        self.assert_refused(2, ["odd"], *command, "--for", "nuke", "--size", "64")
        self.assert_refused(2, ["power of two"], *command, "--for", "unreal", "--size", "65")
        self.assert_refused(2, ["xyz"], *command, "--for", "nuke", "--colorspace", "xyz")
        self.assert_refused(2, ["8192"], *command, "--for", "nuke", "--pixel-deg", "1e-5")
        self.assert_refused(2, [".exr"], "export", "t.exr", "--for", "nuke", "-o", "k.png")
        self.assert_refused(2, ["input"], "export", "t.exr", "--for", "nuke", "-o", "t.exr")
        self.assert_refused(3, ["pupil.png"], "export", "pupil.png", "--for", "nuke", "-o", "k.exr")
        self.assert_refused(2, ["field of view"], *command, "--for", "nuke", "--fov-deg", "0")
        self.assert_refused(2, ["--pixel-deg"], *command, "--for", "nuke", "--pixel-deg", "0")


if __name__ == "__main__":
    unittest.main()
