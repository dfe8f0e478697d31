"""Pictures and options that glare.apply and glare.Filter refuse."""
import glare
import numpy as np
import pytest


@pytest.fixture(scope="module")
def veil():
    return glare.template(pupil=np.ones((64, 64)), width_mm=0.5, size=65, fov_deg=2)


GOOD = np.ones((8, 9, 3), np.float32)


@pytest.mark.parametrize("image, options, error, words", [
    (GOOD, {"fov_deg": None}, glare.OptionError, "either fov_deg or pixel_deg"),
    (GOOD, {"pixel_deg": 1}, glare.OptionError, "either fov_deg or pixel_deg"),
    (GOOD, {"fov_deg": -1}, glare.OptionError, ""),
    (GOOD, {"fov_deg": float("nan")}, glare.OptionError, ""),
    (GOOD, {"fov_deg": "wide"}, TypeError, "fov_deg: expected a number"),
    (GOOD, {"strength": None}, TypeError, "strength: expected a number"),
    (GOOD, {"threads": 2000}, glare.OptionError, "threads"),
    (GOOD, {"threads": 1.5}, TypeError, "threads"),
    (GOOD, {"memory_limit": "4 apples"}, glare.OptionError, "memory_limit"),
    (GOOD, {"memory_limit": "1kB"}, glare.MemoryLimitError, "memory"),
    (GOOD, {"progress": 3}, TypeError, "progress"),
    (GOOD, {"pixel_aspect": 0}, glare.OptionError, ""),
    (GOOD, {"strength": float("nan")}, glare.OptionError, ""),
    (GOOD, {"threshold": -1}, glare.OptionError, ""),
    (GOOD, {"knee": 2}, glare.OptionError, ""),
    (GOOD, {"exposure": 1000}, glare.OptionError, ""),
    (GOOD, {"edge": "wrap"}, glare.OptionError, "black or extend"),
    (GOOD, {"lamp_color": "red"}, glare.OptionError, "divide or keep"),
    (GOOD, {"colorspace": "mine"}, glare.OptionError, "colour space"),
    (GOOD, {"sources": "points.csv"}, TypeError, "sources"),
    (GOOD, {"sources": "auto", "new_sources": True}, glare.OptionError, "new_sources"),
    (GOOD, {"new_sources": True}, glare.OptionError, "sources"),
    (GOOD, {"sources": [[1, 2, 3]]}, glare.InputError, "(n, 5)"),
    (GOOD, {"sources": [[1, 2, 3, 4, float("nan")]]}, glare.OptionError, ""),
    (GOOD, {"sources": [[float("inf"), 2, 3, 4, 5]]}, glare.OptionError, ""),
    (GOOD, {"sources": [[1, 2, 3, 4, 5]], "threshold": 1}, glare.OptionError, "threshold"),
    (GOOD, {"sources": [[1, 2, 3, 4, 5]], "edge": "extend"}, glare.OptionError, "edge"),
    (GOOD, {"sources": [[1, 2, 3, 4, 5]], "exposure": float("nan")}, glare.OptionError, ""),
    (GOOD, {"out": np.ones((8, 9))}, glare.InputError, "out"),
    (GOOD, {"out": np.ones((8, 9, 3), np.uint8)}, TypeError, "out"),
    (GOOD, {"memory_limit": 1}, glare.MemoryLimitError, "memory"),
    (GOOD.astype(np.uint8), {}, TypeError, "scene-linear"),
    (GOOD * 1j, {}, TypeError, "scene-linear"),
    ("image.exr", {}, TypeError, "scene-linear"),
    (GOOD[0, 0], {}, glare.InputError, "(h, w"),
    (np.ones((8, 9, 2)), {}, glare.InputError, "(h, w"),
    (np.ones((0, 9, 3)), {}, glare.InputError, "(h, w"),
    (np.ones((1, 70000)), {}, glare.InputError, "65535"),
])
def test_apply_refuses(veil, image, options, error, words):
    with pytest.raises(error) as caught:
        glare.apply(image, veil, **{"fov_deg": 3, **options})
    assert words in str(caught.value)


def test_filter_refuses(veil):
    prepared = glare.Filter(veil, 9, 8, fov_deg=3)
    for image in (np.ones((9, 8, 3)), np.ones((8, 9))):
        with pytest.raises(glare.InputError):
            prepared.apply(image)
    for size in ((0, 9), (9, 70000), (-1, 1)):
        with pytest.raises((glare.InputError, glare.OptionError)):
            glare.Filter(veil, *size, fov_deg=3)
    for args, name in (((None, 9, 8), "template"), (("t.exr", 9, 8), "template"),
                       ((veil, 9.5, 8), "width")):
        with pytest.raises(TypeError, match=name):
            glare.Filter(*args, fov_deg=3)
