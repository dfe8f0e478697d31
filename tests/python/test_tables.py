"""Lamps, observers, and what the package tells of itself."""
import subprocess
import os

import glare
import numpy as np
import pytest


def test_lamps_are_the_programs():
    listed = subprocess.run([os.environ["GLARE"], "lamps"], capture_output=True, text=True,
                            check=True).stdout
    lamps = glare.lamps()
    assert len(lamps) > 50 and all(lamp.name in listed for lamp in lamps)
    assert any(lamp.alias == "hid" for lamp in lamps)


def test_spectrum_of_a_black_body_is_plancks():
    wavelength_nm, power = glare.spectrum("blackbody:3000")
    planck = wavelength_nm ** -5.0 / np.expm1(1.4388e-2 / (wavelength_nm * 1e-9 * 3000))
    np.testing.assert_allclose(power, planck / planck.max(), rtol=1e-9)


def test_observer():
    observer = glare.observer()
    assert observer.wavelength_nm.shape == observer.x_bar.shape == observer.z_bar.shape
    assert observer.wavelength_nm[observer.y_bar.argmax()] == 555
    assert observer.y_bar.max() == pytest.approx(1, abs=1e-4)  # 1 in the tables of 1931.
    with pytest.raises(glare.OptionError):
        glare.observer("cie1666")


def test_cie_glare_takes_arrays():
    angles = np.array([[0.1, 1.0], [10.0, 100.0]])
    values = glare.cie_glare(angles)
    assert values.shape == angles.shape
    assert values[1, 0] == glare.cie_glare(10.0)
    with pytest.raises(glare.OptionError):
        glare.cie_glare(-1.0)


def test_version():
    told = subprocess.run([os.environ["GLARE"], "--version"], capture_output=True, text=True,
                          check=True).stdout
    assert told.split()[-1] == glare.__version__


def test_everything_public_is_documented():
    for name in glare.__all__:
        thing = getattr(glare, name)
        assert isinstance(thing, str) or thing.__doc__, name
    for name in dir(glare.Template):
        if not name.startswith("_"):
            assert getattr(glare.Template, name).__doc__, name
