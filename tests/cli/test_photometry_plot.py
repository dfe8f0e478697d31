"""glare photometry info --plot: drawings that are what the files hold."""

import math
import re
import unittest
import xml.etree.ElementTree as xml

from photometry import PhotometryTest, ies, span
from test_beams import FOLDER, Beam

SVG = "{http://www.w3.org/2000/svg}"


class Drawing:
    """A plot's parts: texts by their place, and what is needed to read angles off its axes."""

    def __init__(self, path):
        self.root = xml.fromstring(path.read_bytes())
        self.texts = [(float(t.get("x")), float(t.get("y")), t.text)
                      for t in self.root.iter(SVG + "text")]
        self.size = float(self.root.get("width")), float(self.root.get("height"))

    def frame(self):
        rect = self.root.find(f"{SVG}clipPath/{SVG}rect")
        return [float(rect.get(name)) for name in ("x", "y", "width", "height")]

    @staticmethod
    def scale(places):
        """Degrees of a place on the page, from the outermost labels."""
        (a, first), (b, last) = min(places), max(places)
        return lambda place: first + (place - a) * (last - first) / (b - a)

    def axes(self):
        left, top, width, height = self.frame()
        number = re.compile(r"-?[\d.]+$")
        across = [(x, float(t)) for x, y, t in self.texts if y == top + height + 18]
        up = [(y - 5, float(t)) for x, y, t in self.texts if x == left - 8 and number.match(t)]
        return self.scale(across), self.scale(up)

    def levels(self):
        """Candela by colour, of the legend."""
        left, _, width, _ = self.frame()
        labels = {y: float(t) for x, y, t in self.texts if x == left + width + 52}
        return {line.get("stroke"): labels[float(line.get("y1")) + 4]
                for line in self.root.iter(SVG + "line") if float(line.get("x1")) > left + width}

    def contours(self):
        for path in self.root.iter(SVG + "path"):
            points = [tuple(map(float, pair.split(",")))
                      for pair in path.get("d")[1:].split()]
            yield path.get("stroke"), points


class Plot(PhotometryTest):
    def plotted(self, file, *arguments):
        result = self.glare("photometry", "info", file, "--plot", "plot.svg", *arguments)
        self.assertEqual((result.status, result.err), (0, ""))
        return Drawing(self.path("plot.svg"))

    def check_lines(self, path, least_levels, *arguments):
        """Every line is where the intensity, interpolated here, is what the legend says."""
        drawing, beam = self.plotted(path, *arguments), Beam(path)
        (h_of, v_of), levels = drawing.axes(), drawing.levels()
        left, top, width, height = drawing.frame()
        step = abs(h_of(0.006) - h_of(0))  # Coordinates have two decimals: 0.005 px either way.
        seen = set()
        for color, points in drawing.contours():
            for x, y in points[::7]:
                if not (left < x < left + width and top < y < top + height):
                    continue
                h, v, level = h_of(x), v_of(y), levels[color]
                near = [beam(h + i * step, v + j * step) for i in (-1, 1) for j in (-1, 1)]
                self.assertLessEqual(min(near) * 0.98, level, (h, v))
                self.assertGreaterEqual(max(near) * 1.02, level, (h, v))
                seen.add(level)
        self.assertGreaterEqual(len(seen), least_levels)

    def test_lines_are_where_the_intensity_is(self):
        self.check_lines(FOLDER / "halogen_high.ies", 7)
        self.check_lines(FOLDER / "led_low_left_hand_traffic.ies", 7)

    def test_a_part(self):
        part = ("--plot-h-deg", "-8", "8", "--plot-v-deg", "-4", "4")
        beam = FOLDER / "halogen_low_right_hand_traffic.ies"
        self.check_lines(beam, 7, *part)
        h_of, v_of = self.plotted(beam, *part).axes()
        left, top, width, height = self.plotted(beam, *part).frame()
        for angle, expected in ((h_of(left), -8), (h_of(left + width), 8), (v_of(top), 4),
                                (v_of(top + height), -4)):
            self.assertAlmostEqual(angle, expected, delta=0.01)
        self.write("c.ies", ies("C", [0], [0, 90], lambda c, g: 1))
        info = ("photometry", "info")
        self.assert_refused(2, ["type C"], *info, "c.ies", "--plot", "x.svg", *part)
        self.assert_refused(2, ["--plot"], *info, beam, *part)
        for wrong in (("5", "-5"), ("-100", "5"), ("nan", "5")):
            self.assert_refused(2, ["H", "ascending"], *info, beam, "--plot", "x.svg",
                                "--plot-h-deg", *wrong)

    def test_lines_around_peaks_and_saddles(self):
        def hills(h, v):
            return 200 * (1.005 + math.cos(math.radians(60 * h)) * math.cos(math.radians(60 * v)))
        self.write("hills.ies", ies("A", span(-11, 11, 1), span(-11, 11, 1), hills))
        self.check_lines(self.path("hills.ies"), 5)
        # At the saddles, 201 cd, the bright parts meet: each dark one inside has a line of its own.
        drawing = self.plotted("hills.ies")
        lines = [points for color, points in drawing.contours() if drawing.levels()[color] == 200]
        self.assertEqual(sum(points[0] == points[-1] for points in lines), 24)

    def test_everything_is_on_the_page(self):
        for kind, horizontal, vertical in (("A", span(-90, 90, 5), span(-90, 90, 5)),
                                           ("B", span(-10, 30, 1), span(-180, 180, 10)),
                                           ("A", [-0.001, 0.001], [-0.001, 0.001]),
                                           ("C", span(0, 360, 15), span(0, 180, 10)),
                                           ("C", [0], [90, 180])):
            for candela in (lambda h, v: 0, lambda h, v: 7, lambda h, v: 1e6 + h * v):
                self.write("lamp.ies", ies(kind, horizontal, vertical, candela, factor=1))
                drawing = self.plotted("lamp.ies")
                self.assertIn("lamp.ies", [text for _, _, text in drawing.texts])
                for x, y, text in drawing.texts:
                    self.assertTrue(0 <= x <= drawing.size[0] and 0 <= y <= drawing.size[1], text)

    def test_polar_curves(self):
        # Brightest at C 0, gamma 60; the other half-planes are dimmer, from 90 on all is dark.
        self.write("street.ies", ies("C", span(0, 360, 90), span(0, 180, 15), lambda c, g: 0
                                     if g >= 90 else 1000 * (1 + (c % 360 == 0) * (g == 60))))
        drawing = self.plotted("street.ies")
        curves = [[tuple(map(float, pair.split(","))) for pair in line.get("points").split()]
                  for line in drawing.root.iter(SVG + "polyline")]
        self.assertEqual(len(curves), 4)
        middle = drawing.size[0] / 2
        self.assertEqual([max(points)[0] > middle + 1 for points in curves],
                         [True, False, True, False])
        reach = [max(((x - middle) ** 2 + (y - 100) ** 2) ** 0.5 for x, y in points)
                 for points in curves]
        for other in reach[1:]:
            self.assertAlmostEqual(reach[0] / other, 2, delta=1e-3)
        self.assertNotIn("120°", [text for _, _, text in drawing.texts])

    def test_names_cannot_break_the_drawing(self):
        name = 'a&b<c>"d".ies'
        self.write(name, ies("A", [-5, 5], [-5, 5], lambda h, v: 10))
        self.assertIn(name, [text for _, _, text in self.plotted(name).texts])

    def test_the_same_bytes_each_time(self):
        drawings = []
        for _ in range(2):
            self.plotted(FOLDER / "hid_low_right_hand_traffic.ies")
            drawings.append(self.path("plot.svg").read_bytes())
        self.assertEqual(*drawings)

    def test_refused(self):
        beam = FOLDER / "hid_high.ies"
        self.write("drawing.svg", ies("A", [-5, 5], [-5, 5], lambda h, v: 10))
        for status, word, file, plot in ((2, ".svg", beam, "plot.png"), (2, "input", beam, beam),
                                         (2, "input", "drawing.svg", "./drawing.svg"),
                                         (2, "empty", beam, ""),
                                         (4, "folder", beam, "nowhere/plot.svg")):
            with self.subTest(word):
                self.assert_refused(status, [word], "photometry", "info", file, "--plot", plot)


if __name__ == "__main__":
    unittest.main()
