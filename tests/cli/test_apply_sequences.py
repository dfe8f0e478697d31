"""glare apply: sequences, those that are stopped and go on among them."""

import signal
import subprocess
import time
import unittest

import exr
from apply import ApplyTest, impulse
from cli import PROGRAM, TIMEOUT_S

FRAMES = 24
SIZE = (480, 270)  # Large enough that the process is stopped long before the last frame.
SCALE = ("--fov-deg", "8")


class Sequence(ApplyTest):
    frames = {}  # Made once: their content.

    def setUp(self):
        super().setUp()
        if not self.frames:
            for number in range(1, FRAMES + 1):
                self.frames[f"in.{number:04}.exr"] = exr.encode(
                    impulse(*SIZE, 10 * number, 100), *SIZE)
        for name, content in self.frames.items():
            self.write(name, content)
        for folder in ("whole", "stopped"):
            self.path(folder).mkdir()

    def command(self, folder, *arguments, frames=f"1-{FRAMES}", picture="in.%04d.exr",
                output="out.####.exr"):
        return ["apply", picture, "--template", "t.exr", *SCALE, "--frames", frames, "-o",
                f"{folder}/{output}", *arguments]

    def content(self, folder):
        return {p.name: p.read_bytes() for p in self.path(folder).iterdir()}

    def frame(self, number):
        return self.path(f"stopped/out.{number:04}.exr")

    def make_all(self, folder, *arguments, **options):
        result = self.glare(*self.command(folder, *arguments, **options))
        self.assertEqual((result.status, result.err), (0, ""))
        return self.content(folder)

    def times(self):
        return {p.name: p.stat().st_mtime_ns for p in self.path("stopped").iterdir()}


class Frames(Sequence):
    def test_are_as_single_pictures(self):
        whole = self.make_all("whole", frames="1-7x3,20")
        self.assertEqual(whole.keys(), {f"out.{i:04}.exr" for i in (1, 4, 7, 20)}
                         | {"out.frames.exr.glare-frames"})
        self.apply(*SCALE, picture="in.0004.exr")
        self.assertEqual(whole["out.0004.exr"], self.path("out.exr").read_bytes())

    def test_names(self):
        for pattern, name in (("%d", "3"), ("%3d", "  3"), ("%05d", "00003"), ("##", "03"),
                              ("{frame}", "0003")):
            whole = self.make_all("whole", frames="3", output=pattern + ".exr")
            self.assertIn(name + ".exr", whole)

    def test_of_other_sizes_and_scales(self):
        camera = {"glare:horizontalFov_deg": ("float", b"\0\0\0\x41")}
        self.write("b.0001.exr", exr.encode(impulse(40, 30, 20, 15), 40, 30, camera))
        self.write("b.0002.exr", exr.encode(impulse(60, 50, 20, 15), 60, 50, camera))
        result = self.glare("apply", "b.####.exr", "--template", "t.exr", "--frames", "1-2", "-o",
                            "whole/b.####.exr")
        self.assertEqual((result.status, result.err), (0, ""))
        self.apply(picture="b.0002.exr")
        self.assertEqual(self.path("whole/b.0002.exr").read_bytes(),
                         self.path("out.exr").read_bytes())

    def test_what_is_wrong_in_frames_is_told_once(self):
        for number in (2, 3):
            channels = impulse(*SIZE, 10, 10)
            channels["G"][5] = -1.0
            self.write(f"in.{number:04}.exr", exr.encode(channels, *SIZE))
        result = self.glare(*self.command("whole", frames="1-4"))
        self.assertEqual((result.status, len(result.lines("warning"))), (0, 1), result.err)
        self.assertIn("negative channel: 2 (in frames: 2)", result.err)

    def test_refusals(self):
        def refused(status, words, **options):
            self.assert_refused(status, words, *self.command("whole", **options))
        refused(3, ["in.0025.exr", "frame 25"], frames="20-30")
        for frames in ("", "5-3", "1-4x0", "a", "1,", "-3", "1-9999999", "1-99999999999"):
            refused(2, ["--frames"], frames=frames)
        refused(2, ["%04d"], output="out.exr")
        refused(2, ["%04d"], picture="in.exr")
        refused(2, ["one frame number"], output="#.####.exr")
        refused(2, ["input"], output="../in.%04d.exr")
        self.assert_refused_for(2, ["--frames"], *SCALE, "--resume", picture="in.0001.exr")
        self.write("whole/out.frames.exr.glare-frames", "mine")
        refused(4, ["no record"])

    def test_a_damaged_frame(self):
        self.write("in.0002.exr", self.frames["in.0002.exr"][:5000])
        result = self.glare(*self.command("stopped", "--threads", "1"))
        self.assertEqual((result.status, len(result.err.splitlines())), (3, 1))
        self.assertIn("in.0002.exr", result.err)
        self.assertFalse(self.frame(2).exists())


class Resuming(Sequence):
    def stop(self, number, after_frames):
        with subprocess.Popen([PROGRAM, *self.command("stopped", "--threads", "1")],
                              cwd=self.folder, env=self.environment) as process:
            end = time.monotonic() + TIMEOUT_S
            while not self.frame(after_frames).exists():
                self.assertLess(time.monotonic(), end)
                time.sleep(0.001)
            process.send_signal(number)
            return process.wait(timeout=TIMEOUT_S)

    def test_killed(self):
        whole = self.make_all("whole")
        self.assertEqual(len(whole), FRAMES + 1)
        self.assertEqual(self.stop(signal.SIGKILL, 4), -signal.SIGKILL)
        self.assertFalse(self.frame(FRAMES).exists(), "was not stopped half-way")
        before = self.times()
        self.write("stopped/.out.0009.exr.glare-999999999-3", "of a process that can't be")
        self.assertEqual(self.make_all("stopped", "--resume"), whole)
        after = self.times()
        for number in range(1, 4):  # Of the fourth, the record may not be there yet.
            self.assertEqual(before[self.frame(number).name], after[self.frame(number).name])

    def test_interrupted(self):
        whole = self.make_all("whole")
        for number, status in ((signal.SIGINT, 130), (signal.SIGTERM, 143)):
            self.assertEqual(self.stop(number, 3), status)
            left = self.content("stopped")
            self.assertLess(len(left), FRAMES)
            for name in left.keys() - {"out.frames.exr.glare-frames"}:
                self.assertEqual(left[name], whole[name], name)
            self.assertEqual(self.make_all("stopped", "--resume"), whole)
            for path in self.path("stopped").iterdir():
                path.unlink()

    def test_only_whole_frames_of_these_inputs_are_kept(self):
        few = {"frames": "1-6"}
        whole = self.make_all("stopped", **few)
        self.frame(2).write_bytes(whole["out.0002.exr"][:1000])  # Half-written.
        self.frame(3).unlink()
        self.write("in.0005.exr", exr.encode(impulse(*SIZE, 7, 7), *SIZE))  # Another picture.
        before = self.times()
        changed = self.make_all("stopped", "--resume", **few)
        after = self.times()
        self.assertEqual({name for name in after if after[name] != before.get(name)},
                         {f"out.{i:04}.exr" for i in (2, 3, 5)} | {"out.frames.exr.glare-frames"})
        self.assertEqual({name for name in whole if whole[name] != changed[name]},
                         {"out.0005.exr", "out.frames.exr.glare-frames"})
        # Other options, another template: all are made again.
        faded = self.make_all("stopped", "--resume", "--roll-off", "0.5", **few)
        brighter = self.make_all("stopped", "--resume", "--exposure", "1", **few)
        self.write("t.exr", self.made["odd.exr"])
        other = self.make_all("stopped", "--resume", "--exposure", "1", "--quiet", **few)
        for name in whole:
            self.assertNotEqual(faded[name], changed[name], name)
            self.assertNotEqual(brighter[name], faded[name], name)
            self.assertNotEqual(other[name], brighter[name], name)


if __name__ == "__main__":
    unittest.main()
