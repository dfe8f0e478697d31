"""Glare on pictures: arrays in, arrays out."""

import numbers
import os
import warnings

import numpy as np

from . import _glare
from ._glare import InputError, OptionError


class GlareWarning(UserWarning):
    """Something odd in an input, which is used all the same."""


def _number(name, value):
    if isinstance(value, numbers.Real) and not isinstance(value, (bool, np.bool_)):
        return float(value)
    raise TypeError(f"{name}: expected a number, not {type(value).__name__}")


def _whole_number(name, value, highest):
    if not isinstance(value, numbers.Integral) or isinstance(value, bool):
        raise TypeError(f"{name}: expected a whole number, not {type(value).__name__}")
    if not 0 <= value <= highest:
        raise OptionError(f"{name}: expected 0 to {highest}, not {value}")
    return int(value)


def _memory_limit(value):
    if isinstance(value, str):
        return _glare.memory_bytes(value)
    return _whole_number("memory_limit", value, 2 ** 60)


def _threads(value):
    return _whole_number("threads", value, 1024)


def _template(template):
    if not isinstance(template, _glare.Template):
        raise TypeError(f"template: expected a Template, not {type(template).__name__}")
    return template


def _callback(progress):
    if progress is not None and not callable(progress):
        raise TypeError("progress: expected a callable of one number, or None")
    return progress


def _image(image):
    """The image as (h, w, channels), whatever it was."""
    array = np.asarray(image)
    if array.dtype.kind != "f" or array.dtype.itemsize not in (2, 4, 8):
        raise TypeError("image: expected scene-linear values of float16, float32 or float64, "
                        f"not {array.dtype}")
    planes = array[:, :, np.newaxis] if array.ndim == 2 else array
    if planes.ndim != 3 or planes.shape[2] not in (1, 3, 4) or 0 in planes.shape:
        raise InputError(f"image: expected (h, w), (h, w, 3) or (h, w, 4), not {array.shape}")
    if max(planes.shape[:2]) > 65535:
        raise InputError(f"image: expected at most 65535 pixels each way, not {array.shape}")
    return array, planes


def _output(out, shape):
    if out is None:
        return np.empty(shape, dtype=np.float32)
    if not isinstance(out, np.ndarray) or out.dtype not in (np.float32, np.float64):
        raise TypeError("out: expected an array of float32 or float64")
    if out.shape != shape or not out.flags.writeable:
        raise InputError(f"out: expected a writable array of the image's shape {shape}")
    return out


def _buffer_of(planes):
    """The image's colours in float32, channel by channel; grey three times."""
    height, width, channels = planes.shape
    buffer = _glare.PictureBuffer(width, height)
    with np.errstate(over="ignore"):  # Too large for float32: counted as infinite.
        for k, channel in enumerate(buffer.channels):
            np.copyto(channel, planes[:, :, 0 if channels == 1 else k], casting="same_kind")
    return buffer


def _result(buffer, array, planes, out):
    """The buffer's colours, with the image's alpha, in the image's shape."""
    result = _output(out, array.shape)
    if planes.shape[2] == 4:
        result[..., 3] = array[..., 3]
    view = result[:, :, np.newaxis] if result.ndim == 2 else result
    for k in range(min(planes.shape[2], 3)):
        view[:, :, k] = buffer.channels[k]
    return result


def _warn_of(counts, stacklevel):
    if not any(counts):
        return
    what = " and ".join(f"{count} {kind}" for count, kind in
                        zip(counts, ("NaN", "infinite", "negative")) if count)
    warnings.warn(f"pixels that give no light to the glare and stay as they are: {what}",
                  GlareWarning, stacklevel=stacklevel + 1)


def _kind(fov_deg, pixel_deg, perspective, pixel_aspect, colorspace, ocio, lamp_color, grey):
    return _glare.PictureKind(
        fov_deg=None if fov_deg is None else _number("fov_deg", fov_deg),
        pixel_deg=None if pixel_deg is None else _number("pixel_deg", pixel_deg),
        perspective=bool(perspective), pixel_aspect=_number("pixel_aspect", pixel_aspect),
        colorspace=str(colorspace), ocio="" if ocio is None else os.fspath(ocio),
        lamp_color=str(lamp_color), grey=grey)


def _bright_part(exposure, threshold, knee):
    return _glare.BrightPart(exposure=_number("exposure", exposure),
                             threshold=_number("threshold", threshold), knee=_number("knee", knee))


class Filter:
    """A template made ready for many pictures of one size; several threads may use it at once.

    width, height: pixels. grey: for pictures (h, w), with the template's luminance.
    The other options are those of apply(). Raises OptionError, InputError, MemoryLimitError.
    """

    def __init__(self, template, width, height, *, fov_deg=None, pixel_deg=None, perspective=False,
                 pixel_aspect=1.0, edge="black", lamp_color="divide", colorspace="lin_rec709",
                 ocio=None, grey=False, threads=0, memory_limit=0):
        self._grey = bool(grey)
        self._shape = (_whole_number("height", height, 65535), _whole_number("width", width, 65535))
        kind = _kind(fov_deg, pixel_deg, perspective, pixel_aspect, colorspace, ocio, lamp_color,
                     self._grey)
        self._filter = _glare.Filter(
            _template(template), self.width, self.height, kind=kind, edge=str(edge),
            threads=_threads(threads),
            memory_limit=_memory_limit(memory_limit))

    @property
    def width(self):
        """Pixels across of the pictures."""
        return self._shape[1]

    @property
    def height(self):
        """Pixels down of the pictures."""
        return self._shape[0]

    @property
    def kept(self):
        """Share of a pixel's light that stays in it, for R, G and B: (3,) float64."""
        return np.array(self._filter.kept)

    def apply(self, image, *, exposure=0.0, threshold=0.0, knee=0.5, strength=1.0, only_glare=False,
              threads=0, progress=None, out=None):
        """The picture with its glare, as apply() has it; of the size the filter was made for."""
        return self._apply(image, exposure, threshold, knee, strength, only_glare, threads,
                           progress, out)

    def _apply(self, image, exposure, threshold, knee, strength, only_glare, threads, progress,
               out):
        array, planes = _image(image)
        if planes.shape[:2] != self._shape:
            raise InputError(f"image: expected (h, w) of {self._shape}, not {planes.shape[:2]}")
        if (planes.shape[2] == 1) != self._grey:
            raise InputError("image: a filter with grey=True is for pictures (h, w), "
                             "and any other for pictures (h, w, 3) or (h, w, 4)")
        _output(out, array.shape) if out is not None else None
        bright = _bright_part(exposure, threshold, knee)
        buffer = _buffer_of(planes)
        counts = self._filter.apply(buffer, bright=bright, strength=_number("strength", strength),
                                    only_glare=bool(only_glare), threads=_threads(threads),
                                    progress=_callback(progress))
        _warn_of(counts, stacklevel=3)
        return _result(buffer, array, planes, out)


def _points(sources):
    try:
        points = np.array(sources, dtype=np.float64, ndmin=2, copy=True)
    except (TypeError, ValueError):
        raise TypeError("sources: expected 'auto', or an array (n, 5) of x, y, r, g, b") from None
    if points.size == 0:
        return np.empty((0, 5))
    if points.ndim != 2 or points.shape[1] != 5:
        raise InputError(f"sources: expected an array (n, 5) of x, y, r, g, b, not {points.shape}")
    return points


def _gain(exposure):
    if not -64 <= _number("exposure", exposure) <= 64:
        raise OptionError("exposure must be from -64 to 64")
    return np.float32(2.0 ** exposure)


def _apply_points(image, template, kind, points, exposure, strength, only_glare, new_sources,
                  threads, progress, out):
    """The picture, exposed, with the glare of points, which are."""
    array, planes = _image(image)
    gain = _gain(exposure)
    added = _glare.PictureBuffer(planes.shape[1], planes.shape[0])
    _glare.add_points(added, points, _template(template), kind=kind,
                      strength=_number("strength", strength), are_new=bool(new_sources),
                      threads=_threads(threads), progress=_callback(progress))
    if only_glare:
        return _result(added, array, planes, out)
    buffer = _buffer_of(planes)
    with np.errstate(over="ignore"):
        for channel in buffer.channels:
            channel *= gain
    gets_light = np.logical_and.reduce([np.isfinite(channel) for channel in buffer.channels])
    for channel, light in zip(buffer.channels, added.channels):
        np.add(channel, light, out=channel, where=gets_light)
    return _result(buffer, array, planes, out)


def apply(image, template, *, fov_deg=None, pixel_deg=None, perspective=False, pixel_aspect=1.0,
          edge="black", threshold=0.0, knee=0.5, strength=1.0, exposure=0.0, only_glare=False,
          lamp_color="divide", colorspace="lin_rec709", ocio=None, sources=None, new_sources=False,
          threads=0, memory_limit=0, progress=None, out=None):
    """A picture with its glare: each pixel's light spread as the template says.

    image: scene-linear (h, w, 3), (h, w, 4) with alpha, which is kept, or (h, w) of luminance;
        float16, 32 or 64, any strides. The result is a new float32 array of the same shape, or
        `out` (float32 or float64; may be the image).
    fov_deg: the picture's field of view across its width, or pixel_deg: degrees from pixel to
        pixel; one is needed. perspective: fov_deg is that of a pinhole camera.
    pixel_aspect: a pixel's width over its height.
    edge: what lies beyond the border, 'black' or 'extend' (the border's own values).
    threshold, knee: luminance from which on light is spread, and half the width of the soft step
        there as a share of it. strength: of the change. exposure: in stops, first.
    only_glare: the result is what was added, negative where light was taken.
    lamp_color: 'divide': white light stays white as a whole; 'keep': it gets the lamp's colour.
    colorspace: of the picture, a name as of `glare template --colorspace`; ocio: a config.
    sources: (n, 5) of x, y (pixels; whole numbers are pixels' centres), r, g, b (value times
        pixels; for grey pictures their luminance counts): the glare of these points, which may be
        beside the picture, instead of the whole picture's. new_sources: they aren't in the picture
        yet, so that no light is taken from it. 'auto': the picture's own bright pixels, where a
        few hold all but 0.05 % of the light that is spread; else it is the whole picture's.
    memory_limit: bytes or '4GB'; 0: three quarters of the machine's.
    progress: called every 50 ms, in this thread, with the share done; False stops (Cancelled).

    Light is only moved: what falls beyond the template's field stays in its pixel. Pixels that
    aren't finite give no light and stay as they are, as do negative channels; GlareWarning says how
    many. For several pictures of one size make a Filter, once.
    Raises OptionError, InputError, MemoryLimitError, Cancelled; TypeError for other dtypes.
    """
    array, planes = _image(image)
    height, width, channels = planes.shape
    grey = channels == 1
    if out is not None:
        _output(out, array.shape)
    kind = _kind(fov_deg, pixel_deg, perspective, pixel_aspect, colorspace, ocio, lamp_color, grey)
    if isinstance(sources, str) and sources == "auto":
        if new_sources:
            raise OptionError("new_sources goes with sources that are told")
        counts, points = _glare.find_points(
            _buffer_of(planes), kind=kind, bright=_bright_part(exposure, threshold, knee),
            edge=str(edge), threads=_threads(threads))
        if points is not None:
            _warn_of(counts, stacklevel=2)
            return _apply_points(image, template, kind, points, exposure, strength, only_glare,
                                 False, threads, progress, out)
    elif sources is not None:
        if threshold != 0 or edge != "black":
            raise OptionError("threshold and edge don't go with sources: these are spread whole")
        points = _points(sources)
        points[:, 2:] *= _gain(exposure)
        return _apply_points(image, template, kind, points, exposure, strength, only_glare,
                             new_sources, threads, progress, out)
    elif new_sources:
        raise OptionError("new_sources goes with sources")
    prepared = Filter(template, width, height, fov_deg=fov_deg, pixel_deg=pixel_deg,
                      perspective=perspective, pixel_aspect=pixel_aspect, edge=edge,
                      lamp_color=lamp_color, colorspace=colorspace, ocio=ocio, grey=grey,
                      threads=threads, memory_limit=memory_limit)
    return prepared._apply(image, exposure, threshold, knee, strength, only_glare, threads,
                           progress, out)
