"""The documentation's links lead somewhere, and its commands are the program's."""
import pathlib
import re
import unittest

from cli import GlareTest

GROUPS = ("aperture", "photometry")  # Of commands of two words.
ROOT = pathlib.Path(__file__).resolve().parents[2]


class Docs(GlareTest):
    def pages(self):
        return [ROOT / "README.md", ROOT / "CONTRIBUTING.md", ROOT / "CHANGELOG.md",
                *ROOT.glob("docs/*.md"), *ROOT.glob("data/**/README.md"), ROOT / "cmf/README.md"]

    def test_relative_links(self):
        for page in self.pages():
            text = page.read_text(encoding="utf-8")
            links = re.findall(r"\]\(([^)#:]+)\)", text) + re.findall(r'src="([^":]+)"', text)
            for link in links:
                self.assertTrue((page.parent / link).exists(), f"{page.name}: {link}")

    def test_commands_are_understood(self):
        pages = ("README.md", "docs/photometry.md", "docs/headlamps.md", "docs/apply.md",
                 "docs/kernels.md")
        commands = [command for page in pages for command in
                    re.findall(r"^(glare [a-z].*?)(?:\s+#.*)?$",
                               (ROOT / page).read_text(encoding="utf-8"), re.MULTILINE)]
        self.assertGreater(len(commands), 3)
        for command in commands:
            for option in re.findall(r"--[a-z-]+", command):
                words = command.split()[1:3 if command.split()[1] in GROUPS else 2]
                shown = self.glare(*words, "--help").out
                self.assertIn(option, shown, command)


if __name__ == "__main__":
    unittest.main()
