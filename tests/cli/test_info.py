"""glare info: what a template is, as text and JSON, and files that are none."""

import resource
import struct

import exr
import images
from cli import GlareTest
from test_file import File

KEYS = {"file", "width_px", "height_px", "pixel_pitch_deg", "field_of_view_deg", "center_px",
        "color_space", "normalization", "per_steradian", "captured_energy", "lamp", "lamp_xyz",
        "light_xyz", "observer", "wavelength_range_nm", "aperture_width_mm", "aperture_area_mm2", "peak",
        "mean_chromaticity_xy", "encircled_energy", "radial_profile", "recipe", "software",
        "header"}
OPTIONAL = {"glare:lightXYZ"}  # Older files lack it.
ATTRIBUTES = tuple(name for name in File.TYPES if name not in OPTIONAL)
del File  # Its tests run in their own file.


class Info(GlareTest):
    def test_json(self):
        picture = self.make("--size", "80x60", "--fov-deg", "2", size=())
        info = self.info("out.exr")
        self.assertLessEqual(KEYS, info.keys())
        self.assertEqual((info["width_px"], info["height_px"]), (80, 60))
        for value, expected in zip(info["field_of_view_deg"], (2, 1.5)):
            self.assertAlmostEqual(value, expected, delta=1e-6)
        self.assertEqual(info["center_px"], [40, 30])
        self.assertEqual((info["peak"]["x_px"], info["peak"]["y_px"]), (40, 30))
        self.assertAlmostEqual(info["peak"]["luminance"], 1, delta=1e-6)
        self.assertAlmostEqual(info["peak"]["per_steradian"], info["per_steradian"],
                               delta=1e-6 * info["per_steradian"])
        self.assertEqual(info["recipe"], picture.attributes["glare:recipe"])
        for name in ATTRIBUTES:
            self.assertEqual(info["header"][name]["type"], picture.types[name])

    def test_mean_chromaticity_is_about_the_lamps(self):
        self.make("--lamp", "A", "--size", "128", "--fov-deg", "2.7", size=())
        x, y = self.info("out.exr")["mean_chromaticity_xy"]
        # Red light is spread wider, and more of it falls outside.
        self.assertAlmostEqual(x, 0.4476, delta=0.01)
        self.assertAlmostEqual(y, 0.4074, delta=0.01)

    def test_encircled_energy(self):
        self.make("--size", "128", "--fov-deg", "2.7", size=())
        info = self.info("out.exr")
        shares = {s["radius_deg"]: s["share_of_light"] for s in info["encircled_energy"]}
        self.assertEqual(sorted(shares), [0.1, 0.5, 1])  # 2 deg isn't inside the picture.
        self.assertLess(shares[0.1], shares[0.5])
        self.assertLess(shares[0.5], shares[1])
        self.assertLess(shares[1], info["captured_energy"])

    def test_radial_profile(self):
        picture = self.make()
        info = self.info("out.exr")
        rings = info["radial_profile"]
        self.assertEqual(rings[0]["inner_deg"], 0)
        for inner, outer in zip(rings, rings[1:]):
            self.assertEqual(inner["outer_deg"], outer["inner_deg"])
        self.assertAlmostEqual(rings[0]["mean_per_steradian"], info["peak"]["per_steradian"],
                               delta=1e-6 * info["peak"]["per_steradian"])
        luminance, pitch = picture.luminance(), info["pixel_pitch_deg"]
        middle = rings[len(rings) // 2]
        inside = [luminance[y * 64 + x] for y in range(64) for x in range(64)
                  if middle["inner_deg"] <= pitch * ((x - 32) ** 2 + (y - 32) ** 2) ** 0.5
                  < middle["outer_deg"]]
        self.assertAlmostEqual(middle["mean_per_steradian"], sum(inside) / len(inside)
                               * info["per_steradian"], delta=1e-4 * middle["mean_per_steradian"])

    def test_normalizations_agree(self):
        infos = []
        for normalization in ("peak", "energy", "absolute"):
            self.make("--normalize", normalization)
            infos.append(self.info("out.exr"))
        for info in infos[1:]:
            ratio = info["peak"]["per_steradian"] / infos[0]["peak"]["per_steradian"]
            self.assertAlmostEqual(ratio, 1, delta=1e-6)

    def test_xyz_and_half(self):
        self.make("--colorspace", "xyz", "--half", "--quiet")
        info = self.info("out.exr")
        self.assertEqual(info["color_space"], "xyz")
        self.assertAlmostEqual(info["peak"]["luminance"], 1, delta=1e-3)

    def test_text(self):
        self.make("--lamp", "HP1")
        result = self.glare("info", "out.exr")
        self.assertEqual((result.status, result.err), (0, ""))
        for word in ("64 x 64", "HP1", "cie1931-2deg", "peak", "lin_rec709", "captured energy",
                     "light within", "380 to 780", "glare:recipe", *ATTRIBUTES):
            self.assertIn(word, result.out)


    def test_every_type_of_attribute_is_written_out(self):
        self.make()
        text, pack = b"one", struct.pack
        cases = {  # name: type, bytes, text
            "a": ("int", pack("<i", -7), "-7"), "b": ("double", pack("<d", 0.1), "0.1"),
            "c": ("v2i", pack("<2i", 1, -2), "1 -2"), "d": ("v2f", pack("<2f", 0.1, 2), "0.1 2"),
            "e": ("v2d", pack("<2d", 0.1, 2), "0.1 2"), "f": ("v3i", pack("<3i", 1, 2, 3), "1 2 3"),
            "g": ("v3f", pack("<3f", 1, 2.5, 3), "1 2.5 3"),
            "h": ("v3d", pack("<3d", 1, 2.5, 3), "1 2.5 3"),
            "i": ("m33f", pack("<9f", *range(9)), "0 1 2 3 4 5 6 7 8"),
            "j": ("m44f", pack("<16f", *range(16)), " ".join(map(str, range(16)))),
            "k": ("box2i", pack("<4i", 1, 2, 3, 4), "1 2 3 4"),
            "l": ("box2f", pack("<4f", 1, 2, 3, 4.5), "1 2 3 4.5"),
            "m": ("rational", pack("<iI", 24000, 1001), "24000/1001"),
            "n": ("stringvector", pack("<i", 3) + text + pack("<i", 3) + text, "one, one"),
            "o": ("tiledesc", pack("<IIB", 64, 32, 1), "64 x 32, mipmap, rounded down"),
            "p": ("timecode", pack("<II", 0x01023004, 0), "01:02:30:04"),
            "q": ("envmap", b"\1", "cube"), "r": ("lineOrder", b"\1", "decreasing y"),
            "s": ("compression", b"\4", "piz"), "t": ("mine", b"12345", "(5 bytes)"),
            "u": ("string", "gl\u00e4re".encode(), "gl\u00e4re"),
            "v": ("preview", pack("<2I4x", 1, 1), "(12 bytes)"),
            "w": ("floatvector", pack("<2f", 1.5, 2), "1.5 2")}
        data = exr.with_attributes(self.path("out.exr").read_bytes(), lambda a: a.update(
            {name: (kind, raw) for name, (kind, raw, _) in cases.items()}))
        header = self.info(self.write("more.exr", data))["header"]
        for name, (kind, _, shown) in cases.items():
            self.assertEqual(header[name], {"type": kind, "value": shown}, name)
        self.assertEqual(header["channels"]["value"], "B float, G float, R float")
        self.assertEqual(header["dataWindow"]["value"], "0 0 63 63")
        self.assertEqual(header["compression"]["value"], "zip")

    def test_text_is_whole_and_without_control_characters(self):
        self.make()
        name, value = "n" * 250, "v" * 5000 + "\x1b[31m\r\n\x7f\u009b!"
        data = exr.with_attributes(self.path("out.exr").read_bytes(), lambda a: a.update(
            {name: ("string", value.encode()), "glare:lamp": ("string", b"L\x1b]0;\x07P")}))
        self.write("long.exr", data[:4] + struct.pack("<I", 0x402) + data[8:])
        result = self.glare("info", "long.exr")
        self.assertEqual((result.status, result.err), (0, ""))
        self.assertIn("v" * 5000 + " [31m" + " " * 5 + "!", result.out)
        self.assertIn(name, result.out)
        self.assertIn("L ]0; P", result.out)
        self.assertFalse([c for c in result.out if c != "\n" and (c < " " or "\x7f" <= c < "\xa0")])


class NoTemplate(GlareTest):
    def check(self, name, *mentions):
        self.assert_refused(3, [name, *mentions], "info", name, "--json")

    def test_files(self):
        self.path("dir.exr").mkdir()
        self.check("nothing.exr", "no such file")
        self.check("dir.exr", "folder")
        self.check("/dev/null")
        self.check("pupil.png", "OpenEXR")
        self.check(self.write("empty.exr", b""))
        self.assert_refused(3, ["no such file"], "info", "")

    def test_another_openexr(self):
        one = [1.0] * 64
        self.check(self.write("rgb.exr", exr.encode({c: one for c in "RGB"}, 8, 8)),
                   "glare:formatVersion", "missing")

    def test_each_attribute_is_required(self):
        self.make()
        whole = self.path("out.exr").read_bytes()
        for name in ATTRIBUTES:
            self.write("less.exr", exr.with_attributes(whole, lambda a: a.pop(name)))
            self.assert_refused(3, ["less.exr", name, "missing"], "info", "less.exr")

    def test_attributes_that_are_wrong(self):
        self.make()
        whole = self.path("out.exr").read_bytes()
        for name, kind, raw in (("glare:pixelPitch_deg", "float", struct.pack("<f", 0)),
                                ("glare:pixelPitch_deg", "float", struct.pack("<f", float("nan"))),
                                ("glare:perSteradian", "double", struct.pack("<d", 1)),
                                ("glare:formatVersion", "int", struct.pack("<i", 2)),
                                ("glare:center_px", "v2f", struct.pack("<2f", 0, 0)),
                                ("glare:normalization", "string", b"sum"),
                                ("chromaticities", "chromaticities", bytes(32))):
            def change(attributes):
                attributes[name] = (kind, raw)
            self.write("wrong.exr", exr.with_attributes(whole, change))
            with self.subTest(name):
                words = ["wrong.exr", name.removeprefix("glare:")]
                self.assert_refused(3, words, "info", "wrong.exr")

    def test_cut_short(self):
        self.make()
        whole = self.path("out.exr").read_bytes()
        for share in (0.001, 0.02, 0.5, 1 - 1 / len(whole)):
            self.check(self.write("cut.exr", images.cut(whole, share)))

    def test_damaged(self):
        self.make()
        whole = self.path("out.exr").read_bytes()
        _, end = exr.read_header(whole)
        first_block, = struct.unpack_from("<Q", whole, end)
        for name, at, raw in (("size", first_block + 4, struct.pack("<i", 2**31 - 1)),
                              ("line", first_block, struct.pack("<i", -5)),
                              ("type", whole.index(b"chlist") + 13, b"\7")):
            with self.subTest(name):
                self.check(self.write("bad.exr", whole[:at] + raw + whole[at + len(raw):]))

    def test_larger_than_its_data(self):
        self.make()
        whole = self.path("out.exr").read_bytes()
        for side in (30000, 60000):
            box = struct.pack("<4i", 0, 0, side - 1, side - 1)
            self.write("bomb.exr", whole.replace(struct.pack("<4i", 0, 0, 63, 63), box))
            limit = lambda: resource.setrlimit(resource.RLIMIT_AS, (2 << 30, 2 << 30))
            self.assert_refused(3, ["bomb.exr", "too little data"], "info", "bomb.exr",
                                preexec_fn=limit)

    def test_other_kinds_of_openexr(self):
        self.make()
        whole = self.path("out.exr").read_bytes()
        for flag, word in ((0x200, "tiled"), (0x800, "deep"), (0x1000, "parts")):
            self.check(self.write("kind.exr", whole[:4] + struct.pack("<I", 2 | flag) + whole[8:]),
                       word)
