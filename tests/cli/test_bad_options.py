"""Command lines that are wrong: status 2 and one line that names the option; memory: status 5."""

import os
import pathlib
import re

import images
from cli import GlareTest


class Words(GlareTest):
    def test_no_or_unknown_subcommand(self):
        self.assert_refused(2, ["subcommand"])
        self.assert_refused(2, ["bogus"], "bogus")
        self.assert_refused(2, ["--bogus"], "--bogus")

    def test_unknown_option_or_word(self):
        self.assert_template_refused(2, ["--bogus"], "--bogus")
        self.assert_template_refused(2, ["extra"], "extra")
        self.assert_template_refused(2, ["--fo"], "--fo", "2")

    def test_what_is_missing(self):
        self.assert_refused(2, ["output"], "template")
        self.assert_refused(2, ["output"], "template", "-o")
        self.assert_refused(2, ["file"], "info")
        self.assert_template_refused(2, ["--lamp"], "--lamp")

    def test_an_option_twice(self):
        self.assert_template_refused(2, ["--lamp"], "--lamp", "A", "--lamp", "D65")
        self.assert_template_refused(2, ["--observer"], "--observer", "cie1931-2deg",
                                     "--observer", "cie1964-10deg")

    def test_quiet_and_verbose(self):
        self.assert_template_refused(2, ["--quiet"], "--quiet", "--verbose")
        self.make("--verbose", warnings=1)
        self.assertEqual(len(self.last.lines("note")), 1)


class Values(GlareTest):
    def check(self, option, *values, **more):
        for value in values:
            with self.subTest(f"{option} '{value}'"):
                self.assert_template_refused(2, [], option, value, **more)

    def test_size(self):
        self.check("--size", "", "0", "-5", "65536", "1e3", "10x", "10x10x10", "0x10", "16.5",
                   "99999999999", size=("--fov-deg", "1"))

    def test_size_has_no_blanks(self):
        self.check("--size", " 64", "64 ", "64x 64", size=("--fov-deg", "1"))

    def test_field_of_view(self):
        self.check("--fov-deg", "", "0", "-1", "nan", "inf", "114.6", "5deg",
                   size=("--size", "16"))

    def test_field_of_view_too_small_for_the_file(self):
        """A pitch that is 0 as a 32-bit float makes a file that can't be read back."""
        self.check("--fov-deg", "1e-300", "1e-50", size=("--size", "16"))

    def test_width(self):
        self.check("--width-mm", "", "0", "-1", "nan", "inf", "wide",
                   aperture=("--pupil", "pupil.png"))

    def test_width_too_small_for_numbers(self):
        self.check("--width-mm", "1e-300", aperture=("--pupil", "pupil.png"))

    def test_built_in_eye(self):
        size = ("--size", "16", "--fov-deg", "1")
        self.check("--pupil-mm", "0", "nan", "inf", "0.9", "10.1", "100",
                   aperture=(), size=size)
        self.check("--seed", "", "-1", "1.5", "18446744073709551616", aperture=(),
                   size=size)

    def test_threads_and_memory(self):
        self.check("--threads", "", "-1", "1.5", "1025")
        self.check("--memory-limit", "-1", "many", "99999999999999999999")

    def test_choices(self):
        self.check("--white", "d65")
        self.check("--normalize", "")
        self.check("--gamut", "", "clip")

    def test_more_memory_than_allowed(self):
        self.assert_template_refused(5, ["memory"], "--memory-limit", "1MB", "--size", "1024",
                                     "--fov-deg", "1", size=())
        self.assert_template_refused(5, ["memory"], "--memory-limit", "64MB", "--fov-deg", "60",
                                     "--size", "16", size=(), aperture=())
        self.make("--memory-limit", "1GB")

    def test_a_preview_counts(self):
        arguments = ("--memory-limit", "16MB", "--size", "700", "--fov-deg", "0.5")
        self.make(*arguments, size=())
        self.assert_template_refused(5, ["memory"], *arguments, "--preview", "p.png", size=())

    def test_the_default_is_three_quarters_of_the_machines(self):
        result = self.assert_template_refused(5, ["memory"], "--size", "65535", "--fov-deg", "2",
                                              size=())
        limits = [os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")]
        for name in ("memory.max", "memory/memory.limit_in_bytes"):
            file = pathlib.Path("/sys/fs/cgroup", name)
            if file.exists() and file.read_text().strip().isdigit():
                limits.append(int(file.read_text()))
        needed, allowed = (float(n) for n in re.findall(r"([\d.e+]+) MB", result.err))
        self.assertGreater(needed, allowed)
        self.assertLessEqual(allowed, min(limits) * 0.75e-6 * 1.001)


class Reach(GlareTest):
    def test_the_message_tells_the_finest_field_and_the_pixels_needed(self):
        result = self.assert_template_refused(2, ["reach", "pixels"],
                                              size=("--fov-deg", "5", "--size", "64"))
        widest_deg = float(re.search(r"--fov-deg ([\d.]+)", result.err).group(1))
        # 380 nm over pixels of 0.5 mm / 64.
        self.assertAlmostEqual(widest_deg, 380e-6 / (0.5 / 64) * 57.29578, delta=1e-3)
        self.make("--fov-deg", f"{widest_deg}", "--size", "64", size=())
        pixels = int(re.search(r"\((\d+) across", result.err).group(1))
        self.write("fine.png", images.png(images.disc(pixels)))
        self.make("--fov-deg", "5", "--size", "64", size=(),
                  aperture=("--pupil", "fine.png", "--width-mm", "0.5"))

    def test_the_height_counts(self):
        self.assert_template_refused(2, ["reach"], "--fov-deg", "2", "--size", "32x64", size=())
        self.make("--fov-deg", "2", "--size", "64x32", size=())

    def test_a_message_stays_short(self):
        result = self.glare("template", "-o", "x.exr", "--pupil", "pupil.png", "--width-mm",
                            "1e300")
        self.assertLess(len(result.err), 500)
