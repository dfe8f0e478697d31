"""glare template: pictures of the aperture, and the built-in eye."""

import math

import images
from cli import GlareTest



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
        self.assertAlmostEqual(smaller.attributes["glare:apertureWidth_mm"], 3.9, delta=0.1)

    def test_built_in_eye_and_images_exclude_each_other(self):
        for option in ("--pupil-mm", "--seed"):
            self.assert_template_refused(2, [option], option, "3")
