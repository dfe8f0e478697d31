"""Runs the program under test, named by the environment variable GLARE, in a temporary folder."""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest
from dataclasses import dataclass

import exr
import images

PROGRAM = os.environ.get("GLARE", "glare")
TIMEOUT_S = 60
# A small template of a small aperture: 0.5 mm over 64 pixels reaches 2.7 degrees.
APERTURE = ("--pupil", "pupil.png", "--width-mm", "0.5")
SMALL = ("--size", "64", "--fov-deg", "2")


@dataclass
class Result:
    status: int
    out: str
    err: str

    def lines(self, kind):
        """The messages of a kind: "error", "warning" or "note"."""
        return [line for line in self.err.splitlines() if line.startswith(f"glare: {kind}: ")]


class GlareTest(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="glare-cli-")
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        self.environment = {k: v for k, v in os.environ.items() if not k.startswith("OCIO")}
        self.write("pupil.png", images.png(images.disc(64)))

    def path(self, name):
        return self.folder / name

    def write(self, name, content):
        data = content.encode() if isinstance(content, str) else content
        self.path(name).write_bytes(data)
        return name

    def files(self):
        """Every file and its content; what is no regular file has none."""
        return {str(p.relative_to(self.folder)): p.read_bytes() if p.is_file() else None
                for p in sorted(self.folder.rglob("*"))}

    def glare(self, *arguments, **options):
        options = {"timeout": TIMEOUT_S} | options
        done = subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder,
                              env=self.environment, stdin=subprocess.DEVNULL, capture_output=True,
                              **options)
        return Result(done.returncode, done.stdout.decode(errors="replace"),
                      done.stderr.decode(errors="replace"))

    def make(self, *arguments, output="out.exr", aperture=APERTURE, size=SMALL, warnings=0,
             **options):
        """Makes a template of the small aperture, which must succeed, and reads it."""
        result = self.glare("template", "-o", output, *aperture, *size, *arguments, **options)
        self.assertEqual(result.status, 0, result.err)
        self.assertEqual(len(result.err.splitlines()), warnings, result.err)
        self.last = result
        return exr.read(self.path(output))

    def assert_refused(self, status, mentions, *command, **options):
        """The command ends with the status and one line with all the words, and writes nothing."""
        before = self.files()
        result = self.glare(*command, **options)
        self.assertEqual(result.status, status, f"{command}: {result.err or result.out}")
        self.assertEqual(len(result.lines("error")), 1, f"{command}: {result.err}")
        self.assertEqual(len(result.err.splitlines()), 1, f"{command}: {result.err}")
        for word in mentions:
            self.assertIn(word.lower(), result.err.lower(), command)
        self.assertEqual(result.out, "", command)
        self.assertEqual(self.files().keys(), before.keys(), command)
        self.assertEqual(self.files(), before, command)
        return result

    def assert_template_refused(self, status, mentions, *arguments, aperture=APERTURE, size=SMALL,
                                output="out.exr", **options):
        return self.assert_refused(status, mentions, "template", "-o", output, *aperture, *size,
                                   *arguments, **options)

    def info(self, name):
        result = self.glare("info", name, "--json")
        self.assertEqual((result.status, result.err), (0, ""))
        return json.loads(result.out)

    def assert_same_pixels(self, a, b, relative=0.0):
        """Same channels to a share of each channel's largest value."""
        self.assertEqual(a.size, b.size)
        self.assertEqual(a.channels.keys(), b.channels.keys())
        for name, values in a.channels.items():
            allowed = relative * max(map(abs, values))
            worst = max(abs(x - y) for x, y in zip(values, b.channels[name]))
            self.assertLessEqual(worst, allowed, f"channel {name}")
