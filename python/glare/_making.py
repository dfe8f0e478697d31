"""Templates and apertures, from keywords to the words of the command line."""

import difflib
import numbers
import os
import warnings
from collections import namedtuple

import numpy as np

from . import _glare
from ._glare import InputError, OptionError
from ._pictures import GlareWarning, _callback

Aperture = namedtuple("Aperture", "transmittance width_mm")
Aperture.__doc__ = "Amplitude transmittance, (h, w) float32, 0 to 1, and the picture's width in mm."

# What the command has for files and words on a terminal, and what is passed apart.
_NOT_KEYWORDS = {"help", "output", "preview", "half", "frames", "fps", "quiet", "verbose", "eye",
                 "pupil", "eyelashes", "lamp"}


def _keywords(options):
    """{keyword: (option's name, how many values it takes)}"""
    return {name.replace("-", "_"): (name, count) for name, count in options.items()
            if name not in _NOT_KEYWORDS}


_TEMPLATE_KEYWORDS = _keywords(_glare.template_options())
_EYE_KEYWORDS = _keywords(_glare.eye_picture_options())


def _text(name, value):
    if isinstance(value, (str, os.PathLike)):
        return os.fspath(value)
    if isinstance(value, numbers.Integral) and not isinstance(value, bool):
        return str(int(value))
    if isinstance(value, numbers.Real) and not isinstance(value, bool):
        return repr(float(value))
    raise TypeError(f"{name}: expected a number or a text, not {type(value).__name__}")


def _option_words(name, option, count, value):
    """The words of one option; none for None and for a flag that isn't set."""
    if value is None:
        return []
    if count == 0:
        if not isinstance(value, (bool, np.bool_)):
            raise TypeError(f"{name}: expected True or False, not {type(value).__name__}")
        return ["--" + option] if value else []
    if isinstance(value, (tuple, list, np.ndarray)):
        values = [_text(name, part) for part in value]
        if name == "size":
            return [f"--{option}=" + "x".join(values)]
        if len(values) == count > 1:
            return ["--" + option, *values]
        raise OptionError(f"{name}: expected {count} of them, not {len(values)}")
    return [f"--{option}={_text(name, value)}"]


def _words(function, keywords, options):
    words = []
    for name, value in options.items():
        if name not in keywords:
            near = difflib.get_close_matches(name, keywords, 1)
            hint = f"; did you mean {near[0]}?" if near else ""
            raise TypeError(f"{function}() got an unexpected keyword argument '{name}'{hint}")
        words += _option_words(name, *keywords[name], value)
    return words


def _picture(name, value):
    """(words, array) of an aperture's picture: one of them is empty."""
    if value is None:
        return [], None
    if isinstance(value, (str, os.PathLike)):
        return [f"--{name}={os.fspath(value)}"], None
    array = np.asarray(value)
    if array.dtype.kind not in "fb":
        raise TypeError(f"{name}: expected a file name or an array of floats or bools, "
                        f"not of {array.dtype}")
    if array.ndim != 2 or 0 in array.shape:
        raise InputError(f"{name}: expected an array (h, w), not {array.shape}")
    return [], np.ascontiguousarray(array, dtype=np.float32)


def _lamp(lamp):
    if isinstance(lamp, (str, os.PathLike)):
        return os.fspath(lamp)
    try:
        wavelengths, power = lamp
    except (TypeError, ValueError):
        raise TypeError("lamp: expected a name, a file, or (wavelength_nm, power)") from None
    return (np.asarray(wavelengths, dtype=np.float64), np.asarray(power, dtype=np.float64))


def _made(function, lamps, pupil, eyelashes, progress, options):
    words = _words(function, _TEMPLATE_KEYWORDS, options)
    pupil_words, pupil_array = _picture("pupil", pupil)
    eyelashes_words, eyelashes_array = _picture("eyelashes", eyelashes)
    made, notes = _glare.make_templates(words + pupil_words + eyelashes_words, pupil_array,
                                        eyelashes_array, [_lamp(lamp) for lamp in lamps],
                                        _callback(progress))
    for note in notes:
        warnings.warn(note, GlareWarning, stacklevel=3)
    return made


def templates(lamps, *, pupil=None, eyelashes=None, progress=None, **options):
    """A Template of each lamp, on one aperture; lamps that can share a far field do.

    lamps: a list of what template() takes as its lamp. The rest is as for template(), and each
    template is, to the last bit, the one that template() makes.
    """
    if isinstance(lamps, (str, os.PathLike)):
        raise TypeError("lamps: expected a list of lamps")
    return _made("templates", list(lamps), pupil, eyelashes, progress, options)


def template(*, lamp="D65", pupil=None, eyelashes=None, progress=None, **options):
    """The glare template of an aperture and a lamp: a Template.

    lamp: a built-in name (see lamps()), 'blackbody:KELVIN', a CSV file of wavelength_nm,power, or
        the two arrays (wavelength_nm, power).
    pupil, eyelashes: amplitude transmittance, 0 opaque to 1 open, as an array (h, w) or a picture
        file; without both, the built-in eye.
    width_mm: physical width of these; needed for arrays and for files that don't tell it.
    progress: called every 50 ms, in this thread, with the share of the work done; Cancelled is
        raised where it returns False.

    The other options are those of `glare template`, with underscores: size (pixels: n, (w, h) or
    'WxH'), fov_deg (across the width), observer, wavelength_range_nm (lo, hi), colorspace, ocio,
    white ('none', 'lamp'), normalize ('peak', 'energy', 'absolute'), gamut ('keep', 'desaturate'),
    scatter ('none', 'cie') with age and pigment, defocus_d, zernike, chromatic_aberration,
    stiles_crawford, threads, memory_limit (bytes or '4GB'), and the built-in eye's: seed, time_s,
    pupil_mm, lid_opening_mm, upper_lashes, clear_media and so on. `glare template --help` and the
    type stub list them all.

    Raises OptionError, InputError, MemoryLimitError, Cancelled; TypeError for an unknown keyword.
    Warns (GlareWarning) of lamps that miss much of the light and of odd pictures.
    """
    return _made("template", [lamp], pupil, eyelashes, progress, options)[0]


def aperture(*, view="whole", progress=None, **options):
    """The built-in eye as a picture: an Aperture.

    view: 'whole', 'pupil' (and what is inside the eye) or 'eyelashes' (and lids).
    pixel_um: the largest pixel (default 4); or size: pixels, both ways.
    The other options are the built-in eye's, of `glare aperture eye`: seed, pupil_mm, age ...
    """
    words = _words("aperture", _EYE_KEYWORDS, options)
    return Aperture(*_glare.eye_picture(words, str(view), _callback(progress)))
