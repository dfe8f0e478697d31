"""glare lamps, the lamps' names, and the ways in which a table may be written."""

import json

from cli import GlareTest

ROWS = [(380, 0.5), (431.5, 2.25), (500, 1), (560, 3.75), (640.25, 0.125), (780, 1.5)]
PLAIN = "".join(f"{nm},{power}\n" for nm, power in ROWS)


class Tables(GlareTest):
    def test_variants_agree(self):
        def rows(separator, decimal="."):
            return "".join(f"{nm}{separator}{power}\n".replace(".", decimal) for nm, power in ROWS)
        self.write("plain.csv", PLAIN)
        plain = self.make("--lamp", "plain.csv")
        for name, table in {
                "quoted": '"nm","power"\n' + PLAIN,
                "two headers": "My lamp\nwavelength (nm),power (W/nm)\n" + PLAIN,
                "semicolon": rows(";"), "decimal comma": rows(";", ","), "tab": rows("\t"),
                "tab and decimal comma": rows("\t", ","), "blank": rows("  "),
                "spaces": rows(" , "), "comments": "# lamp\n" + PLAIN.replace("\n", " # x\n"),
                "empty lines": PLAIN.replace("\n", "\n\n"),
                "mark and header": "\ufeffnm,power\n" + PLAIN,
                "crlf": PLAIN.replace("\n", "\r\n"),
                "cr": PLAIN.replace("\n", "\r"), "no last end of line": PLAIN.rstrip("\n"),
                "descending": "".join(reversed(PLAIN.splitlines(True))),
                "third column": PLAIN.replace("\n", ",7\n"), "plus": "+" + PLAIN,
                "exponents": "".join(f"{nm / 100:e}e2,{p}\n".replace("e+00e2", "e2")
                                     for nm, p in ROWS)}.items():
            with self.subTest(name):
                self.write("lamp.csv", table)
                self.assert_same_pixels(plain, self.make("--lamp", "lamp.csv"), 1e-12)

    def test_irregular_steps_are_linear_between_rows(self):
        """A row on the line between two others changes nothing but rounding."""
        self.write("plain.csv", "380,1\n780,5\n")
        self.write("more.csv", "380,1\n400,1.2\n401,1.21\n655.5,3.755\n780,5\n")
        self.assert_same_pixels(self.make("--lamp", "plain.csv"), self.make("--lamp", "more.csv"),
                                1e-6)

    def test_power_has_no_unit(self):
        self.write("plain.csv", PLAIN)
        for factor in (1e-30, 1e30):
            self.write("scaled.csv", "".join(f"{nm},{p * factor}\n" for nm, p in ROWS))
            self.assert_same_pixels(self.make("--lamp", "plain.csv"),
                                    self.make("--lamp", "scaled.csv"), 1e-6)

    def test_the_file_carries_the_tables_name(self):
        self.path("sub").mkdir()
        self.write("sub/my lamp.csv", PLAIN)
        self.assertEqual(self.make("--lamp", "sub/my lamp.csv").attributes["glare:lamp"],
                         "my lamp.csv")


class Names(GlareTest):
    def test_aliases(self):
        for alias, name in (("halogen", "A"), ("hid", "HP5"), ("led", "LED-B4")):
            self.assert_same_pixels(self.make("--lamp", alias), self.make("--lamp", name))
            self.assertEqual(self.last.status, 0)

    def test_case_does_not_count(self):
        for a, b in (("d65", "D65"), ("LED-RGB1", "led-rgb1"), ("Halogen", "a"),
                     ("BlackBody:3200", "blackbody:3200")):
            self.assert_same_pixels(self.make("--lamp", a), self.make("--lamp", b))

    def test_black_body(self):
        picture = self.make("--lamp", "blackbody:3200")
        self.assertEqual(picture.attributes["glare:lamp"], "blackbody:3200")
        x, y, z = picture.attributes["glare:lampXYZ"]
        # Planck's law through the CIE 1931 observer at 3200 K: x = 0.4234, y = 0.3990.
        self.assertAlmostEqual(x / (x + y + z), 0.4234, delta=2e-4)
        self.assertAlmostEqual(y / (x + y + z), 0.3990, delta=2e-4)
        self.make("--lamp", "blackbody:500")
        self.make("--lamp", "blackbody:100000")


class Lamps(GlareTest):
    # CIE 015:2018.
    KNOWN_XY = {"A": (0.4476, 0.4074), "D50": (0.3457, 0.3585), "D65": (0.3127, 0.3290),
                "E": (0.3333, 0.3333), "FL2": (0.3721, 0.3751), "FL11": (0.3805, 0.3769),
                "HP1": (0.5330, 0.4150), "LED-B4": (0.3422, 0.3502)}

    def test_json(self):
        result = self.glare("lamps", "--json")
        self.assertEqual((result.status, result.err), (0, ""))
        lamps = {lamp["name"]: lamp for lamp in json.loads(result.out)}
        for lamp in lamps.values():
            self.assertLessEqual({"name", "alias", "description", "cie1931_xy", "range_nm"},
                                 lamp.keys())
        for name, xy in self.KNOWN_XY.items():
            for value, expected in zip(lamps[name]["cie1931_xy"], xy):
                self.assertAlmostEqual(value, expected, delta=5e-4)
        self.assertEqual({lamp["alias"] for lamp in lamps.values() if lamp["alias"]},
                         {"halogen", "hid", "led"})

    def test_text_lists_the_same(self):
        text = self.glare("lamps").out
        for lamp in json.loads(self.glare("lamps", "--json").out):
            self.assertIn(lamp["name"] + " ", text)
            self.assertIn(lamp["description"], text)
        self.assertIn("blackbody:KELVIN", text)

    def test_every_lamp_can_be_used(self):
        """None of them misses so much that it warns."""
        for lamp in json.loads(self.glare("lamps", "--json").out)[::9]:
            self.make("--lamp", lamp["name"], "--size", "8", "--fov-deg", "0.5", size=())

    def test_no_further_words(self):
        self.assert_refused(2, ["extra"], "lamps", "extra")
