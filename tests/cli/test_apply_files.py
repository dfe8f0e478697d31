"""glare apply: what it keeps of a picture's file, and what it refuses."""

import re
import shutil
import struct
import subprocess
import unittest

import exr
import images
from apply import BT2020, FLOAT, FOV_DEG, SRGB, ApplyTest, impulse, kernel, with_kernel

SCALE = ("--pixel-deg", FOV_DEG / 64)
SIZE = (70, 60)


def chromaticities(numbers):
    return {"chromaticities": ("chromaticities", struct.pack("<8f", *numbers))}


def box(left, top, right, bottom):
    return ("box2i", struct.pack("<4i", left, top, right, bottom))


class Keeping(ApplyTest):
    def setUp(self):
        super().setUp()
        count = SIZE[0] * SIZE[1]
        self.channels = impulse(*SIZE, 30, 25)
        self.channels |= {"A": [i % 7 / 8 for i in range(count)], "Z": [float(i) for i in range(count)]}
        self.channels |= {f"light.{n}": [float(i % (5 + k)) for i in range(count)]
                          for k, n in enumerate("RGB")}
        self.attributes = {
            "displayWindow": box(-10, -20, 109, 79), "owner": ("string", b"somebody"),
            "pixelAspectRatio": ("float", struct.pack("<f", 2)),
            "myOwn": ("myType", b"\1\2\3"), "isoSpeed": ("float", struct.pack("<f", 400)),
            "timeCode": ("timecode", bytes(8))} | chromaticities(BT2020)
        self.picture(self.channels, *SIZE, attributes=self.attributes, halves=("A", "R", "G", "B"),
                     corner=(5, -7))

    def test_everything_else(self):
        before, result = exr.read(self.path("in.exr")), self.apply(*SCALE)
        self.assertEqual(result.attributes, before.attributes)
        self.assertEqual(result.types, before.types)
        self.assertEqual(result.channel_types, before.channel_types)
        for n in self.channels.keys() - set("RGB"):
            self.assertEqual(result.channels[n], before.channels[n], n)
        self.assertNotEqual(result.channels["R"], before.channels["R"])

    @unittest.skipUnless(shutil.which("exrheader"), "OpenEXR's exrheader isn't there")
    def test_as_exrheader_says(self):
        def header(name):
            done = subprocess.run(["exrheader", name], cwd=self.folder, check=True,
                                  capture_output=True, text=True)
            return done.stdout.replace(name, "")
        self.apply(*SCALE)
        self.assertEqual(header("out.exr"), header("in.exr"))

    def test_a_layer(self):
        result = self.apply(*SCALE, "--layer", "light")
        for n in "ARGBZ":
            self.assertEqual(result.channels[n], exr.read(self.path("in.exr")).channels[n], n)
        self.assertNotEqual(result.channels["light.R"].tolist(), self.channels["light.R"])
        self.assert_refused_for(3, ["dark"], *SCALE, "--layer", "dark")
        self.assert_refused_for(3, ["part"], *SCALE, "--part", "1")

    def test_half_overflow_is_told(self):
        bright = impulse(*SIZE, 30, 25, (6e4, 6e4, 6e4))
        self.picture(bright, *SIZE, halves="RGB")
        result = self.apply(*SCALE, "--exposure", 1, "--strength", 0, warnings=1)
        self.assertIn("limited", self.last.err)
        self.assertIn(": 1", self.last.err)
        self.assertEqual(max(result.channels["R"]), 65504)

    def test_no_two_runs_differ(self):
        self.apply(*SCALE, "--threads", 1)
        one = self.path("out.exr").read_bytes()
        self.apply(*SCALE, "--threads", 2)
        self.assertEqual(self.path("out.exr").read_bytes(), one)

    def test_grey(self):
        self.picture({"Y": impulse(*SIZE, 30, 25)["G"]}, *SIZE)
        result = self.apply(*SCALE)
        self.assertEqual(list(result.channels), ["Y"])
        template = exr.read(self.path("t.exr"))
        weights = exr.luminance_weights(template.attributes["chromaticities"])
        shares = kernel(template)  # In BT.709: the luminance's share by the light's own weights.
        light = [w * c for w, c in zip(weights, (1, 1, 1))]  # D65: nearly its white.
        gray = [sum(w * v for w, v in zip(light, rgb)) for rgb in zip(*(shares[n] for n in "RGB"))]
        expected = with_kernel({"Y": impulse(*SIZE, 30, 25)["G"]}, *SIZE, 30, 25, {"Y": gray},
                               (64, 64))
        self.assert_near(result.channels["Y"], expected["Y"], 1e-3 * 1000)

    def test_radiance_pictures(self):
        self.apply(*SCALE, output="out.hdr", warnings=1)
        self.assertIn("left out", self.last.err)
        self.assertTrue(self.path("out.hdr").read_bytes().startswith(b"#?RADIANCE"))
        self.apply(*SCALE, picture="out.hdr", output="again.hdr")


class Colors(ApplyTest):
    def test_of_the_file(self):
        template = exr.read(self.path("t.exr"))
        for told in (SRGB, BT2020):
            channels = impulse(*SIZE, 30, 25)
            self.picture(channels, *SIZE, attributes=chromaticities(told))
            result = self.apply(*SCALE)
            expected = with_kernel(channels, *SIZE, 30, 25, kernel(template, told), (64, 64))
            for n in "RGB":
                self.assert_near(result.channels[n], expected[n], FLOAT * 1000)

    def test_of_the_command_line(self):
        channels = impulse(*SIZE, 30, 25)
        self.picture(channels, *SIZE, attributes=chromaticities(BT2020))
        self.picture(channels, *SIZE, "plain.exr")
        told = self.apply(*SCALE)
        same = self.apply(*SCALE, "--colorspace", "lin_rec2020", picture="plain.exr")
        for n in "RGB":
            self.assert_near(same.channels[n], told.channels[n], FLOAT * 1000)
        self.assertNotIn("chromaticities", same.attributes)
        self.assert_refused_for(2, ["no_space"], *SCALE, "--colorspace", "no_space")
        self.assert_refused_for(2, ["--colorspace"], *SCALE, "--ocio", "c.ocio")


class Scales(ApplyTest):
    def setUp(self):
        super().setUp()
        self.picture(impulse(*SIZE, 30, 25), *SIZE)

    def test_of_the_files_own_attributes(self):
        self.assert_refused_for(2, ["in.exr", "--fov-deg", "--pixel-deg"])
        camera = {"glare:horizontalFov_deg": ("float", struct.pack("<f", 2.5))}
        self.picture(impulse(*SIZE, 30, 25), *SIZE, "camera.exr", attributes=camera)
        told = self.apply(picture="camera.exr")
        given = self.apply("--fov-deg", 2.5, "--perspective")
        for n in "RGB":
            self.assert_near(told.channels[n], given.channels[n], FLOAT * 1000)
        self.apply("--verbose", picture="camera.exr")
        self.assertIn("horizontalFov", self.last.err)

    def test_field_of_view_is_that_of_the_display_window(self):
        self.picture(impulse(*SIZE, 30, 25), *SIZE, "part.exr", corner=(3, 4),
                     attributes={"displayWindow": box(0, 0, 127, 99)})
        part = self.apply("--fov-deg", 4, picture="part.exr")
        same = self.apply("--pixel-deg", 4 / 128)
        for n in "RGB":
            self.assertEqual(part.channels[n], same.channels[n])

    def test_refusals(self):
        self.assert_refused_for(2, ["--fov-deg"], "--fov-deg", "2", "--pixel-deg", "1")
        self.assert_refused_for(2, ["--perspective"], "--pixel-deg", "1", "--perspective")
        for option, value in (("--fov-deg", "0"), ("--fov-deg", "180"), ("--fov-deg", "nan"),
                              ("--pixel-deg", "-1"), ("--pixel-deg", "90"), ("--fov-deg", "x")):
            self.assert_refused_for(2, [option], option, value)
        for option, value in (("--threshold", "-1"), ("--knee", "2"), ("--strength", "nan"),
                              ("--exposure", "100"), ("--edge", "wrap"), ("--lamp-color", "red")):
            self.assert_refused_for(2, [option], *SCALE, option, value)

    def test_warnings(self):
        for pixel_deg, word in ((1, "pixels of the picture"), (2e-2, None),
                                (1e-2, "times as wide")):
            self.apply("--pixel-deg", pixel_deg, warnings=1 if word else 0)
            self.assertIn(word or "", self.last.err)


class Memory(ApplyTest):
    def test_blocks_are_as_the_whole(self):
        width, height = 400, 300
        channels = impulse(width, height, 199, 150)
        for i in range(0, width * height, 37):
            channels["R"][i] += i % 13
        self.picture(channels, width, height)
        whole = self.apply(*SCALE)
        self.apply(*SCALE, "--memory-limit", "7MB")
        blocks = exr.read(self.path("out.exr"))
        for n in "RGB":
            self.assert_near(blocks.channels[n], whole.channels[n], FLOAT * 1000)
        # Otherwise rounded: it was done in blocks indeed.
        self.assertTrue(blocks.channels != whole.channels)
        self.assert_refused_for(5, ["memory"], *SCALE, "--memory-limit", "1MB")


class Odd(ApplyTest):
    def refused(self, status, mentions, content, *arguments):
        self.write("odd.in.exr", content)
        return self.assert_refused_for(status, mentions, *SCALE, *arguments,
                                       picture="odd.in.exr")

    def test_sizes(self):
        self.picture({n: [5.0] for n in "RGB"}, 1, 1)
        result = self.apply(*SCALE, "--edge", "extend")
        self.assert_near(result.channels["R"], [5], 10 * FLOAT)
        self.assertLess(self.apply(*SCALE).channels["R"][0], 4)
        self.picture(impulse(16384, 2, 16000, 1), 16384, 2)
        wide = self.apply(*SCALE, warnings=1)  # The template is a small part of it.
        self.assertGreater(wide.channels["R"][16384 + 16001], 0)
        self.assert_near(wide.channels["R"][:15000], [0] * 15000, FLOAT * 1000)

    def test_bad_pictures(self):
        self.picture(impulse(*SIZE, 30, 25), *SIZE)
        good = self.path("in.exr").read_bytes()

        def changed(name, value):
            return exr.with_attributes(good, lambda a: a.update({name: value}))
        self.refused(3, ["odd.in.exr"], good[:len(good) // 2])
        self.refused(3, ["odd.in.exr"], b"")
        self.refused(3, ["odd.in.exr"], b"no picture")
        empty = bytearray(good)
        at = good.index(b"dataWindow\0box2i\0") + 21
        empty[at:at + 16] = struct.pack("<4i", 5, 0, 3, SIZE[1] - 1)
        self.refused(3, ["odd.in.exr", "window"], bytes(empty))
        chlist = re.search(rb"channels\0chlist\0....", good, re.DOTALL).end()
        subsampled = bytearray(good)
        subsampled[chlist + 10:chlist + 14] = struct.pack("<i", 2)
        self.refused(3, ["odd.in.exr"], bytes(subsampled))
        deep = bytearray(good)
        deep[4:8] = struct.pack("<I", 2 | 0x800)
        self.refused(3, ["odd.in.exr", "deep"], bytes(deep))
        result = self.refused(3, ["odd.in.exr", "aspect"],
                              changed("pixelAspectRatio", ("float", bytes(4))))
        self.assertNotIn('"file"', result.err)
        self.refused(3, ["odd.in.exr"], exr.encode({"U": [0.0], "V": [0.0]}, 1, 1))
        self.refused(3, ["odd.in.exr", "channels Z"], exr.encode({"Z": [0.0]}, 1, 1))  # Depth.

    def test_bad_templates(self):
        self.picture(impulse(*SIZE, 30, 25), *SIZE)
        self.assert_refused_for(3, ["in.exr", "no glare template"], *SCALE, template="in.exr")
        self.assert_refused_for(3, ["none.exr"], *SCALE, template="none.exr")
        self.write("cut.exr", images.cut(self.path("t.exr").read_bytes()))
        self.assert_refused_for(3, ["cut.exr"], *SCALE, template="cut.exr")

    def test_bad_outputs(self):
        self.picture(impulse(*SIZE, 30, 25), *SIZE)
        for output in ("./in.exr", "t.exr"):
            self.assert_refused_for(2, ["input"], *SCALE, output=output)
        self.assert_refused_for(2, [".exr"], *SCALE, output="out.png")
        self.assert_refused_for(4, ["no"], *SCALE, output="no/out.exr")


if __name__ == "__main__":
    unittest.main()
