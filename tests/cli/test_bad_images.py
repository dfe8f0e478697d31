"""Pictures that can't be an aperture: status 3, one line, no output."""

import os
import pathlib
import struct

import exr
import images
from cli import GlareTest

DATA = pathlib.Path(__file__).resolve().parent.parent / "data" / "images"


def exr_of(rows):
    return exr.encode({"Y": images.flat(rows)}, len(rows[0]), len(rows))


def with_data_window(data, *box):
    def change(attributes):
        for name in ("dataWindow", "displayWindow"):
            attributes[name] = ("box2i", struct.pack("<4i", *box))
    attributes, end = exr.read_header(data)
    changed = dict(attributes)
    change(changed)
    return exr.header_bytes(changed) + data[end:]


class BadImages(GlareTest):
    def check(self, name, content=None, mentions=(), status=3):
        if content is not None:
            self.write(name, content)
        self.assert_template_refused(status, [name, *mentions],
                                     aperture=("--pupil", name, "--width-mm", "0.5"))

    def test_missing_file(self):
        self.check("nothing.png", mentions=["no such file"])
        self.check("no/folder.png", mentions=["no such file"])

    def test_not_a_regular_file(self):
        self.path("folder.png").mkdir()
        self.check("folder.png", mentions=["folder"])
        self.check("/dev/null", mentions=["not a regular file"])
        self.check("/dev/zero", mentions=["not a regular file"])
        os.mkfifo(self.path("pipe.png"))
        self.check("pipe.png", mentions=["pipe"])

    def test_not_an_image(self):
        for content in (b"", b"hello, world\n" * 50, bytes(range(256)) * 16, b"II*\0",
                        b"\x89PNG\r\n\x1a\n", b"\xff\xd8\xff", b"BM", exr.MAGIC, b"P5\n",
                        b"<svg xmlns='http://www.w3.org/2000/svg'/>", b"GIF89a" + bytes(30)):
            with self.subTest(content[:12]):
                self.check("picture.png", content)

    def test_truncated(self):
        disc = images.disc(64)
        jpeg = (DATA / "grey.jpg").read_bytes()
        whole = {"png": images.png(disc), "tif": images.tiff(disc), "jpg": jpeg,
                 "exr": exr_of(images.mapped(disc, lambda v: v / 255)), "pgm": images.pgm(disc),
                 "bmp": images.bmp(disc), "pfm": images.pfm(images.mapped(disc, lambda v: v / 255))}
        for kind, data in whole.items():
            for share in (0.3, 1 - 1 / len(data)):
                if kind == "jpg" and share > 0.99:
                    continue  # Half an end-of-image marker: every pixel is there.
                with self.subTest(kind, share=share):
                    self.check("picture." + kind, images.cut(data, share))

    def test_the_jpeg_that_is_cut_is_good_when_whole(self):
        self.write("whole.jpg", (DATA / "grey.jpg").read_bytes())
        self.make(aperture=("--pupil", "whole.jpg", "--width-mm", "0.1"))

    def test_damaged_content(self):
        data = bytearray(images.png(images.disc(64)))
        data[60] ^= 0xff
        self.check("picture.png", bytes(data))
        self.check("bad_profile_cut.jpg", images.cut((DATA / "bad_profile.jpg").read_bytes(), 0.8))
        self.check("cmyk.jpg", (DATA / "cmyk.jpg").read_bytes(), ["cmyk"])

    def test_no_pixels_or_absurdly_many(self):
        end = images.png(images.disc(8))[33:]
        ends = {f"{w}x{h}.png": images.png_header(w, h) + end
                for w, h in ((0, 0), (0, 8), (8, 0), (2**31 - 1, 2**31 - 1), (2**32 - 1, 1),
                             (100000, 100000), (65535, 65535))}
        ends |= {f"{w}x{h}.pgm": f"P5\n{w} {h}\n255\n".encode() + bytes(64)
                 for w, h in ((0, 0), (0, 5), (99999999, 99999999), (65535, 65535), (-4, 4),
                              (10**30, 1))}
        ends |= {f"{w}x{h}.tif": images.tiff(images.disc(8), width=w, height=h)
                 for w, h in ((0, 0), (8, 0), (2**32 - 1, 2**32 - 1), (60000, 60000))}
        picture = exr_of(images.constant(8, 8, 1.0))
        boxes = {"empty.exr": (0, 0, -1, -1), "huge.exr": (0, 0, 2**31 - 1, 2**31 - 1),
                 "extremes.exr": (-2**31, -2**31, 2**31 - 1, 2**31 - 1),
                 "large.exr": (0, 0, 65534, 65534)}
        ends |= {name: with_data_window(picture, *box) for name, box in boxes.items()}
        bmp = images.bmp(images.disc(8))
        ends |= {f"{w}x{h}.bmp": bmp[:18] + struct.pack("<ii", w, h) + bmp[26:]
                 for w, h in ((0, 0), (2**31 - 1, 2**31 - 1), (-8, 8), (8, -2**31))}
        for name, data in ends.items():
            with self.subTest(name):
                self.check(name, data)

    def test_values_that_are_no_transmittance(self):
        for value in (float("nan"), float("inf"), float("-inf"), -0.25, 1.5, -1e-3):
            rows = images.mapped(images.disc(16), lambda v: v / 255)
            rows[7][5] = value
            for name, data in (("t.exr", exr_of(rows)), ("t.pfm", images.pfm(rows)),
                               ("t.tif", images.tiff(rows, "f"))):
                with self.subTest(name, value=value):
                    self.check(name, data)

    def test_all_black(self):
        self.check("black.png", images.png(images.constant(32, 32, 0)), ["opaque"])
        self.check("black.exr", exr_of(images.constant(32, 32, 0.0)), ["opaque"])

    def test_open_nowhere_together(self):
        """Each lets light through, and both together none."""
        left = [[255 * (x < 16) for x in range(32)] for _ in range(32)]
        self.write("left.png", images.png(left))
        self.write("right.png", images.png([row[::-1] for row in left]))
        self.assert_template_refused(3, ["opaque"], aperture=(
            "--pupil", "left.png", "--eyelashes", "right.png", "--width-mm", "0.25"))

    def test_too_few_pixels(self):
        for width, height in ((1, 1), (1, 8), (8, 1)):
            self.check("small.png", images.png(images.constant(width, height, 255)),
                       [f"{width} x {height}"])

    def test_two_pixels_are_enough(self):
        self.write("pupil.png", images.png(images.constant(2, 2, 255)))
        self.make("--width-mm", "0.01", aperture=("--pupil", "pupil.png"))

    def test_a_bad_second_picture(self):
        self.write("bad.png", images.cut(images.png(images.disc(64))))
        self.assert_template_refused(3, ["bad.png"], "--eyelashes", "bad.png")
