"""Misuse gives a clear exception, of the right kind."""
import glare
import numpy as np
import pytest
from pupils import disc

PUPIL = disc(64, 0.9)
NAN = float("nan")


def test_family():
    assert issubclass(glare.InputError, glare.Error) and issubclass(glare.InputError, ValueError)
    assert issubclass(glare.OptionError, glare.Error) and issubclass(glare.OptionError, ValueError)
    assert issubclass(glare.OutputError, glare.Error) and issubclass(glare.OutputError, OSError)
    assert issubclass(glare.MemoryLimitError, glare.Error)
    assert issubclass(glare.MemoryLimitError, MemoryError)
    assert issubclass(glare.Cancelled, glare.Error)


@pytest.mark.parametrize("options, error, words", [
    ({"fov": 3}, TypeError, "did you mean fov_deg"),
    ({"output": "x.exr"}, TypeError, "unexpected keyword"),
    ({"fov_deg": NAN}, glare.OptionError, "field of view"),
    ({"fov_deg": "wide"}, glare.OptionError, "fov_deg"),
    ({"fov_deg": [1, 2]}, glare.OptionError, "fov_deg"),
    ({"fov_deg": True}, TypeError, "fov_deg"),
    ({"fov_deg": 60, "pupil": PUPIL, "width_mm": 8}, glare.OptionError, "aperture"),
    ({"size": 0}, glare.OptionError, "size"),
    ({"size": (1, 2, 3)}, glare.OptionError, "size"),
    ({"size": 65536}, glare.OptionError, "size"),
    ({"seed": -1}, glare.OptionError, "seed"),
    ({"clear_media": 1}, TypeError, "True or False"),
    ({"pupil_mm": NAN}, glare.OptionError, "pupil"),
    ({"lamp": "sun"}, glare.OptionError, "unknown lamp"),
    ({"lamp": 3}, TypeError, "lamp"),
    ({"lamp": ([500, 600], [1, NAN])}, glare.InputError, "spectrum"),
    ({"lamp": ([500, 600], [0, 0])}, glare.InputError, "lamp"),
    ({"lamp": ([500, 600], [1, 2, 3])}, glare.InputError, "spectrum"),
    ({"lamp": ([[500, 600]], [[1, 2]])}, glare.InputError, "one-dimensional"),
    ({"lamp": "nowhere/lamp.csv"}, glare.InputError, "no such file"),
    ({"observer": "me"}, glare.OptionError, "observer"),
    ({"wavelength_range_nm": (700, 400)}, glare.OptionError, "wavelength"),
    ({"wavelength_range_nm": 400}, glare.OptionError, "wavelength_range_nm"),
    ({"colorspace": "mine"}, glare.OptionError, "colour space"),
    ({"ocio": "nowhere.ocio"}, glare.InputError, "config"),
    ({"white": "paper"}, glare.OptionError, "white"),
    ({"age": 30}, glare.OptionError, "age goes with scatter"),
    ({"threads": -1}, glare.OptionError, "threads"),
    ({"memory_limit": 1000}, glare.MemoryLimitError, "memory"),
    ({"width_mm": 3}, glare.OptionError, "width_mm goes with pupil"),
    ({"pupil": PUPIL}, glare.OptionError, "width_mm"),
    ({"pupil": PUPIL, "width_mm": NAN}, glare.OptionError, "width"),
    ({"pupil": PUPIL, "width_mm": 1, "seed": 3}, glare.OptionError, "excludes"),
    ({"pupil": PUPIL[0], "width_mm": 1}, glare.InputError, "(h, w)"),
    ({"pupil": np.ones((4, 4, 3)), "width_mm": 1}, glare.InputError, "(h, w)"),
    ({"pupil": np.ones((0, 4)), "width_mm": 1}, glare.InputError, "(h, w)"),
    ({"pupil": np.ones((4, 4), int), "width_mm": 1}, TypeError, "floats or bools"),
    ({"pupil": np.full((4, 4), 2.0), "width_mm": 1}, glare.InputError, "transmittance"),
    ({"pupil": np.full((4, 4), NAN), "width_mm": 1}, glare.InputError, "transmittance"),
    ({"pupil": np.zeros((4, 4)), "width_mm": 1}, glare.InputError, "opaque"),
    ({"pupil": np.ones((1, 70000), bool), "width_mm": 1}, glare.InputError, "65535"),
    ({"pupil": "nowhere.png", "width_mm": 1}, glare.InputError, "no such file"),
])
def test_template_refuses(options, error, words):
    options = {"size": 16, **options}
    with pytest.raises(error) as caught:
        glare.template(**options)
    assert words in str(caught.value) and "--" not in str(caught.value)


def test_templates_refuses_a_name():
    with pytest.raises(TypeError):
        glare.templates("A")
    assert glare.templates([]) == []


def test_files(tmp_path):
    t = glare.template(pupil=PUPIL, width_mm=0.5, size=8, fov_deg=1)
    with pytest.raises(glare.OutputError):
        t.save(tmp_path / "nowhere" / "t.exr")
    with pytest.raises(glare.InputError):
        glare.read_template(tmp_path / "t.exr")
    (tmp_path / "t.exr").write_bytes(b"no picture")
    with pytest.raises(glare.InputError):
        glare.read_template(tmp_path / "t.exr")
    t.save(tmp_path / "t.exr")
    with pytest.raises(glare.MemoryLimitError):
        glare.read_template(tmp_path / "t.exr", memory_limit=100)
    with pytest.raises(TypeError):
        t.save(3)


def test_template_is_only_made_by_functions():
    with pytest.raises(TypeError):
        glare.Template()


def test_aperture_refuses():
    for options, error in [({"view": "side"}, glare.OptionError), ({"size": 3}, glare.OptionError),
                           ({"pixel_um": NAN}, glare.OptionError), ({"lamp": "A"}, TypeError),
                           ({"pupil_mm": -1}, glare.OptionError)]:
        with pytest.raises(error):
            glare.aperture(**options)
