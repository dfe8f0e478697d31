"""The C interface through ctypes, as any language's foreign functions have it.

python3 c_interface.py LIBRARY
"""

import ctypes
import math
import sys
from ctypes import POINTER, byref, c_char, c_char_p, c_double, c_float, c_int32, c_size_t, c_void_p


class Error(ctypes.Structure):
    _fields_ = [("status", c_int32), ("message", c_char * 1020)]


class Pixels(ctypes.Structure):
    _fields_ = [("buffer", POINTER(c_float)), ("buffer_floats", c_size_t), ("first", c_size_t),
                ("width", c_int32), ("height", c_int32), ("channels", c_int32),
                ("pixel_stride", ctypes.c_ssize_t), ("row_stride", ctypes.c_ssize_t),
                ("channel_stride", ctypes.c_ssize_t)]


PROGRESS = ctypes.CFUNCTYPE(c_int32, c_double, c_void_p)


class TemplateOptions(ctypes.Structure):
    _fields_ = [("struct_size", c_size_t), ("width", c_int32), ("height", c_int32),
                ("field_of_view_deg", c_double), ("wavelength_lo_nm", c_double),
                ("wavelength_hi_nm", c_double), ("observer", c_char_p), ("color_space", c_char_p),
                ("ocio_config", c_char_p), ("white", c_int32), ("normalization", c_int32),
                ("gamut", c_int32), ("scatter", c_int32), ("age_years", c_double),
                ("pigment", c_double), ("threads", c_int32),
                ("memory_limit_bytes", ctypes.c_uint64), ("progress", PROGRESS),
                ("user", c_void_p)]


class FilterOptions(ctypes.Structure):
    _fields_ = [("struct_size", c_size_t), ("width", c_int32), ("height", c_int32),
                ("fov_deg", c_double), ("pixel_deg", c_double), ("perspective", c_int32),
                ("pixel_aspect", c_double), ("color_space", c_char_p), ("ocio_config", c_char_p),
                ("lamp_color", c_int32), ("grey", c_int32), ("edge", c_int32),
                ("threads", c_int32), ("memory_limit_bytes", ctypes.c_uint64)]


library = ctypes.CDLL(sys.argv[1])
library.glare_version.restype = c_char_p
error = Error()


def call(name, *arguments):
    status = getattr(library, name)(*arguments, byref(error))
    assert status == error.status
    if status != 0:
        raise RuntimeError(f"{status} {error.message.decode()}")


def refusal(name, *arguments):
    try:
        call(name, *arguments)
    except RuntimeError as refused:
        return str(refused)
    raise AssertionError(name + " was done")


assert library.glare_version().count(b".") == 2
lamp, template, filter_ = c_void_p(), c_void_p(), c_void_p()
assert refusal("glare_lamp_find", b"no such lamp", byref(lamp)).startswith("2 ")
call("glare_lamp_find", b"LED-B3", byref(lamp))

options = TemplateOptions()
call("glare_template_options_init", byref(options), c_size_t(ctypes.sizeof(options)))
assert options.width == 512 and options.field_of_view_deg == 5 and options.age_years == 35
options.width = options.height = 64
fractions = []


@PROGRESS
def note(fraction, _):
    fractions.append(fraction)
    return len(fractions) < 2


options.progress = note
assert refusal("glare_template_make_eye", None, lamp, byref(options), byref(template))[0] == "6"
assert not template and len(fractions) >= 2
options.progress = PROGRESS()
call("glare_template_make_eye", None, lamp, byref(options), byref(template))

frames = FilterOptions()
call("glare_filter_options_init", byref(frames), c_size_t(ctypes.sizeof(frames)))
frames.width, frames.height, frames.pixel_deg, frames.edge = 24, 16, 0.1, 1
call("glare_filter_make", template, byref(frames), byref(filter_))
library.glare_template_free(template)  # The filter needs it no more.

# With the border's own values beyond it, a picture of one value stays as it is.
values = (c_float * (24 * 16 * 3))(*[3.0] * (24 * 16 * 3))
pixels = Pixels()
call("glare_pixels_interleaved", byref(pixels), values, c_size_t(len(values)), c_int32(24),
     c_int32(16), c_int32(3))
call("glare_filter_apply", filter_, None, byref(pixels), None)
# Sums of a few thousand shares in single precision.
assert all(math.isclose(value, 3.0, rel_tol=1e-5) for value in values)
pixels.width = 25
assert refusal("glare_filter_apply", filter_, None, byref(pixels), None).startswith("2 ")

library.glare_filter_free(filter_)
library.glare_lamp_free(lamp)
print("c_interface.py: all as it should be")
