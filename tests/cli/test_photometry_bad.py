"""Photometric files that are damaged: an error with the line, status 3, never shifted data."""

import unittest

import images
from photometry import PhotometryTest, ies, ldt, span

GOOD = ies("C", [0, 45, 90], [0, 30, 60, 90], lambda c, g: 100 + c + g)
# Of GOOD: 1 to 3 the header, 4 TILT, 5 and 6 the luminaire, 7 and 8 the angles, 9 to 11 candela.
GOOD_LDT = ldt(2, span(0, 330, 30), span(0, 90, 30), [[100 + c, 90, 50, 0] for c in range(7)])
FIRST_PLANE = 43  # The line of EULUMDAT's first C angle, with one set of lamps.


def with_line(text, number, line):
    lines = text.splitlines()
    lines[number - 1:number] = [] if line is None else [line]
    return "\n".join(lines) + "\n"


class Bad(PhotometryTest):
    def check(self, name, text, *words):
        self.write(name, text)
        result = self.assert_refused(3, [name, *words], "photometry", "info", name, "--json")
        self.assert_refused(3, [name], "photometry", "info", name, "--plot", "plot.svg")
        return result

    def test_the_good_ones_are_good(self):
        self.write("good.ies", GOOD)
        self.write("good.ldt", GOOD_LDT)
        self.assertEqual(self.told("good.ies")["symmetry"], "quadrants")
        self.assertEqual(self.told("good.ldt")["symmetry"], "C0-C180")
        self.assertEqual(GOOD_LDT.splitlines()[FIRST_PLANE - 1:FIRST_PLANE + 2], ["0", "30", "60"])

    def test_lm_63(self):
        for line, text, words in (
                (4, None, ["TILT"]),
                (5, "1 -1 1 5 3 1 2 0 0 0", ["bad.ies:8", "ascend"]),  # One more V than there are.
                (5, "1 -1 1 4 4 1 2 0 0 0", ["bad.ies:11", "ends"]),
                (5, "1 -1 1 4 2 1 2 0 0 0", ["bad.ies"]),
                (5, "1 -1 1 4 3 4 2 0 0 0", ["bad.ies:5", "photometric type"]),
                (5, "1 -1 1 4 3 1 3 0 0 0", ["bad.ies:5", "units"]),
                (5, "1 -1 0 4 3 1 2 0 0 0", ["bad.ies:5", "multiplier"]),
                (5, "1 -1 1 1e9 3 1 2 0 0 0", ["bad.ies:5"]),
                (5, "1 -1 1 20000 20000 1 2 0 0 0", ["bad.ies"]),
                (5, "1 -1 1 4 3 1 2 0 0", ["bad.ies"]),
                (6, "1 1 ten", ["bad.ies:6", "ten"]),
                (7, "0 30 20 90", ["bad.ies:7", "ascend"]),
                (8, "0 45 80", ["bad.ies:8"]),
                (8, "0 nan 90", ["bad.ies:8", "nan"]),
                (10, "145 175 205", ["bad.ies"]),
                (10, "145 175 -205 235", ["bad.ies:10", "-205"]),
                (11, "190 220 250", ["bad.ies:11", "ends"]),
                (11, "190 220 250 280 310", ["bad.ies:11", "left over"]),
                (11, "190 220 inf 280", ["bad.ies:11"])):
            with self.subTest((line, text)):
                self.check("bad.ies", with_line(GOOD, line, text), *words)

    def test_cut_anywhere(self):
        words = GOOD.split(" ")
        for count in range(5, len(words) - 1, 7):
            self.check("cut.ies", " ".join(words[:count]))

    def test_eulumdat(self):
        for line, text, words in (
                (3, "5", ["bad.ldt"]),
                (4, "13", ["bad.ldt"]),
                (6, "5", ["bad.ldt"]),
                (FIRST_PLANE + 1, "thirty", [f"bad.ldt:{FIRST_PLANE + 1}", "thirty"]),
                (FIRST_PLANE + 2, "20", [f"bad.ldt:{FIRST_PLANE + 2}", "ascend"]),
                (FIRST_PLANE + 12 + 4 + 2, "", [f"bad.ldt:{FIRST_PLANE + 18}", "empty"]),
                (FIRST_PLANE + 12 + 4 + 3, "-1", [f"bad.ldt:{FIRST_PLANE + 19}"]),
                (FIRST_PLANE + 12 + 4 + 3, None, ["bad.ldt", "ends"]),
                (FIRST_PLANE + 12 + 4 + 3, "1\n2", ["bad.ldt:", "left over"])):
            with self.subTest((line, text)):
                self.check("bad.ldt", with_line(GOOD_LDT, line, text), *words)

    def test_what_is_no_photometry(self):
        self.check("text.ies", "Dear reader,\n")
        self.check("empty.ldt", "")
        self.check("any.txt", "1\n2\n3\n", "neither")
        self.check("zeros.ies", "TILT=NONE\n" + "\0" * 100)
        self.check("half.png", images.cut(images.png(images.disc(64)), 0.5))
        self.path("folder.ies").mkdir()
        for name, word in (("folder.ies", "folder"), ("nothing.ies", "no such file"),
                           ("/dev/null", "/dev/null")):
            self.assert_refused(3, [word], "photometry", "info", name)


if __name__ == "__main__":
    unittest.main()
