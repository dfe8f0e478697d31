"""Several lamps on one aperture: a file for each, the same as the lamp makes alone."""

import json
import os
import signal
import subprocess
import time

import exr
from cli import APERTURE, PROGRAM, SMALL, TIMEOUT_S, GlareTest

TABLES = {"wide.csv": "380,1\n780,5\n", "from 420.csv": "420,5\n700,1\n", "to 560.csv": "380,1\n560,5\n"}


def lamps(*names):
    return [word for name in names for word in ("--lamp", name)]


class ManyLampsTest(GlareTest):
    def setUp(self):
        super().setUp()
        for name, table in TABLES.items():
            self.write(name, table)

    def make_all(self, names, *arguments, output="glare_{lamp}.exr", aperture=APERTURE, size=SMALL,
                 **options):
        result = self.glare("template", "-o", output, *lamps(*names), *aperture, *size, *arguments,
                            **options)
        self.assertEqual(result.status, 0, result.err)
        return result

    def refused(self, status, mentions, *arguments, **options):
        return self.assert_template_refused(status, mentions, *arguments,
                                            **{"output": "{lamp}.exr"} | options)


class Bytes(ManyLampsTest):
    NAMES = ("A", "hid", "led", "blackbody:3200", *TABLES)

    def check(self, *arguments, **options):
        before = {"pupil.png", *TABLES}
        self.make_all(self.NAMES, *arguments, "--quiet", "--preview", "{lamp}.png", **options)
        words = [name.replace(":", "-").removesuffix(".csv") for name in self.NAMES]
        self.assertEqual(set(self.files()) - before,
                         {f"glare_{w}.exr" for w in words} | {f"{w}.png" for w in words})
        for name, word in zip(self.NAMES, words):
            with self.subTest(name):
                self.make_all((name,), *arguments, "--quiet", "--preview", "1.png",
                              output="1.exr", **options)
                for one, of_many in (("1.exr", f"glare_{word}.exr"), ("1.png", f"{word}.png")):
                    self.assertTrue(self.path(one).read_bytes() == self.path(of_many).read_bytes(),
                                    of_many)

    def test_of_pictures(self):
        """Tables that begin or end elsewhere may need another far field."""
        self.check("--half", "--white", "lamp")

    def test_of_the_built_in_eye(self):
        """A lamp of longer wavelengths needs an eye with coarser pixels."""
        self.check(aperture=(), size=("--size", "48", "--fov-deg", "5"))

    def test_of_wide_pixels(self):
        """Pixels of about one cycle of the finest detail, and of three: at 560 nm they are more of
        them than at 780 nm, and the far field is sampled less finely."""
        self.check(size=("--size", "9", "--fov-deg", "0.81"))
        for name in set(self.files()) - {"pupil.png", *TABLES}:
            self.path(name).unlink()
        self.check(size=("--size", "9", "--fov-deg", "2.5"))

    def test_the_order_makes_no_difference(self):
        self.make_all(self.NAMES, "--quiet")
        made = self.files()
        self.make_all(self.NAMES[::-1], "--quiet", "--threads", "1")
        self.assertTrue(self.files() == made)

    def test_each_recipe_makes_its_file_alone(self):
        self.make_all(("A", "wide.csv", "blackbody:3200"), "--size", "40x30", "--fov-deg", "1",
                      size=())
        for word, lamp in (("A", "A"), ("wide", "wide.csv"), ("blackbody-3200", "blackbody:3200")):
            picture = exr.read(self.path(f"glare_{word}.exr"))
            self.assertEqual(picture.attributes["glare:lamp"], lamp)
            recipe = json.loads(picture.attributes["glare:recipe"])
            command = recipe["command"]
            self.assertEqual([command[i + 1] for i, w in enumerate(command) if w == "--lamp"],
                             [lamp])
            self.assertEqual([i["file"] for i in recipe["inputs"]],
                             ["pupil.png"] + ([lamp] if lamp in TABLES else []))
            result = self.glare(*command[1:], "-o", "again.exr")
            self.assertEqual(result.status, 0, result.err)
            self.assertEqual(self.path("again.exr").read_bytes(),
                             self.path(f"glare_{word}.exr").read_bytes())


class Names(ManyLampsTest):
    def made(self, names, output, *arguments):
        before = set(self.files())
        self.make_all(names, *arguments, output=output)
        return {name for name in set(self.files()) - before}

    def test_one_lamp_may_be_named_too(self):
        self.assertEqual(self.made(("D65",), "{lamp}.exr"), {"D65.exr"})
        self.assertEqual(self.made((), "default {lamp}.exr"), {"default D65.exr"})
        self.assertEqual(self.made(("led",), "1.exr", "--preview", "{lamp}.png"),
                         {"1.exr", "led.png"})

    def test_anywhere_in_the_name(self):
        for name in ("A", "led"):
            self.path(name).mkdir()
        self.assertEqual(self.made(("A", "led"), "{lamp}/x{lamp}-{lamp}.exr"),
                         {"A/xA-A.exr", "led/xled-led.exr"})

    def test_a_file_gives_its_stem(self):
        self.path("sub").mkdir()
        self.write("sub/lab.v2.csv", TABLES["wide.csv"])
        self.write("no ending", TABLES["wide.csv"])
        self.write("Lampe – é.csv", TABLES["wide.csv"])
        self.assertEqual(self.made(("sub/lab.v2.csv", "./no ending", "Lampe – é.csv"), "{lamp}.exr"),
                         {"lab.v2.exr", "no ending.exr", "Lampe – é.exr"})

    def test_characters_that_some_file_systems_reserve(self):
        name = 'a:b*c?d"e<f>g|h\\i\nj.csv'
        self.write(name, TABLES["wide.csv"])
        self.assertEqual(self.made((name, "BlackBody:3200.5"), "{lamp}.exr"),
                         {"a-b-c-d-e-f-g-h-i-j.exr", "BlackBody-3200.5.exr"})

    def test_a_file_called_like_the_placeholder(self):
        self.write("{lamp}.csv", TABLES["wide.csv"])
        self.assertEqual(self.made(("{lamp}.csv", "A"), "x{lamp}.exr"), {"x{lamp}.exr", "xA.exr"})

    def test_verbose_tells_a_line_for_each(self):
        result = self.make_all(("A", "wide.csv"), "--verbose")
        notes = result.lines("note")
        self.assertEqual(len(notes), len(result.err.splitlines()))
        self.assertEqual(len(notes), 2)
        self.assertTrue(any("glare_A.exr" in n and "lamp A" in n for n in notes), notes)
        self.assertTrue(any("glare_wide.exr" in n and "wide.csv" in n for n in notes), notes)

    def test_warnings_name_the_lamp(self):
        result = self.make_all(("A", "to 560.csv"))
        warning, = result.lines("warning")
        self.assertIn("to 560.csv", warning)


class Refusals(ManyLampsTest):
    """Nothing is written, whichever of the lamps it is about."""

    def test_no_place_for_the_lamp(self):
        self.refused(2, ["--output", "{lamp}"], *lamps("A", "D65"), output="out.exr")
        self.refused(2, ["--preview", "{lamp}"], *lamps("A", "D65"), "--preview", "p.png")

    def test_files_of_the_same_name(self):
        self.path("sub").mkdir()
        self.write("a.csv", TABLES["wide.csv"])
        self.write("sub/wide.csv", TABLES["wide.csv"])
        for a, b in (("A", "a.csv"), ("A", "A"), ("D65", "d65"), ("wide.csv", "sub/wide.csv"),
                     ("wide.csv", "./wide.csv"), ("blackbody:3200", "BLACKBODY:3200")):
            self.refused(2, ["same name", a, b], *lamps("HP1", a, b))

    def test_outputs_that_are_one_file(self):
        self.write("D50.exr", "old")
        self.path("A.exr").symlink_to("D50.exr")
        self.refused(2, ["same file"], *lamps("A", "D50"))
        self.refused(2, ["same file"], *lamps("HP1", "HP2"), "--preview", "{lamp}", output="{lamp}")

    def test_an_output_is_no_input(self):
        self.write("D50", self.path("pupil.png").read_bytes())
        self.refused(2, ["D50", "input"], *lamps("A", "D50"), output="{lamp}",
                     aperture=("--pupil", "D50", "--width-mm", "0.5"))
        self.write("lamp.exr", TABLES["wide.csv"])
        self.refused(2, ["lamp.exr", "input"], *lamps("A", "./lamp.exr"))
        self.refused(2, ["lamp.exr", "input"], *lamps("A", "wide.csv", "lamp.exr"),
                     output="./{lamp}.exr")

    def test_the_name_of_a_lamp_is_no_input(self):
        self.make_all(("A", "D65"), output="{lamp}")
        self.assertIn("D65", self.files())

    def test_a_lamp_that_is_none(self):
        self.write("bad.csv", "400,x\n500,1\n")
        self.refused(2, ["bogus"], *lamps("A", "bogus"))
        self.refused(2, ["''"], *lamps("A", ""))
        self.refused(2, ["{}"], *lamps("{}"))
        self.refused(3, ["missing.csv"], *lamps("A", "missing.csv"))
        self.refused(3, ["bad.csv"], *lamps("A", "bad.csv"))

    def test_a_lamp_without_light_in_the_range(self):
        self.write("dark.csv", "400,1\n500,1\n510,0\n780,0\n")
        self.refused(3, ["dark.csv"], *lamps("A", "dark.csv"), "--wavelength-range-nm", 600, 700)

    def test_where_no_file_can_be_written(self):
        self.path("A").mkdir()
        self.refused(4, ["led/x.exr", "folder"], *lamps("A", "led"), output="{lamp}/x.exr")
        self.path("led.exr").mkdir()
        self.refused(4, ["led.exr"], *lamps("A", "led"))
        self.path("hid.png").mkdir()
        self.refused(4, ["hid.png"], *lamps("A", "hid"), "--preview", "{lamp}.png")

    def test_beyond_the_reach_of_one_of_them(self):
        wide = ("--size", "32", "--fov-deg", "2.9")  # 380 nm reaches 2.79 degrees, 420 nm 3.08.
        self.make_all(("from 420.csv",), size=wide)
        self.refused(2, ["reach"], *lamps("from 420.csv", "A"), size=wide)

    def test_more_memory_than_allowed(self):
        self.refused(5, ["memory"], *lamps("from 420.csv", "A"), "--memory-limit", "1MB",
                     size=("--size", "1024", "--fov-deg", "1"))

    def test_endings(self):
        self.refused(2, [".exr"], *lamps("A", "led"), output="{lamp}.png")
        self.refused(2, [".png"], *lamps("A", "led"), "--preview", "{lamp}.tif")


class Interruption(ManyLampsTest):
    def test_finished_files_stay_and_nothing_else(self):
        names = [f"blackbody:{kelvin}" for kelvin in range(2000, 2400)]
        made = self.folder / "made"
        made.mkdir()
        with subprocess.Popen([PROGRAM, "template", "-o", "made/{lamp}.exr", *lamps(*names),
                               "--threads", "1", "--size", "200", "--fov-deg", "4"],
                              cwd=self.folder, env=self.environment, stderr=subprocess.PIPE,
                              text=True) as process:
            deadline = time.monotonic() + TIMEOUT_S
            while len(list(made.glob("*.exr"))) < 2 and time.monotonic() < deadline:
                time.sleep(0.01)
            self.assertIsNone(process.poll(), "ended before the signal")
            process.send_signal(signal.SIGINT)
            _, err = process.communicate(timeout=TIMEOUT_S)
        self.assertEqual((process.returncode, err), (130, ""))
        files = os.listdir(made)
        self.assertTrue(2 <= len(files) < len(names), len(files))
        for name in files:
            self.assertEqual(exr.read(made / name).size, (200, 200))  # No temporary, all whole.
