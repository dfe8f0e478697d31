"""Lamp tables and wavelength ranges that can't be used: status 3 or 2, one line, no output."""

import os

from cli import GlareTest


class BadSpectra(GlareTest):
    def check(self, table, *mentions, status=3):
        self.write("lamp.csv", table)
        with self.subTest(table[:40]):
            self.assert_template_refused(status, ["lamp.csv", *mentions], "--lamp", "lamp.csv")

    def test_files_that_are_no_table(self):
        self.assert_template_refused(3, ["nothing.csv", "no such file"], "--lamp", "nothing.csv")
        self.path("folder.csv").mkdir()
        self.assert_template_refused(3, ["folder.csv", "folder"], "--lamp", "folder.csv")
        self.assert_template_refused(3, ["/dev/null"], "--lamp", "/dev/null")
        self.assert_template_refused(3, ["pupil.png"], "--lamp", "pupil.png")
        os.mkfifo(self.path("pipe.csv"))
        self.assert_template_refused(3, ["pipe.csv"], "--lamp", "pipe.csv")

    def test_too_few_rows(self):
        self.check("")
        self.check("\n\n# nothing\n")
        self.check("wavelength_nm,power\n")
        self.check("550,1\n")
        self.check("wavelength_nm,power\n550,1\n")

    def test_text_in_a_number(self):
        self.check("400,1\n500,one\n600,2\n", ":2")
        self.check("400,1\n500nm,1\n600,2\n", ":2")
        self.check("nm,power\n400,1\n500,1.5x\n600,2\n", ":3")
        self.check("400,1\n500\n600,2\n", ":2")
        self.check("400,1\n500,\n600,2\n", ":2")
        self.check("400,1\n500,1e999\n600,2\n", ":2")
        self.check("400,1\n500,0x10\n600,2\n", ":2")

    def test_not_finite(self):
        for bad in ("nan", "-inf"):
            self.check(f"400,1\n500,{bad}\n600,2\n", ":2")
            self.check(f"400,1\n{bad},1\n600,2\n", ":2")

    def test_wavelengths(self):
        self.check("400,1\n500,1\n500,2\n600,2\n", ":3", "line 2")
        self.check("400,1\n500,1\n400.0,1\n", ":3")
        self.check("-400,1\n500,1\n600,2\n", ":1")
        self.check("0,1\n500,1\n600,2\n", ":1")

    def test_power(self):
        self.check("400,1\n500,-0.1\n600,2\n", ":2", "negative")
        self.check("400,0\n500,0\n600,0\n", "0")

    def test_no_light_that_the_observer_sees(self):
        self.check("900,1\n1000,1\n1100,2\n")
        self.check("100,1\n200,1\n300,2\n")
        self.check("400,0\n500,0\n790,0\n900,5\n")

    def test_micrometres_instead_of_nanometres(self):
        self.check("0.4,1\n0.5,1\n0.7,2\n")

    def test_unknown_names(self):
        for name in ("D66", "sunlight", "", "blackbody", "blackbody:", "blackbody:3200:1",
                     "blackbody:nan", "blackbody:inf", "blackbody:499", "blackbody:100001"):
            with self.subTest(name):
                self.assert_template_refused(2, ["lamp" if "body" not in name else "body"],
                                             "--lamp", name)
        for name in ("cie1932", ""):
            self.assert_template_refused(2, ["observer"], "--observer", name)

    def test_ranges(self):
        for lo, hi in (("700", "400"), ("500", "500"), ("nan", "700"), ("400", "inf"),
                       ("0", "700"), ("900", "1000"), ("x", "700")):
            with self.subTest(lo=lo, hi=hi):
                self.assert_template_refused(2, ["range"], "--wavelength-range-nm", lo, hi)
        self.assert_template_refused(2, ["range"], "--wavelength-range-nm", "400")

    def test_a_lamp_dark_in_the_range(self):
        self.write("lamp.csv", "400,1\n500,1\n510,0\n780,0\n")
        self.assert_template_refused(3, ["lamp.csv"], "--lamp", "lamp.csv",
                                     "--wavelength-range-nm", "600", "700")


class MissedLight(GlareTest):
    def test_a_table_that_misses_much_warns(self):
        self.write("lamp.csv", "450,1\n650,1\n")
        self.make("--lamp", "lamp.csv", warnings=1)
        warning, = self.last.lines("warning")
        for word in ("lamp.csv", "450", "650", "%", "misses"):
            self.assertIn(word, warning)
        self.make("--lamp", "lamp.csv", "--quiet")

    def test_a_table_that_misses_little_does_not(self):
        self.write("lamp.csv", "400,1\n700,1\n")
        self.make("--lamp", "lamp.csv")

    def test_the_border_is_one_percent_of_luminous_efficiency(self):
        """From 656 nm on, V(lambda) has 1.9 % of its integral; from 670 nm on, 0.9 %."""
        for end, warnings in ((656, 1), (675, 0)):
            self.write("lamp.csv", f"380,1\n{end},1\n")
            self.make("--lamp", "lamp.csv", warnings=warnings)
