"""Sequences of glare headlamp that are stopped and go on, and templates that are kept."""

import json
import signal
import subprocess
import time
import unittest

import images
from cli import PROGRAM, TIMEOUT_S
from headlamps import HeadlampTest

FRAMES = 40
# Large enough that the process is stopped long before the last frame.
SIZE = {"luminance_cd_m2": 0.5, "size_px": [640, 360], "horizontal_fov_deg": 8}


class Resuming(HeadlampTest):
    def setUp(self):
        super().setUp()
        self.scene(background=SIZE,
                   lamps=[{"position_m": [-1, 0, 80]}, {"position_m": [-2, 0, 81]}],
                   viewer={"path_m": [[0, 0, 0], [0, 0, 40]], "frames": FRAMES})
        for folder in ("whole", "stopped"):
            self.path(folder).mkdir()

    def command(self, folder, *arguments):
        return ["headlamp", "scene.toml", "--quiet", "-o", f"{folder}/f_{{frame}}.png", "--report",
                f"{folder}/r.csv", *arguments]

    def content(self, folder):
        return {p.name: p.read_bytes() for p in self.path(folder).iterdir()}

    def frame(self, number):
        return self.path(f"stopped/f_{number:04}.png")

    def make_all(self, folder, *arguments):
        result = self.glare(*self.command(folder, *arguments))
        self.assertEqual((result.status, result.err), (0, ""))
        return self.content(folder)

    def stop(self, number, after_frames):
        with subprocess.Popen([PROGRAM, *self.command("stopped", "--threads", "1")],
                              cwd=self.folder, env=self.environment) as process:
            end = time.monotonic() + TIMEOUT_S
            while not self.frame(after_frames).exists():
                self.assertLess(time.monotonic(), end)
                time.sleep(0.001)
            process.send_signal(number)
            return process.wait(timeout=TIMEOUT_S)

    def times(self):
        return {p.name: p.stat().st_mtime_ns for p in self.path("stopped").iterdir()}

    def test_killed(self):
        whole = self.make_all("whole")
        self.assertEqual(len(whole), FRAMES + 2)  # The report and the record too.
        self.assertEqual(self.stop(signal.SIGKILL, 6), -signal.SIGKILL)
        self.assertFalse(self.frame(FRAMES).exists(), "was not stopped half-way")
        before = self.times()
        self.write("stopped/.f_0009.png.glare-999999999-3", "of a process that can't be")
        self.assertEqual(self.make_all("stopped", "--resume"), whole)
        after = self.times()
        for number in range(1, 6):  # Of the sixth, the record may not be there yet.
            self.assertEqual(before[self.frame(number).name], after[self.frame(number).name])

    def test_interrupted(self):
        whole = self.make_all("whole")
        self.assertEqual(self.stop(signal.SIGINT, 3), 130)
        left = self.content("stopped")
        self.assertLess(len(left), FRAMES)
        for name in left.keys() - {"f_frames.png.glare-frames"}:
            self.assertEqual(left[name], whole[name], name)
        self.assertEqual(self.make_all("stopped", "--resume"), whole)

    def test_only_whole_frames_of_this_scene_are_kept(self):
        whole = self.make_all("stopped")
        self.frame(3).write_bytes(whole["f_0003.png"][:1000])  # Half-written.
        self.frame(5).write_bytes(whole["f_0006.png"])  # Another one.
        self.frame(7).unlink()
        record = self.path("stopped/f_frames.png.glare-frames")
        record.write_bytes(record.read_bytes()[:-30])  # Its last line is cut.
        before = self.times()
        self.assertEqual(self.make_all("stopped", "--resume"), whole)
        changed = {name for name, when in self.times().items() if when != before.get(name)}
        self.assertEqual(changed, {f"f_{i:04}.png" for i in (3, 5, 7, FRAMES)}
                         | {"r.csv", "f_frames.png.glare-frames"})
        # Other options and another scene: all are made again.
        deep = self.make_all("stopped", "--resume", "--bits", "16")
        text = self.path("scene.toml").read_text(encoding="utf-8")
        self.write("scene.toml", text.replace("10000", "20000"))
        brighter = self.make_all("stopped", "--resume", "--bits", "16")
        for name in whole:
            self.assertNotEqual(deep[name] if name != "r.csv" else 0, whole[name], name)
            self.assertNotEqual(brighter[name], deep[name], name)

    def test_a_changed_background(self):
        for number in (1, 2, 3):
            self.write(f"bg_{number:04}.png", images.png([[40 * number] * 64] * 48))
        self.scene(background={"file": "bg_{frame}.png", "last_frame": 3, "horizontal_fov_deg": 2})
        whole = self.make_all("stopped")
        self.write("bg_0002.png", images.png([[200] * 64] * 48))
        changed = self.make_all("stopped", "--resume")
        differ = {name for name in whole if whole[name] != changed[name]}
        self.assertEqual(differ, {"f_0002.png", "f_frames.png.glare-frames", "r.csv"})

    def test_the_record_takes_no_other_files_place(self):
        self.write("stopped/f_frames.png.glare-frames", "mine")
        self.assert_refused(4, ["f_frames.png.glare-frames", "no record"],
                            *self.command("stopped"))

    def test_a_record_that_was_cut_short_is_not_believed(self):
        whole = self.make_all("stopped")
        for left in (b"", b'{"glare_fr'):
            self.write("stopped/f_frames.png.glare-frames", left)
            self.assertEqual(self.make_all("stopped", "--resume"), whole)


class Templates(HeadlampTest):
    SMALL = {"size_px": [64, 64], "fov_deg": 2}

    def spectra(self, *names, **tables):
        self.write("pupil.toml", "")
        self.scene(lamps=[{"position_m": [i, 0, 50]} | {"spectrum": name}
                          for i, name in enumerate(names)],
                   eye={"pupil": "pupil.png", "width_mm": 0.5}, **{"template": self.SMALL} | tables)
        text = self.path("scene.toml").read_text(encoding="utf-8")
        self.write("scene.toml", text.replace('template = "t.exr"\n', ""))

    def cached(self):
        return {p.name: (p.read_bytes(), p.stat().st_mtime_ns)
                for p in self.path("cache/glare/templates").iterdir()}

    def test_made_once_and_kept(self):
        self.spectra("hid", "A", "hid")
        self.run_headlamp("-o", "a.exr")
        first = self.cached()
        self.assertEqual(len(first), 4)  # Two templates, each with its fingerprint.
        self.run_headlamp("-o", "b.exr")
        self.assertEqual(self.cached(), first)
        self.assertEqual(self.path("a.exr").read_bytes(), self.path("b.exr").read_bytes())

    def test_is_the_one_of_glare_template(self):
        self.spectra("hid")
        self.run_headlamp("-o", "a.exr")
        made, = (content for name, (content, _) in self.cached().items() if name.endswith(".exr"))
        self.make("--lamp", "hid", "--normalize", "absolute",
                  size=("--size", "64x64", "--fov-deg", "2"),
                  output="same.exr")
        self.assertEqual(made, self.path("same.exr").read_bytes())

    def test_damaged_ones_are_made_again(self):
        self.spectra("hid")
        self.run_headlamp("-o", "a.exr")
        first = self.cached()
        name = next(name for name in first if name.endswith(".exr"))
        content = first[name][0]
        for damaged in (content[:-100], content[:500] + b"x" + content[501:], b""):
            self.path("cache/glare/templates/" + name).write_bytes(damaged)
            self.run_headlamp("-o", "b.exr")
            self.assertEqual(self.cached()[name][0], content)
            self.assertEqual(self.path("a.exr").read_bytes(), self.path("b.exr").read_bytes())

    def test_another_eye_is_another_template(self):
        self.spectra("hid")
        self.run_headlamp("-o", "a.exr", "--template-cache", "mine")
        self.spectra("hid", template=self.SMALL | {"fov_deg": 1})
        self.run_headlamp("-o", "b.exr", "--template-cache", "mine")
        self.assertEqual(len(list(self.path("mine").glob("*.exr"))), 2)
        self.assertFalse(self.path("cache").exists())

    def test_built_in_eye(self):
        self.scene(lamps=[{"position_m": [0, 0, 50], "spectrum": "A"}],
                   eye={"seed": 3, "pupil_mm": 2, "upper_lashes": 10, "clear_media": True},
                   template=self.SMALL | {"scatter": "cie"}, viewer={"age_years": 50})
        text = self.path("scene.toml").read_text(encoding="utf-8")
        self.write("scene.toml", text.replace('template = "t.exr"\n', ""))
        self.run_headlamp("-o", "a.exr")
        name = next(name for name in self.cached() if name.endswith(".exr"))
        info = self.info("cache/glare/templates/" + name)
        self.assertEqual(info["scatter"]["age_years"], 50)
        recipe = json.loads(info["recipe"])["command"] if isinstance(info["recipe"], str) \
            else info["recipe"]["command"]
        for option, value in (("--seed", "3"), ("--pupil-mm", "2"), ("--upper-lashes", "10"),
                              ("--lens-particles-per-mm2", "0")):
            self.assertEqual(recipe[recipe.index(option) + 1], value)


if __name__ == "__main__":
    unittest.main()
