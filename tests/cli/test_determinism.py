"""The same command gives the same bytes, on any number of threads."""

from cli import APERTURE, GlareTest


class Determinism(GlareTest):
    def check(self, *arguments, **options):
        made = set()
        for threads in ("1", "2", "1", "0"):
            self.make("--threads", threads, "--preview", "p.png", *arguments, **options)
            made.add((self.path("out.exr").read_bytes(), self.path("p.png").read_bytes()))
        self.assertEqual(len(made), 1)

    def test_image(self):
        self.check("--size", "130x71", "--lamp", "FL11", "--white", "lamp", size=("--fov-deg", "2"))

    def test_built_in_eye(self):
        self.check("--size", "96", aperture=(), size=())

    def test_half(self):
        self.check("--half", "--quiet", "--gamut", "desaturate", "--normalize", "energy")

    def test_more_threads_than_processors(self):
        """And none of the libraries speaks up about it."""
        self.make("--threads", "1")
        one = self.path("out.exr").read_bytes()
        self.make("--threads", "64")
        self.assertEqual(self.path("out.exr").read_bytes(), one)

    def test_folder_and_output_name_do_not_count(self):
        self.make()
        self.path("sub").mkdir()
        self.make(output="sub/other.exr", aperture=(
            "--pupil", str(self.path("pupil.png")), *APERTURE[2:]))
        self.assertEqual(self.path("out.exr").read_bytes(), self.path("sub/other.exr").read_bytes())
