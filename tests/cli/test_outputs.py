"""Where output goes: complete or not there, the older file kept until then, a preview."""

import os
import pathlib
import resource
import shutil
import stat
import subprocess
import unittest

import images
from cli import APERTURE, PROGRAM, SMALL, TIMEOUT_S, GlareTest

NOBODY = 65534


def limit_file_size(size):
    return lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))


class Places(GlareTest):
    def test_folder_missing(self):
        self.assert_template_refused(4, ["no/out.exr", "folder"], output="no/out.exr")
        self.assert_template_refused(4, ["pupil.png"], output="pupil.png/out.exr")
        self.assert_template_refused(4, ["no/p.png", "folder"], "--preview", "no/p.png")

    def test_output_is_no_regular_file(self):
        self.path("dir.exr").mkdir()
        self.path("dir.png").mkdir()
        os.mkfifo(self.path("pipe.exr"))
        self.path("loop.exr").symlink_to("loop.exr")
        self.path("null.exr").symlink_to("/dev/null")
        for name in ("dir.exr", "pipe.exr", "loop.exr", "null.exr"):
            self.assert_template_refused(4, [name], output=name)
        self.assert_template_refused(4, ["dir.png"], "--preview", "dir.png")

    def test_names_that_are_refused(self):
        self.assert_template_refused(2, ["output", "empty"], output="")
        self.assert_template_refused(2, ["output", ".exr"], output="out.png")
        for name in (".", "/", "out.exr/"):
            self.assert_template_refused(4, [name], output=name)
        self.assert_template_refused(2, ["preview", ".png"], "--preview", "other.exr")
        self.assert_template_refused(4, ["too long"], output="x" * 300 + ".exr")

    def test_names_that_are_taken(self):
        for name in ("a b.exr", "Blende – é.exr", "-out.exr", "OUT.EXR", "x" * 251 + ".exr",
                     "new\nline.exr"):
            self.make(output=name)

    def test_a_link_stays_and_what_it_points_to_is_replaced(self):
        self.write("target.exr", "old")
        self.path("link.exr").symlink_to("target.exr")
        self.make(output="link.exr")
        self.assertTrue(self.path("link.exr").is_symlink())
        self.assertGreater(self.path("target.exr").stat().st_size, 1000)

    def test_an_output_is_no_input_and_no_other_output(self):
        self.write("same.exr", self.path("pupil.png").read_bytes())  # The content tells the kind.
        self.assert_template_refused(2, ["same.exr", "input"], output="./same.exr",
                                     aperture=("--pupil", "same.exr", "--width-mm", "0.5"))
        self.assertEqual(self.path("same.exr").read_bytes(), self.path("pupil.png").read_bytes())
        self.assert_template_refused(2, ["same file"], "--preview", "both", output="both")

    def test_permissions(self):
        os.chmod(self.path("pupil.png"), 0o644)
        self.make(preexec_fn=lambda: os.umask(0o027))
        self.assertEqual(stat.S_IMODE(self.path("out.exr").stat().st_mode), 0o640)
        os.chmod(self.path("out.exr"), 0o604)
        self.make()
        self.assertEqual(stat.S_IMODE(self.path("out.exr").stat().st_mode), 0o604)


class ReadOnly(GlareTest):
    def setUp(self):
        super().setUp()
        self.options = {}
        if os.geteuid() == 0:  # Permissions don't bind root.
            self.options = {"user": NOBODY, "group": NOBODY, "extra_groups": []}
            os.chmod(self.folder, 0o755)
            try:
                works = self.glare("--version", **self.options).status == 0
            except OSError:
                works = False
            if not works:
                self.skipTest("runs as root, and nobody can't run the program")

    def test_folder(self):
        self.path("fixed").mkdir()
        os.chmod(self.path("fixed"), 0o555)
        self.assert_template_refused(4, ["fixed/out.exr", "not writable"], output="fixed/out.exr",
                                     **self.options)

    def test_file(self):
        self.path("open").mkdir()
        os.chmod(self.path("open"), 0o777)
        self.write("open/out.exr", "old")
        os.chmod(self.path("open/out.exr"), 0o444)
        self.assert_template_refused(4, ["open/out.exr"], output="open/out.exr", **self.options)

    def test_unreadable_inputs(self):
        self.write("lamp.csv", "400,1\n700,1\n")
        for name, option in (("pupil.png", APERTURE),
                             ("lamp.csv", (*APERTURE, "--lamp", "lamp.csv"))):
            os.chmod(self.path(name), 0)
            self.path("open").mkdir(exist_ok=True)
            os.chmod(self.path("open"), 0o777)
            self.assert_template_refused(3, [name, "permission"], aperture=option,
                                         output="open/out.exr", **self.options)
            os.chmod(self.path(name), 0o644)


class FullDisk(GlareTest):
    def test_file_size_limit(self):
        for old in (None, "old"):
            if old:
                self.write("out.exr", old)
            for size in (0, 1000):
                self.assert_template_refused(4, ["out.exr"], preexec_fn=limit_file_size(size))

    def mounted(self, options, script):
        """Runs a script in a file system of its own that only it sees, on the folder `disk`."""
        if os.geteuid() != 0 or not shutil.which("unshare"):
            self.skipTest("may not mount")
        self.path("disk").mkdir()
        mount = f"mount -t tmpfs -o {options} none disk"
        if subprocess.run(["unshare", "-m", "sh", "-c", mount], cwd=self.folder,
                          capture_output=True).returncode:
            self.skipTest("may not mount")
        command = f'{mount} || exit 99; {script}; status=$?; ls -A disk; exit $status'
        done = subprocess.run(["unshare", "-m", "sh", "-c", command, "sh", PROGRAM, "template",
                               *APERTURE, *SMALL], cwd=self.folder, env=self.environment,
                              capture_output=True, text=True, timeout=TIMEOUT_S)
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        self.assertIn("glare: error: disk/out.exr", done.stderr)
        self.assertEqual(done.returncode, 4)
        return done

    def test_no_space(self):
        done = self.mounted("size=16k", '"$@" -o disk/out.exr')
        self.assertIn("space", done.stderr)
        self.assertEqual(done.stdout, "")

    def test_no_space_leaves_the_old_file(self):
        done = self.mounted("size=16k", 'echo old > disk/out.exr; "$@" -o disk/out.exr; s=$?; '
                            'cat disk/out.exr; (exit $s)')
        self.assertEqual(done.stdout, "old\nout.exr\n")

    def test_read_only_file_system(self):
        done = self.mounted("size=64k", 'mount -o remount,ro disk; "$@" -o disk/out.exr')
        self.assertIn("read-only", done.stderr)
        self.assertEqual(done.stdout, "")


class Preview(GlareTest):
    def test_is_a_png_of_the_same_size(self):
        self.make("--preview", "p.png", "--size", "33x20", "--fov-deg", "2", size=())
        width, height, bits, kind, pixels = images.png_size(self.path("p.png").read_bytes())
        self.assertEqual((width, height, bits, kind), (33, 20, 8, images.RGB))
        self.assertGreater(max(pixels), 200)

    def test_changes_nothing_in_the_template(self):
        self.make()
        plain = self.path("out.exr").read_bytes()
        self.make("--preview", "p.png")
        self.assertEqual(self.path("out.exr").read_bytes(), plain)

    def test_of_xyz_and_other_spaces_shows_the_same(self):
        shown = []
        for space in ("xyz", "lin_rec709", "acescg"):
            self.make("--colorspace", space, "--preview", "p.png")
            shown.append(images.png_size(self.path("p.png").read_bytes())[4])
        for other in shown[1:]:  # Rounding may turn a step of 8 bits.
            self.assertLessEqual(max(abs(a - b) for a, b in zip(shown[0], other)), 2)


class StandardOutput(GlareTest):
    @unittest.skipUnless(pathlib.Path("/dev/full").exists(), "needs /dev/full")
    def test_full(self):
        self.make()
        for command in (("lamps",), ("lamps", "--json"), ("info", "out.exr"), ("--help",),
                        ("--version",), ("template", "--help")):
            with self.subTest(command), open("/dev/full", "w") as full:
                done = subprocess.run([PROGRAM, *command], cwd=self.folder, stdout=full,
                                      stderr=subprocess.PIPE, text=True, timeout=TIMEOUT_S)
                self.assertEqual(done.returncode, 4)
                self.assertEqual(len(done.stderr.splitlines()), 1)

    def test_closed_streams(self):
        """What is opened next must not be taken for the error stream."""
        command = f'exec "{PROGRAM}" template -o out.exr {" ".join(APERTURE + SMALL)} <&- >&- 2>&-'
        done = subprocess.run(["sh", "-c", command], cwd=self.folder, timeout=TIMEOUT_S)
        self.assertEqual(done.returncode, 0)
        self.assertEqual(self.info("out.exr")["width_px"], 64)
