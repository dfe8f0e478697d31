"""Scenes and command lines that glare headlamp refuses: a line, a status and its place."""

import pathlib
import re
import unittest

import exr
import images
from headlamps import HeadlampTest
from test_tonemap import CONFIG

LAMP = '[[lamps]]\nposition_m = [0, 0, 50]\nintensity_cd = 100\ntemplate = "t.exr"\n'


class BadScenes(HeadlampTest):
    def assert_scene_refused(self, text, *mentions, status=3, arguments=("-o", "out.exr")):
        self.write("bad.toml", text)
        self.assert_refused(status, mentions, "headlamp", "bad.toml", *arguments)

    def test_no_toml(self):
        self.assert_refused(3, ["none.toml", "no such file"], "headlamp", "none.toml", "-o",
                            "a.png")
        self.assert_scene_refused("mode = 'paper'\nx = [1,\n", "bad.toml:")
        self.assert_scene_refused("\n\nmode = \n", "bad.toml:3", "column")
        self.assert_scene_refused(b"\xff\xfe\x00".decode("latin1") + "\0", "bad.toml:1")
        self.assert_scene_refused("x = " + "[" * 5000, "bad.toml")

    def test_unknown_keys(self):
        self.assert_scene_refused("\nbackgroud = 1\n" + LAMP, "bad.toml:2", "backgroud",
                                  "background")
        self.assert_scene_refused(LAMP + "\n[viewer]\nage = 3\n", "bad.toml:7", "'age'",
                                  "age_years")
        self.assert_scene_refused(LAMP + "pos = 3\n", "bad.toml:5", "'pos'", "[[lamps]]")
        self.assert_scene_refused(LAMP + "[eye]\npupil_um = 3\n", "bad.toml:6", "pupil_um",
                                  "pupil_mm")

    def test_values(self):
        for key, value in (("yaw_deg", '"2"'), ("yaw_deg", "nan"), ("yaw_deg", "1e9"),
                           ("flux_factor", "-1"), ("flux_factor", "true"), ("name", "3"),
                           ("name", '""'), ("vehicle", '"car"'), ("spectrum", '"hid"'),
                           ("position_px", "[1, 2]"), ("distance_m", "3"), ("intensity", '"a"'),
                           ("h_deg", "[1, 2]"), ("gamma_zero", '"up"')):
            self.assert_scene_refused(LAMP + f"{key} = {value}\n", "bad.toml:", key)
        self.assert_scene_refused(LAMP.replace("[0, 0, 50]", "[0, 50]"), "bad.toml:2", "position_m")
        self.assert_scene_refused(LAMP.replace("position_m = [0, 0, 50]\n", ""), "bad.toml:1")
        self.assert_scene_refused(LAMP.replace("intensity_cd = 100\n", ""), "bad.toml:1",
                                  "intensity")
        self.assert_scene_refused("", "bad.toml", "lamp")
        self.assert_scene_refused("lamps = 3", "bad.toml:1", "lamps")
        self.assert_scene_refused("viewer = 3\n" + LAMP, "bad.toml:1", "viewer")
        for line, word in (("horizontal_fov_deg = 180", "horizontal_fov_deg"),
                           ("size_px = [0, 5]", "size_px"),
                           ("first_frame = 1", "first_frame"), ("size_px = [1.5, 2]", "size_px"),
                           ('file = "a{frame}.exr"\nluminance_cd_m2 = 1', "luminance_cd_m2"),
                           ("luminance_scale_cd_m2 = 1", "luminance_scale_cd_m2")):
            self.assert_scene_refused(LAMP + f"[background]\n{line}\n", "bad.toml:", word)
        many = LAMP + '[background]\nfile = "a{frame}.exr"\nlast_frame = 200000\n'
        self.assert_scene_refused(many, "bad.toml", "at most 100000")
        for line, word in (("frames = 3", "frames"), ("path_m = [[0, 0, 0], [0, 0, 1]]", "path_m"),
                           ("path_m = [1, 2, 3]", "path_m"), ("path_m = []", "path_m"),
                           ("line_of_sight = [0, 0, 0]", "line_of_sight"),
                           ("pigment = 2", "pigment")):
            self.assert_scene_refused(LAMP + f"[viewer]\n{line}\n", "bad.toml:", word)
        for line, word in (("pupil_mm = 90", "pupil"), ("seed = 1.5", "seed"),
                           ("seed = -1", "seed"),
                           ("upper_lashes = 1.5", "upper_lashes"), ("width_mm = 3", "width_mm"),
                           ('pupil = "pupil.png"\nseed = 1\nlid_opening_mm = 3', "lid_opening_mm")):
            self.assert_scene_refused(LAMP + f"[eye]\n{line}\n", "bad.toml:", word)
        self.assert_scene_refused(LAMP + '[tone_mapping]\ncurve = "reinhard"\n', "bad.toml:6",
                                  "sigmoid")
        self.assert_scene_refused(LAMP + LAMP.replace("template", 'name = "lamp1"\ntemplate'),
                                  "bad.toml:8", "lamp1")

    def test_files(self):
        self.write("short.exr", exr.encode({c: [1] * 4 for c in "RGB"}, 2, 2)[:-3])
        self.assert_scene_refused(LAMP.replace("t.exr", "no.exr"), "no.exr", "no such file")
        self.assert_scene_refused(LAMP.replace("t.exr", "short.exr"), "short.exr")
        self.assert_scene_refused(LAMP.replace("intensity_cd = 100", 'intensity = "no.ies"'),
                                  "no.ies")
        self.write("bad.ies", "IESNA:LM-63-2002\nTILT=NONE\n1 2\n")
        self.assert_scene_refused(LAMP.replace("intensity_cd = 100", 'intensity = "bad.ies"'),
                                  "bad.ies:3")
        for file in ("no.exr", "short.exr", "bg_{frame}.exr"):
            self.assert_scene_refused(LAMP + f'[background]\nfile = "{file}"\n',
                                      file.replace("{frame}", "0001"))
        self.assert_scene_refused(LAMP.replace('template = "t.exr"', 'spectrum = "nolamp"'),
                                  "nolamp")
        self.assert_scene_refused(LAMP + "[viewer]\npath_m = [[0, 0, 50]]\n", "bad.toml:1", "eye")

    def test_command_lines(self):
        self.write("s.toml", LAMP)
        for arguments, mentions in (((), ["--output"]), (("-o", "a.jpg"), [".png"]),
                                    (("-o", "a.png", "--half"), ["--half"]),
                                    (("-o", "a.exr", "--bits", "16"), ["--bits"]),
                                    (("--report", "a.txt"), [".csv"]),
                                    (("--report", "a.csv", "--resume"), ["--resume"]),
                                    (("--report", "a.csv", "--report", "a.csv"), ["same file"]),
                                    (("-o", "t.exr"), ["t.exr", "input"]),
                                    (("-o", "a.png", "--angles", "0:3:1"), ["{frame}"]),
                                    (("--report", "a.csv", "--report-angles", "0"),
                                     ["--report-angles"]),
                                    (("--report", "a.csv", "--report-angles", "1,2,1"),
                                     ["--report-angles", "twice"]),
                                    (("-o", "a.png", "--mode", "art"), ["--mode"])):
            self.assert_refused(2, mentions, "headlamp", "s.toml", *arguments)
        self.assert_refused(4, ["nofolder"], "headlamp", "s.toml", "-o", "nofolder/a.png")
        self.assert_refused(4, ["nofolder"], "headlamp", "s.toml", "--report", "nofolder/a.csv")
        self.assert_refused(5, ["memory"], "headlamp", "s.toml", "-o", "a.png", "--memory-limit",
                            "30MB")

    def test_views(self):
        view = LAMP + '[tone_mapping]\nview = "Root"\n'
        self.assert_scene_refused(view, "bad.toml:6", "$OCIO")
        self.assert_scene_refused(view + 'ocio = "no.ocio"\n', "no.ocio")
        self.write("config.ocio", CONFIG)
        self.assert_scene_refused(view + 'ocio = "config.ocio"\nk = 3\n', "bad.toml:8",
                                  "k and ocio")
        self.assert_scene_refused(view.replace("Root", "Film") + 'ocio = "config.ocio"\n', "'Film'")

    def test_check_makes_nothing(self):
        self.write("s.toml", LAMP.replace('template = "t.exr"', 'spectrum = "hid"'))
        before = self.files()
        result = self.glare("headlamp", "s.toml", "--check", "-o", "a.png")
        self.assertEqual((result.status, result.out, result.err), (0, "", ""))
        self.assertEqual(self.files(), before)

    def test_check_reads_all_backgrounds(self):
        for number in (1, 2):
            self.write(f"bg_{number:04}.png", images.png([[40] * 64] * 48))
        self.scene(background={"file": "bg_{frame}.png", "last_frame": 2, "horizontal_fov_deg": 2})
        self.run_headlamp("--check")
        self.write("bg_0002.png", images.png([[40] * 63] * 48))
        self.assert_refused(3, ["bg_0002.png", "size"], "headlamp", "scene.toml", "--check")

    def test_a_lamp_that_shines_elsewhere(self):
        self.write("c.ies", "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 3 1 1 2 0 0 0\n1 1 10\n"
                            "0 10 20\n0\n1000 500 0\n")
        self.scene(lamps=[{"position_m": [0, 0, 50], "intensity": "c.ies"}])
        text = self.path("scene.toml").read_text(encoding="utf-8")
        text = text.replace("intensity_cd = 10000\n", "")
        self.write("scene.toml", text)
        result = self.glare("headlamp", "scene.toml", "--report", "r.csv")
        self.assertEqual(result.status, 0)
        self.assertIn("no light towards the eye", result.err)
        self.assertIn("gamma_zero", result.err)
        self.write("scene.toml", text.replace('"c.ies"', '"c.ies"\ngamma_zero = "forward"'))
        self.assertNotIn("no light", self.glare("headlamp", "scene.toml", "--report", "r.csv").err)

    def test_half_is_limited(self):
        self.scene(lamps=[{"position_m": [0, 0, 1]}])
        result = self.glare("headlamp", "scene.toml", "-o", "h.exr", "--half")
        self.assertEqual(result.status, 0)
        self.assertIn("65504", result.err)
        self.assertEqual(max(exr.read(self.path("h.exr")).channels["G"]), 65504)

    def test_a_border_that_shows(self):
        self.write("s.toml", LAMP)
        result = self.glare("headlamp", "s.toml", "-o", "a.png")
        self.assertEqual(result.status, 0)
        self.assertEqual(len(result.lines("warning")), 1, result.err)
        self.assertIn("fov_deg", result.err)


class Documentation(HeadlampTest):
    """docs/headlamps.md says what the program knows."""
    ROOT = pathlib.Path(__file__).resolve().parents[2]

    def setUp(self):
        super().setUp()
        self.page = (self.ROOT / "docs/headlamps.md").read_text(encoding="utf-8")

    def test_its_scene(self):
        scene, = re.findall(r"```toml\n(.*?)```", self.page, re.DOTALL)
        self.write("night.toml", scene)
        self.write("street.exr", exr.encode({c: [0.1] * 64 for c in "RGB"}, 8, 8))
        self.write("high_beam.ies", (self.ROOT / "data/photometry/hid_high.ies").read_bytes())
        self.run_headlamp("--check", scene="night.toml")

    def test_every_key(self):
        for table in ("", "[background]", "[viewer]", "[[vehicles]]", "[[lamps]]", "[template]",
                      "[tone_mapping]", "[paper]"):
            lines = {"[[vehicles]]": 'name = "car"\nposition_m = [0, 0, 1]\n',
                     "[[lamps]]": LAMP.split("\n", 1)[1]}
            lamp = "" if table == "[[lamps]]" else LAMP
            self.write("s.toml", f"{table}\n{lines.get(table, '')}no_key = 1\n{lamp}")
            err = self.glare("headlamp", "s.toml", "--check").err
            keys = err.split("there are ")[1].strip().split(", ")
            self.assertGreater(len(keys), 0)
            for key in keys:
                self.assertRegex(self.page, rf"`{key}`|\[{key}\]", table)

    def test_every_column(self):
        self.write("s.toml", LAMP)
        self.run_headlamp("--report", "r.csv", "--report-angles", "3", scene="s.toml")
        header = self.path("r.csv").read_text(encoding="utf-8").splitlines()[0]
        for column in header.split(","):
            self.assertIn(f"`{column.replace('3deg', 'Adeg')}`", self.page)


if __name__ == "__main__":
    unittest.main()
