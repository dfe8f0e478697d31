"""Straylight on the command line: --scatter, and info's --cie and --plot."""

import json
import struct
import xml.dom.minidom

import exr
from cli import GlareTest


class Scatter(GlareTest):
    def test_attributes_and_recipe(self):
        a = self.make("--scatter", "cie", "--age", "24.5", "--pigment", "1").attributes
        self.assertEqual(a["glare:scatter"], "cie146")
        self.assertEqual((a["glare:scatterAge_years"], a["glare:scatterPigment"]), (24.5, 1))
        self.assertTrue(0.4 < a["glare:scatteredEnergy"] < 0.5)
        command = json.loads(a["glare:recipe"])["command"]
        self.assertIn("--scatter cie --age 24.5 --pigment 1", " ".join(command))
        result = self.glare(*command[1:], "-o", "again.exr")
        self.assertEqual(result.status, 0, result.err)
        self.assertEqual(self.path("again.exr").read_bytes(), self.path("out.exr").read_bytes())

    def test_defaults(self):
        a = self.make("--scatter", "cie").attributes
        self.assertEqual((a["glare:scatterAge_years"], a["glare:scatterPigment"]), (35, 0.5))

    def test_off_by_default(self):
        a = self.make().attributes
        self.assertFalse([name for name in a if "scatter" in name])
        self.assertNotIn("scatter", a["glare:recipe"])
        plain = self.path("out.exr").read_bytes()
        self.make("--scatter", "none")
        self.assertEqual(self.path("out.exr").read_bytes(), plain)

    def test_the_same_on_any_number_of_threads(self):
        self.make("--scatter", "cie", "--threads", "1")
        one = self.path("out.exr").read_bytes()
        self.make("--scatter", "cie", "--threads", "2")
        self.assertEqual(self.path("out.exr").read_bytes(), one)

    def test_it_takes_from_the_core_what_it_spreads(self):
        plain = self.make("--normalize", "absolute", "--colorspace", "xyz")
        whole = self.make("--normalize", "absolute", "--colorspace", "xyz", "--scatter", "cie")
        kept = 1 - whole.attributes["glare:scatteredEnergy"]
        added = [w - kept * p for w, p in zip(whole.channels["Y"], plain.channels["Y"])]
        pitch = whole.attributes["glare:pixelPitch_deg"]
        for pixels in (10, 20, 31):  # 0.3 to 1 degree.
            angle = pixels * pitch
            p, factor = 0.5, 1 + (35 / 62.5) ** 4
            cie = 10 / angle**3 + (5 / angle**2 + 0.1 * p / angle) * factor + 0.0025 * p
            self.assertAlmostEqual(added[32 * 64 + 32 + pixels] / cie, 1, delta=0.01)

    def test_bad_values(self):
        for option, values in (("--age", ("-1", "101", "nan", "inf", "old", "")),
                               ("--pigment", ("-0.1", "1.3", "nan", "brown", ""))):
            for value in values:
                with self.subTest(f"{option} {value}"):
                    self.assert_template_refused(2, [option.removeprefix("--")], "--scatter",
                                                 "cie", option, value)
        self.assert_template_refused(2, ["--scatter"], "--scatter", "mie")
        for option in ("--age", "--pigment"):
            self.assert_template_refused(2, [option, "--scatter"], option, "1")
            self.assert_template_refused(2, [option, "--scatter"], "--scatter", "none", option, "1")


class Cie(GlareTest):
    def info_with(self, *options):
        result = self.glare("info", "out.exr", "--json", *options)
        self.assertEqual((result.status, result.err), (0, ""))
        return json.loads(result.out)

    def test_json(self):
        self.make("--scatter", "cie", "--age", "70", "--pigment", "1")
        info = self.info_with("--cie")
        self.assertEqual(info["cie"], {"age_years": 70, "pigment": 1})
        self.assertEqual(info["scatter"]["model"], "cie146")
        self.assertEqual(info["scatter"]["age_years"], 70)
        for ring in info["radial_profile"]:
            if ring["inner_deg"] < 0.0999:
                self.assertIsNone(ring["cie_per_steradian"])
                self.assertIsNone(ring["ratio_to_cie"])
                continue
            self.assertAlmostEqual(ring["ratio_to_cie"] * ring["cie_per_steradian"],
                                   ring["mean_per_steradian"], delta=1e-9
                                   * ring["mean_per_steradian"])

    def test_which_eye(self):
        self.make()
        self.assertEqual(self.info_with("--cie")["cie"], {"age_years": 35, "pigment": 0.5})
        self.assertIsNone(self.info_with("--cie")["scatter"])
        self.assertEqual(self.info_with("--cie", "--age", "24")["cie"],
                         {"age_years": 24, "pigment": 0.5})
        self.make("--scatter", "cie", "--age", "70", "--pigment", "1")
        self.assertEqual(self.info_with("--cie", "--pigment", "0")["cie"],
                         {"age_years": 70, "pigment": 0})

    def test_without_it_nothing_is_said(self):
        self.make()
        info = self.info_with()
        self.assertNotIn("cie", info)
        self.assertNotIn("cie_per_steradian", info["radial_profile"][-1])

    def test_text(self):
        self.make("--scatter", "cie")
        out = self.glare("info", "out.exr", "--cie").out
        for word in ("cie146, age 35 years, pigment 0.5", "CIE general glare", "template / CIE"):
            self.assertIn(word, out)

    def test_bad_values(self):
        self.make()
        for options in (("--age", "30"), ("--pigment", "1"), ("--cie", "--age", "101"),
                        ("--cie", "--pigment", "2"), ("--cie", "--age", "x")):
            self.assert_refused(2, [], "info", "out.exr", *options)


class Plot(GlareTest):
    def plot(self, name="out.exr"):
        result = self.glare("info", name, "--plot", "out.svg")
        self.assertEqual((result.status, result.err), (0, ""))
        return xml.dom.minidom.parseString(self.path("out.svg").read_bytes()).documentElement

    def texts(self, root):
        return ["".join(n.data for n in t.childNodes if n.nodeType == n.TEXT_NODE)
                for t in root.getElementsByTagName("text")]

    def test_drawing(self):
        self.make("--lamp", "HP1", "--scatter", "cie")
        root = self.plot()
        self.assertEqual((root.tagName, root.namespaceURI), ("svg", "http://www.w3.org/2000/svg"))
        lines = root.getElementsByTagName("polyline")
        self.assertEqual(len(lines), 2)
        for line in lines:
            points = [tuple(map(float, p.split(","))) for p in
                      line.getAttribute("points").split()]
            self.assertGreater(len(points), 5)
            for x, y in points:
                self.assertTrue(90 <= x <= 830 and 60 <= y <= 530, (x, y))
        texts = self.texts(root)
        self.assertTrue(any("HP1" in t for t in texts))
        self.assertTrue(any("degrees" in t for t in texts))
        self.assertTrue(any("1/sr" in t for t in texts))

    def test_names_from_files_are_escaped(self):
        self.make()
        whole = self.path("out.exr").read_bytes()
        for raw in (b"<b>&\"'</b>", b"]]>\xff\xc3\x28\xed\xa0\x80\x01", "\ufffe glä".encode(),
                    b"x" * 5000, "ä".encode() * 300):
            data = exr.with_attributes(whole, lambda a: a.update({"glare:lamp": ("string", raw)}))
            self.plot(self.write("odd.exr", data))
        self.assertIn("ä", "".join(self.texts(self.plot("odd.exr"))))

    def test_odd_scales(self):
        self.make()
        whole = self.path("out.exr").read_bytes()
        for name, number in (("glare:pixelPitch_deg", 1e-30), ("glare:pixelPitch_deg", 1e30),
                             ("glare:pixelPitch_deg", 60), ("glare:perSteradian", 1e-30),
                             ("glare:perSteradian", 1e38)):
            with self.subTest(f"{name} {number}"):
                raw = ("float", struct.pack("<f", number))
                data = exr.with_attributes(whole, lambda a: a.update({name: raw}))
                self.plot(self.write("odd.exr", data))

    def test_dark(self):
        self.make()
        nothing = {c: [0.0] * 64 for c in "RGB"}
        attributes, _ = exr.read_header(self.path("out.exr").read_bytes())
        data = exr.with_attributes(exr.encode(nothing, 8, 8), lambda a: a.update(
            {n: v for n, v in attributes.items() if n.startswith("glare:") or
             n == "chromaticities"} | {"glare:center_px": ("v2f", struct.pack("<2f", 4, 4))}))
        self.plot(self.write("dark.exr", data))

    def test_refusals(self):
        self.make()
        self.write("same.svg", self.path("out.exr").read_bytes())
        self.path("link.svg").symlink_to("out.exr")
        self.assert_refused(2, ["same.svg", "input"], "info", "same.svg", "--plot", "same.svg")
        self.assert_refused(2, ["link.svg", "input"], "info", "out.exr", "--plot", "link.svg")
        self.assert_refused(2, [".svg"], "info", "out.exr", "--plot", "plot.png")
        self.assert_refused(2, ["--plot"], "info", "out.exr", "--plot", "")
        self.assert_refused(4, ["none/"], "info", "out.exr", "--plot", "none/plot.svg")
        self.assert_refused(3, ["nothing.exr"], "info", "nothing.exr", "--plot", "plot.svg")
