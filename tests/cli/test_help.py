"""glare --help and --version."""

import re

from cli import GlareTest

OPTIONS = ("-o", "--output", "--pupil", "--eyelashes", "--width-mm", "--lamp", "--observer",
           "--wavelength-range-nm", "--size", "--fov-deg", "--colorspace", "--ocio", "--white",
           "--normalize", "--gamut", "--half", "--preview", "--threads", "--quiet", "--verbose")


class Help(GlareTest):
    def text(self, *arguments):
        result = self.glare(*arguments)
        self.assertEqual((result.status, result.err), (0, ""))
        return result.out

    def test_program(self):
        for option in ("--help", "-h"):
            text = self.text(option)
            for word in ("template", "info", "lamps", "tonemap", "--version"):
                self.assertIn(word, text)

    def test_template_tells_every_option(self):
        words = set(re.findall(r"-{1,2}[a-z-]+", self.text("template", "--help")))
        self.assertLessEqual(set(OPTIONS), words)

    def test_template_tells_the_defaults(self):
        text = self.text("template", "--help")
        for default in ("D65", "cie1931-2deg", "512", "lin_rec709", "none", "peak", "keep"):
            self.assertIn("=" + default, text)

    def test_others(self):
        for command in ("info", "lamps"):
            self.assertIn("--json", self.text(command, "--help"))

    def test_version(self):
        self.assertRegex(self.text("--version"), r"^glare \d+\.\d+\.\d+\n$")
