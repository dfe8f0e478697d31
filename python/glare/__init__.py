"""Glare templates: what an eye sees around a point of light because light is diffracted.

    import glare
    veil = glare.template(lamp="hid", fov_deg=8, size=1024)
    veil.rgb                                   # (1024, 1024, 3) float32, scene-linear
    out = glare.apply(image, veil, fov_deg=40)  # image: (h, w, 3)

Angles are direction sines times 180/pi, "degrees"; the axis is the centre of the pixel
(w // 2, h // 2). Options are named as those of the program glare, with underscores; units stand in their names.
"""

from collections import namedtuple as _namedtuple

import numpy as _np

from ._glare import (Cancelled, Error, InputError, MemoryLimitError, OptionError, OutputError,
                     Template, __version__, read_template)
from ._making import Aperture, aperture, template, templates
from ._pictures import Filter, GlareWarning, apply
from . import _glare

__all__ = ["Aperture", "Cancelled", "Error", "Filter", "GlareWarning", "InputError", "Lamp",
           "MemoryLimitError", "Observer", "OptionError", "OutputError", "RadialProfile",
           "Spectrum", "Template", "__version__", "aperture", "apply", "cie_glare", "lamps",
           "observer", "read_template", "spectrum", "template", "templates"]

Lamp = _namedtuple("Lamp", "name alias description")
Lamp.__doc__ = "A built-in lamp: its name, another name or '', and what it stands for."

Spectrum = _namedtuple("Spectrum", "wavelength_nm power")
Spectrum.__doc__ = "Relative spectral power: two (n,) arrays of float64, linear between them."

Observer = _namedtuple("Observer", "wavelength_nm x_bar y_bar z_bar")
Observer.__doc__ = "CIE colour matching functions: four (n,) arrays of float64."

RadialProfile = _namedtuple("RadialProfile", "inner_deg outer_deg mean_per_steradian")
RadialProfile.__doc__ = "Rings around the axis, and the mean luminance in each: (n,) arrays."


def lamps():
    """Every built-in lamp, a list of Lamp; beside them there is 'blackbody:KELVIN'."""
    return [Lamp(*lamp) for lamp in _glare.lamps()]


def spectrum(name):
    """The Spectrum of a lamp: a built-in name, 'blackbody:KELVIN' or a CSV file.

    Raises OptionError for an unknown name, InputError for a file that is no table.
    """
    return Spectrum(*_glare.spectrum(str(name)))


def observer(name="cie1931-2deg"):
    """The colour matching functions of 'cie1931-2deg', 'cie1964-10deg', 'cie2015-2deg' or
    'cie2015-10deg': an Observer. Raises OptionError for another name.
    """
    return Observer(*_glare.observer(name))


def cie_glare(angle_deg, age=35.0, pigment=0.5):
    """The CIE general disability glare equation (CIE 146:2002), per steradian: the veil in cd/m^2
    of a source that gives 1 lux at the eye.

    angle_deg: above 0, a number or an array; the equation is meant for 0.1 to 100 degrees.
    age: years, 0 to 100. pigment: 0 very dark, 0.5 brown, 1 blue-green, 1.2 light blue.
    """
    return _glare.cie_glare(_np.asarray(angle_deg, dtype=_np.float64), age, pigment)


def _radial_profile(self):
    """The mean luminance per steradian over rings around the axis: a RadialProfile.

    Each ring is a factor 10^0.1 wider than the one within it, none but the innermost, the axis' own
    pixel, narrower than a pixel. Angles in degrees.
    """
    return RadialProfile(*self._radial_profile())


def _cie_profile(self, age=35.0, pigment=0.5):
    """The CIE general glare equation over the same rings and pixels as radial_profile(): (n,)
    per steradian, NaN where a ring begins below 0.1 degrees.
    """
    return self._cie_profile(age, pigment)


def _encircled_energy(self, radius_deg):
    """Share of all the light within radius_deg of the axis, 0 to 1: a number or an array.

    NaN for a circle that isn't wholly within the template's pixels or is smaller than one.
    """
    radii = _np.asarray(radius_deg, dtype=_np.float64)
    shares = self._encircled_energy(radii.ravel().tolist()).reshape(radii.shape)
    return float(shares) if radii.ndim == 0 else shares


Template.radial_profile = _radial_profile
Template.cie_profile = _cie_profile
Template.encircled_energy = _encircled_energy
for _method in (_radial_profile, _cie_profile, _encircled_energy):
    _method.__name__ = _method.__name__.lstrip("_")
    _method.__qualname__ = "Template." + _method.__name__
Template.__module__ = __name__
