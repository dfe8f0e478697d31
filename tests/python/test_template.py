"""Making templates: the same as the program, from files and from arrays."""
import hashlib
import json
import os
import subprocess
import warnings

import glare
import numpy as np
import pytest
from pupils import disc

PUPIL = disc(64, 0.9)
SMALL = {"size": 64, "fov_deg": 2}
APERTURE = {"pupil": PUPIL, "width_mm": 0.5}


def program(folder, *words):
    subprocess.run([os.environ["GLARE"], *words], cwd=folder, check=True)


@pytest.fixture(scope="module")
def small():
    return glare.template(**APERTURE, **SMALL, lamp="hid")


@pytest.mark.parametrize("options, words", [
    ({}, ""),
    ({"lamp": "hid", "seed": 7, "clear_media": True, "pupil_mm": 4.5, "normalize": "energy"},
     "--lamp hid --seed 7 --clear-media --pupil-mm 4.5 --normalize energy"),
    ({"colorspace": "xyz", "observer": "cie2015-10deg", "wavelength_range_nm": (400, 700.5),
      "scatter": "cie", "age": 60}, "--colorspace xyz --observer cie2015-10deg "
     "--wavelength-range-nm 400 700.5 --scatter cie --age 60"),
    ({"stiles_crawford": True, "stiles_crawford_peak_mm": (-0.5, 0.1), "size": (65, 32)},
     "--stiles-crawford --stiles-crawford-peak-mm -0.5 0.1 --size 65x32"),
])
def test_file_is_the_programs(tmp_path, options, words):
    half = "seed" in options
    glare.template(**{**SMALL, **options}).save(tmp_path / "python.exr", half=half)
    size = [] if "size" in options else ["--size", "64"]
    program(tmp_path, "template", "--quiet", "-o", "program.exr", "--fov-deg", "2", *size,
            *words.split(), *(["--half"] if half else []))
    assert (tmp_path / "python.exr").read_bytes() == (tmp_path / "program.exr").read_bytes()


def test_pixels_are_a_view(small):
    rgb = small.rgb
    assert rgb.shape == (64, 64, 3) and rgb.dtype == np.float32
    assert np.shares_memory(rgb, small.rgb)
    assert not rgb.flags.writeable
    with pytest.raises(ValueError):
        rgb[0, 0, 0] = 1
    with pytest.raises(ValueError):
        rgb.flags.writeable = True


def test_pixels_outlive_the_template():
    rgb = glare.template(**APERTURE, **SMALL).rgb
    again = glare.template(**APERTURE, **SMALL).rgb  # Would take the place of freed memory.
    np.testing.assert_array_equal(rgb, again)


def test_facts(small):
    assert small.lamp == "hid" and small.observer == "cie1931-2deg"
    assert small.normalization == "peak" and small.colorspace == "lin_rec709"
    assert small.center_px == (32, 32) and small.peak()[:2] == (32, 32)
    assert small.pixel_pitch_deg == pytest.approx(2 / 64)
    assert small.pixel_pitch_rad == pytest.approx(np.radians(2 / 64))
    assert small.luminance.max() == pytest.approx(1, abs=1e-6)  # Rounded to float.
    assert small.lamp_xyz[1] == pytest.approx(1) and small.light_xyz == small.lamp_xyz
    assert small.wavelength_range_nm == (380, 780)
    assert small.aperture_width_mm == 0.5
    assert small.aperture_area_mm2 == pytest.approx(np.sum(PUPIL ** 2.0) * (0.5 / 64) ** 2)
    weights = small.xyz_from_rgb[1]
    np.testing.assert_allclose(small.luminance, small.rgb @ weights, atol=1e-6)
    assert "hid" in repr(small) and "64 x 64" in repr(small)


def test_file_and_back(small, tmp_path):
    small.save(tmp_path / "t.exr")
    back = glare.read_template(str(tmp_path / "t.exr"))
    np.testing.assert_array_equal(back.rgb, small.rgb)
    assert back.recipe == small.recipe and back.lamp == small.lamp
    assert back.pixel_pitch_deg == pytest.approx(small.pixel_pitch_deg, rel=1e-7)  # A float there.


def test_array_or_file(tmp_path):
    """A picture's values and the array of them are one aperture."""
    steps = (PUPIL > 0.5) * np.uint8(255)
    (tmp_path / "pupil.pgm").write_bytes(b"P5 64 64 255\n" + steps.tobytes())
    table = glare.spectrum("A")
    lines = [f"{w!r},{p!r}" for w, p in zip(table.wavelength_nm.tolist(), table.power.tolist())]
    (tmp_path / "lamp.csv").write_text("\n".join(lines))
    of_files = glare.template(pupil=tmp_path / "pupil.pgm", lamp=tmp_path / "lamp.csv",
                              width_mm=0.5, **SMALL)
    of_arrays = glare.template(pupil=steps / np.float32(255), lamp=table, width_mm=0.5, **SMALL)
    np.testing.assert_array_equal(of_files.rgb, of_arrays.rgb)


def test_arrays_of_any_kind():
    expected = glare.template(**APERTURE, **SMALL).rgb
    wide = np.zeros((128, 192))
    wide[::2, ::3] = PUPIL
    for pupil in (PUPIL.astype(np.float64), np.asfortranarray(PUPIL), wide[::2, ::3]):
        np.testing.assert_array_equal(glare.template(pupil=pupil, width_mm=0.5, **SMALL).rgb,
                                      expected)
    both = glare.template(pupil=PUPIL, eyelashes=np.ones((64, 64), bool), width_mm=0.5, **SMALL)
    np.testing.assert_array_equal(both.rgb, expected)


def test_several_lamps_are_each_alone():
    lamps = ["hid", "A", glare.spectrum("D65")]
    together = glare.templates(lamps, **SMALL)
    for lamp, one in zip(lamps, together):
        np.testing.assert_array_equal(one.rgb, glare.template(lamp=lamp, **SMALL).rgb)


def test_recipe_tells_the_inputs():
    t = glare.template(lamp=glare.spectrum("A"), **APERTURE, **SMALL)
    recipe = json.loads(t.recipe)
    assert recipe["command"][:2] == ["glare", "template"]
    by_option = {entry["option"]: entry for entry in recipe["inputs"]}
    assert by_option["--pupil"]["sha256"] == hashlib.sha256(PUPIL.tobytes()).hexdigest()
    table = b"".join(a.tobytes() for a in glare.spectrum("A"))
    assert by_option["--lamp"]["sha256"] == hashlib.sha256(table).hexdigest()


def test_lamp_that_misses_light_is_warned_of():
    with pytest.warns(glare.GlareWarning, match="misses") as caught:
        glare.template(lamp=([500, 600], [1, 1]), **APERTURE, **SMALL)
    assert caught[0].filename == __file__
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        glare.template(lamp="A", **APERTURE, **SMALL)


def test_aperture_is_the_programs(tmp_path):
    drawn = glare.aperture(pixel_um=100, seed=3)
    program(tmp_path, "aperture", "eye", "-o", "eye.exr", "--quiet", "--pixel-um", "100", "--seed",
            "3")
    t = drawn.transmittance
    assert t.dtype == np.float32 and 0 <= t.min() and t.max() <= 1
    of_file = glare.template(pupil=tmp_path / "eye.exr", size=32, fov_deg=0.2)
    of_array = glare.template(pupil=t, width_mm=of_file.aperture_width_mm, size=32, fov_deg=0.2)
    np.testing.assert_array_equal(of_file.rgb, of_array.rgb)
    assert drawn.width_mm == pytest.approx(of_file.aperture_width_mm, rel=1e-7)  # A float there.
    assert not np.array_equal(glare.aperture(pixel_um=100, view="pupil").transmittance, t)
