"""Pictures with their glare are, to the last bit, those of the program."""
import os
import subprocess

import glare
import numpy as np
import pytest
from pupils import disc

# Colours outside Rec.709: both ways leave negative channels as they are.
pytestmark = pytest.mark.filterwarnings("ignore:pixels that give no light:glare.GlareWarning")


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """With a template, and a picture: the file of another one is a picture like any other."""
    folder = tmp_path_factory.mktemp("apply")
    pupil = disc(64, 0.9)
    pupil[:20, :30] = 0
    glare.template(pupil=pupil, width_mm=0.5, size=65, fov_deg=2,
                   lamp="hid").save(folder / "template.exr")
    glare.template(pupil=pupil.T, width_mm=0.5, size=(60, 41), fov_deg=2).save(folder / "in.exr")
    return folder


def both(folder, words, **options):
    """What the program and the module make of the picture."""
    subprocess.run([os.environ["GLARE"], "apply", "in.exr", "--template", "template.exr", "-o",
                    "out.exr", "--quiet", *words.split()], cwd=folder, check=True)
    picture = glare.read_template(folder / "in.exr").rgb
    made = glare.apply(picture, glare.read_template(folder / "template.exr"), **options)
    assert not np.array_equal(made, picture)
    return glare.read_template(folder / "out.exr").rgb, made


@pytest.mark.parametrize("words, options", [
    ("--fov-deg 3", {"fov_deg": 3}),
    ("--fov-deg 40 --perspective --strength 0.7 --edge extend",
     {"fov_deg": 40, "perspective": True, "strength": 0.7, "edge": "extend"}),
    ("--pixel-deg 0.02 --threshold 0.01 --knee 0.2 --exposure 1.5 --lamp-color keep --only-glare",
     {"pixel_deg": 0.02, "threshold": 0.01, "knee": 0.2, "exposure": 1.5, "lamp_color": "keep",
      "only_glare": True}),
    ("--fov-deg 3 --colorspace acescg", {"fov_deg": 3, "colorspace": "acescg"}),
])
def test_whole_picture(folder, words, options):
    of_program, of_module = both(folder, words, **options)
    np.testing.assert_array_equal(of_module, of_program)


@pytest.mark.parametrize("more, options", [
    ("", {}), ("--new-sources --exposure -1", {"new_sources": True, "exposure": -1}),
    ("--only-glare --strength 2", {"only_glare": True, "strength": 2})])
def test_points(folder, more, options):
    points = [[30, 20, 1, 2, 3], [10.25, 30.5, 4, 4, 4], [-3, 5, 50, 50, 50]]
    rows = "\n".join(",".join(map(str, point)) for point in points)
    (folder / "points.csv").write_text(rows)
    of_program, of_module = both(folder, f"--fov-deg 3 --sources points.csv {more}", fov_deg=3,
                                 sources=points, **options)
    np.testing.assert_array_equal(of_module, of_program)


@pytest.mark.parametrize("more, options", [
    ("--threshold 0.3", {"threshold": 0.3}),  # Few pixels are brighter: points.
    ("--threshold 0.3 --exposure 1 --only-glare --edge extend",
     {"threshold": 0.3, "exposure": 1, "only_glare": True, "edge": "extend"}),
    ("--edge extend", {"edge": "extend"})])  # The border shines: the whole picture's.
def test_points_found(folder, more, options):
    of_program, of_module = both(folder, f"--fov-deg 3 --sources auto {more}", fov_deg=3,
                                 sources="auto", **options)
    np.testing.assert_array_equal(of_module, of_program)
