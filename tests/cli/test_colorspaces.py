"""Colour spaces: built-in ones, and those of a user's OpenColorIO config."""

import os

from cli import GlareTest

# Primaries and white as the standards give them: BT.709-6, BT.2020-2, SMPTE EG 432-1, ACES.
D65, ACES_WHITE = (0.3127, 0.3290), (0.32168, 0.33767)
STANDARD = {
    "lin_rec709": (0.64, 0.33, 0.30, 0.60, 0.15, 0.06, *D65),
    "lin_rec2020": (0.708, 0.292, 0.170, 0.797, 0.131, 0.046, *D65),
    "lin_p3d65": (0.680, 0.320, 0.265, 0.690, 0.150, 0.060, *D65),
    "acescg": (0.713, 0.293, 0.165, 0.830, 0.128, 0.044, *ACES_WHITE),
    "aces2065-1": (0.7347, 0.2653, 0.0, 1.0, 0.0001, -0.0770, *ACES_WHITE),
    "ntsc1953": (0.67, 0.33, 0.21, 0.71, 0.14, 0.08, 0.3101, 0.3162),
}

CONFIG = """ocio_profile_version: 2
search_path: ""
strictparsing: true
roles: {{{role}, default: raw, mine: studio}}
displays:
  none:
    - !<View> {{name: Raw, colorspace: raw}}
colorspaces:
  - !<ColorSpace> {{name: reference, encoding: scene-linear}}
  - !<ColorSpace>
    name: studio
    aliases: [my studio]
    encoding: scene-linear
    to_scene_reference: !<MatrixTransform> {{matrix: [{matrix}]}}
  - !<ColorSpace>
    name: film
    encoding: log
    to_scene_reference: !<LogTransform> {{base: 2, direction: inverse}}
  - !<ColorSpace>
    name: hidden log
    to_scene_reference: !<LogTransform> {{base: 2, direction: inverse}}
  - !<ColorSpace> {{name: raw, isdata: true}}
"""
# To CIE XYZ from Rec.709, as IEC 61966-2-1 has it in more digits.
XYZ_FROM_REC709 = ("0.4123907993, 0.3575843394, 0.1804807884, 0, 0.2126390059, 0.7151686788, "
                   "0.0721923154, 0, 0.0193308187, 0.1191947798, 0.9505321522, 0, 0, 0, 0, 1")
UNIT = "1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1"


def config(role="cie_xyz_d65_interchange: reference", matrix=XYZ_FROM_REC709):
    return CONFIG.format(role=role, matrix=matrix)


class BuiltIn(GlareTest):
    def test_chromaticities(self):
        for name, expected in STANDARD.items():
            attributes = self.make("--colorspace", name).attributes
            self.assertEqual(attributes["glare:colorSpace"], name)
            for value, wanted in zip(attributes["chromaticities"], expected):
                self.assertAlmostEqual(value, wanted, delta=1e-4, msg=name)

    def test_xyz_has_channels_of_its_own_and_no_chromaticities(self):
        picture = self.make("--colorspace", "xyz")
        self.assertEqual(set(picture.channels), set("XYZ"))
        self.assertNotIn("chromaticities", picture.types)
        rec709 = self.make()
        for a, b in zip(picture.luminance(), rec709.luminance()):
            self.assertAlmostEqual(a, b, delta=1e-6)

    def test_the_sum_has_the_lamps_colour(self):
        size = ("--size", "128", "--fov-deg", "2.7")
        x, y, z = self.make("--colorspace", "xyz", size=size).sums()
        self.assertAlmostEqual(x / (x + y + z), 0.3127, delta=0.005)
        self.assertAlmostEqual(y / (x + y + z), 0.3290, delta=0.005)

    def test_unknown(self):
        for name in ("", "srgb", "rec709", "LIN_REC709", "xyz "):
            self.assert_template_refused(2, ["colour space", "lin_rec2020"], "--colorspace", name)


class UserConfig(GlareTest):
    def use(self, *arguments, text=None, **options):
        self.write("studio.ocio", text or config())
        return self.make("--ocio", "studio.ocio", "--colorspace", *arguments, **options)

    def refuse(self, status, mentions, name, text=None):
        self.write("studio.ocio", text or config())
        self.assert_template_refused(status, mentions, "--ocio", "studio.ocio", "--colorspace",
                                     name)

    def test_xyz_interchange(self):
        picture = self.use("studio")
        self.assertEqual(picture.attributes["glare:colorSpace"], "studio")
        self.assert_same_pixels(self.make(), picture, 1e-5)

    def test_alias_role_and_case(self):
        plain = self.use("studio")
        for name in ("my studio", "mine", "STUDIO"):
            self.assert_same_pixels(plain, self.use(name))

    def test_aces_interchange(self):
        """The reference is ACES2065-1 with D65 adapted to its white: D65's light is neutral."""
        picture = self.use("studio", "--size", "128", "--fov-deg", "2.7", size=(),
                           text=config("aces_interchange: reference", UNIT))
        red, green, blue = picture.sums()
        self.assertAlmostEqual(red / green, 1, delta=0.02)
        self.assertAlmostEqual(blue / green, 1, delta=0.02)

    def test_environment(self):
        self.write("studio.ocio", config())
        self.environment["OCIO"] = str(self.path("studio.ocio"))
        by_environment = self.make("--colorspace", "studio")
        self.assert_same_pixels(by_environment, self.use("studio"))
        self.assertIn("studio.ocio", by_environment.attributes["glare:recipe"])

    def test_the_option_wins_over_the_environment(self):
        self.environment["OCIO"] = "nothing.ocio"
        self.use("studio")

    def test_built_in_names_are_not_the_configs(self):
        self.environment["OCIO"] = "nothing.ocio"
        self.make()

    def test_not_scene_linear(self):
        self.refuse(2, ["film", "linear"], "film")
        self.refuse(2, ["hidden log", "linear"], "hidden log")
        self.refuse(2, ["raw", "data"], "raw")

    def test_unknown_name(self):
        self.refuse(2, ["studoi", "studio.ocio"], "studoi")

    def test_configs_that_cannot_be_used(self):
        self.refuse(3, ["studio.ocio"], "studio", "hello")
        self.refuse(3, ["studio.ocio", "interchange"], "studio", config("other: reference"))
        self.path("folder.ocio").mkdir()
        for name in ("nothing.ocio", "folder.ocio", "pupil.png", "/dev/null"):
            self.assert_template_refused(3, [name], "--ocio", name, "--colorspace", "studio")

    def test_a_pipe_is_not_waited_for(self):
        os.mkfifo(self.path("pipe.ocio"))
        self.assert_template_refused(3, ["pipe.ocio", "pipe"], "--ocio", "pipe.ocio",
                                     "--colorspace", "studio", timeout=10)

    def test_recipe_names_the_config(self):
        self.use("studio")
        self.assertIn('"--ocio","studio.ocio"', self.info("out.exr")["recipe"])
