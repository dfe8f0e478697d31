"""What is loaded when: OpenImageIO and OpenColorIO only by the commands that need them."""

import pathlib
import re
import shutil
import subprocess
import unittest

import cli
from cli import GlareTest

SPACE = ("--ocio", "studio.ocio", "--colorspace", "studio")
HEAVY = ("OpenImageIO", "OpenColorIO", "glare_image_codec", "glare_color_config", "opencv",
         "glare_eye_photo")
CONFIG = """ocio_profile_version: 2
search_path: ""
roles: {cie_xyz_d65_interchange: studio, default: studio}
displays:
  none:
    - !<View> {name: Raw, colorspace: studio}
colorspaces:
  - !<ColorSpace> {name: studio, encoding: scene-linear}
"""


def linked_libraries():
    """The libraries that the program names, and the paths at which they are found."""
    done = subprocess.run(["ldd", cli.PROGRAM], capture_output=True, text=True)
    return dict(re.findall(r"^\s*(\S+) => (\S+)", done.stdout, re.MULTILINE))


LIBGLARE_IO = next((name for name in linked_libraries() if name.startswith("libglare_io.so")), None)


class ModulesTest(GlareTest):
    def setUp(self):
        super().setUp()
        if LIBGLARE_IO is None:
            self.skipTest("glare is built of static libraries, which have no modules")
        self.write("studio.ocio", CONFIG)


class Loaded(ModulesTest):
    def loaded_by(self, *arguments):
        """The file names of the libraries that a command loads, which must succeed."""
        log = self.folder / "log"
        self.environment |= {"LD_DEBUG": "files", "LD_DEBUG_OUTPUT": str(log)}
        result = self.glare(*arguments)
        self.assertEqual(result.status, 0, result.err)
        (written,) = self.folder.glob("log.*")
        paths = re.findall(r"calling init: (.*)", written.read_text(errors="replace"))
        written.unlink()
        names = {pathlib.Path(path).name for path in paths}
        self.assertIn(LIBGLARE_IO, names)
        return names

    def assert_light(self, *arguments):
        for name in self.loaded_by(*arguments):
            for heavy in HEAVY:
                self.assertNotIn(heavy, name, arguments)

    def test_help_lamps_and_version_load_neither(self):
        for arguments in ("--help",), ("template", "--help"), ("--version",), ("lamps",):
            self.assert_light(*arguments)

    def test_templates_of_the_built_in_eye_and_info_load_neither(self):
        for space in ("lin_rec709", "xyz", "acescg"):
            self.environment["OCIO"] = str(self.path("studio.ocio"))
            self.assert_light("template", "-o", "out.exr", "--size", "64", "--colorspace", space)
        self.assert_light("info", "out.exr")

    def test_a_picture_loads_openimageio(self):
        names = self.loaded_by("template", "-o", "out.exr", *cli.SMALL, *cli.APERTURE)
        self.assertIn("glare_image_codec.so", names)
        self.assertNotIn("glare_color_config.so", names)
        self.assertTrue(any(name.startswith("libOpenImageIO.so") for name in names))

    def test_a_config_loads_opencolorio(self):
        names = self.loaded_by("template", "-o", "out.exr", *cli.SMALL, *SPACE)
        self.assertIn("glare_color_config.so", names)
        self.assertNotIn("glare_image_codec.so", names)
        self.assertTrue(any(name.startswith("libOpenColorIO.so") for name in names))
        self.assertFalse(any(name.startswith("libOpenImageIO.so") for name in names))


class Unusable(ModulesTest):
    """Copies of the library, with modules beside it or without."""

    def setUp(self):
        super().setUp()
        library = pathlib.Path(linked_libraries()[LIBGLARE_IO]).resolve()
        self.built = library.parent / LIBGLARE_IO.replace("libglare_io.so.", "glare-")
        copies = self.path("libraries").resolve()
        self.modules = copies / self.built.name
        self.modules.mkdir(parents=True)
        shutil.copyfile(library, copies / LIBGLARE_IO)
        before = self.environment.get("LD_LIBRARY_PATH")
        self.environment["LD_LIBRARY_PATH"] = ":".join(filter(None, [str(copies), before]))

    def assert_all_need_a_module(self, mentions):
        for name, purpose, arguments in [
                ("glare_image_codec.so", "pictures", cli.APERTURE),
                ("glare_color_config.so", "OpenColorIO config", SPACE)]:
            path = str(self.modules / name)
            self.assert_template_refused(1, [path, purpose, *mentions], *arguments, aperture=())

    def test_copies_beside_the_library_are_used(self):
        for module in self.built.glob("*.so"):
            shutil.copyfile(module, self.modules / module.name)
        self.make(*SPACE)

    def test_missing(self):
        self.assert_all_need_a_module(["isn't there"])
        self.make(aperture=())

    def test_not_a_library(self):
        for module in self.built.glob("*.so"):
            (self.modules / module.name).write_text("hello")
        self.assert_all_need_a_module(["can't be loaded"])

    def test_of_another_library(self):
        for module in self.built.glob("*.so"):
            shutil.copyfile(linked_libraries()[LIBGLARE_IO], self.modules / module.name)
        self.assert_all_need_a_module(["isn't a module of Glare"])

    def test_of_another_version(self):
        version = self.glare("--version").out.split()[1]
        other = "9" + version[1:]
        for module in self.built.glob("*.so"):
            content = module.read_bytes()
            marked = content.replace(f"\0{version}\0".encode(), f"\0{other}\0".encode())
            self.assertNotEqual(content, marked)
            (self.modules / module.name).write_bytes(marked)
        self.assert_all_need_a_module([f"is of Glare {other}", f"{version} was expected"])
