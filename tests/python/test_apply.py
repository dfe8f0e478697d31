"""Glare on pictures: what goes where, from arrays of any kind."""
import threading
import warnings

import glare
import numpy as np
import pytest
from pupils import disc

FLOAT_NOISE = 1e-6  # Of the largest value: sums and transforms of floats.
PITCH_DEG = 2 / 65


@pytest.fixture(scope="module")
def veil():
    """65 pixels of PITCH_DEG, lopsided, of a lamp that isn't white."""
    pupil = disc(64, 0.9)
    pupil[:20, :30] = 0
    return glare.template(pupil=pupil, width_mm=0.5, size=65, fov_deg=2, lamp="A")


def impulse(height, width, row, column, channels=(3,)):
    image = np.zeros((height, width, *channels), np.float32)
    image[row, column] = 1
    return image


def shares(veil):
    """Where the light of a pixel of the template's own pitch goes, channel by channel."""
    lamp_rgb = np.linalg.inv(veil.xyz_from_rgb) @ veil.lamp_xyz
    solid_angle = veil.pixel_pitch_rad ** 2
    return veil.rgb.astype(float) * veil.per_steradian * solid_angle / lamp_rgb


@pytest.mark.parametrize("row, column", [(40, 45), (40, 44)])
def test_impulse_gives_the_template(veil, row, column):
    out = glare.apply(impulse(81, 90, row, column), veil, pixel_deg=PITCH_DEG)
    expected = np.zeros((81, 90, 3))
    expected[row - 32:row + 33, column - 32:column + 33] = shares(veil)
    expected[row, column] += 1 - shares(veil).sum(axis=(0, 1))  # Beyond the field: it stays.
    np.testing.assert_allclose(out, expected, atol=FLOAT_NOISE)
    assert out.dtype == np.float32
    np.testing.assert_allclose(out.sum(axis=(0, 1)), 1, atol=1e-5)


def test_field_of_view_and_its_meanings(veil):
    image = impulse(65, 130, 32, 65)
    of_pitch = glare.apply(image, veil, pixel_deg=PITCH_DEG)
    of_field = glare.apply(image, veil, fov_deg=130 * PITCH_DEG)
    # The pitch is the template's own to rounding, which a kernel follows.
    np.testing.assert_allclose(of_field, of_pitch, atol=FLOAT_NOISE)
    field_deg = 2 * np.degrees(np.arctan(130 * np.radians(PITCH_DEG) / 2))
    of_perspective = glare.apply(image, veil, fov_deg=field_deg, perspective=True)
    np.testing.assert_allclose(of_perspective, of_pitch, atol=FLOAT_NOISE)


def test_constant_stays(veil):
    image = np.full((50, 70, 3), 0.25, np.float32) * np.float32([1, 2, 4])
    out = glare.apply(image, veil, fov_deg=4, edge="extend")
    np.testing.assert_allclose(out, image, rtol=1e-5)
    darker = glare.apply(image, veil, fov_deg=4)
    assert (darker[0, 0] < image[0, 0]).all()


@pytest.mark.parametrize("height, width", [(1, 1), (3, 8), (20, 2)])
def test_small_constant_picture_stays(veil, height, width):
    """The template's field is many times as large: what lies beyond the border counts."""
    image = np.full((height, width, 3), 0.25, np.float32)
    out = glare.apply(image, veil, pixel_deg=PITCH_DEG, edge="extend")
    np.testing.assert_allclose(out, image, rtol=1e-5)


def test_linear_and_only_glare(veil):
    image = np.random.default_rng(1).random((40, 60, 3), dtype=np.float32)
    whole = glare.apply(image, veil, fov_deg=3)
    added = glare.apply(image, veil, fov_deg=3, only_glare=True)
    np.testing.assert_allclose(image + added, whole, atol=FLOAT_NOISE)
    np.testing.assert_allclose(glare.apply(image, veil, fov_deg=3, strength=0.5),
                               image + added / 2, atol=FLOAT_NOISE)
    np.testing.assert_allclose(glare.apply(image, veil, fov_deg=3, exposure=2), 4 * whole,
                               atol=4 * FLOAT_NOISE)
    np.testing.assert_array_equal(glare.apply(image, veil, fov_deg=3, threshold=10), image)


def test_grey_is_the_luminance(veil):
    out = glare.apply(impulse(81, 81, 40, 40, ()), veil, pixel_deg=PITCH_DEG)
    expected = np.zeros((81, 81))
    expected[8:73, 8:73] = veil.luminance * veil.per_steradian * veil.pixel_pitch_rad ** 2
    expected[40, 40] += 1 - expected.sum()
    assert out.shape == (81, 81)
    np.testing.assert_allclose(out, expected, atol=FLOAT_NOISE)


def test_alpha_is_kept(veil):
    image = np.random.default_rng(2).random((20, 30, 4), dtype=np.float32)
    out = glare.apply(image, veil, fov_deg=3)
    np.testing.assert_array_equal(out[..., 3], image[..., 3])
    np.testing.assert_array_equal(out[..., :3], glare.apply(image[..., :3], veil, fov_deg=3))


def test_kinds_of_arrays(veil):
    values = np.random.default_rng(3).random((24, 36, 3)).astype(np.float16)
    expected = glare.apply(values.astype(np.float32), veil, fov_deg=3)
    padded = np.zeros((48, 36, 5), np.float64)
    padded[::2, :, 1:4] = values
    for image in (values, values.astype(np.float64), np.asfortranarray(values, np.float32),
                  padded[::2, :, 1:4], values.astype(">f4")):
        np.testing.assert_array_equal(glare.apply(image, veil, fov_deg=3), expected)
    mirrored = glare.apply(values[::-1], veil, fov_deg=3)  # Strides below 0.
    np.testing.assert_array_equal(mirrored, glare.apply(values[::-1].copy(), veil, fov_deg=3))
    read_only = values.copy()
    read_only.flags.writeable = False
    np.testing.assert_array_equal(glare.apply(read_only, veil, fov_deg=3), expected)


def test_out(veil):
    image = np.random.default_rng(4).random((24, 36, 3), dtype=np.float32)
    expected, given = glare.apply(image, veil, fov_deg=3), image.copy()
    out = np.empty((24, 36, 3), np.float64)
    assert glare.apply(given, veil, fov_deg=3, out=out) is out
    np.testing.assert_array_equal(out, expected)
    np.testing.assert_array_equal(given, image)
    assert glare.apply(given, veil, fov_deg=3, out=given) is given
    np.testing.assert_array_equal(given, expected)


def test_filter_serves_many_frames(veil):
    frames = np.random.default_rng(5).random((4, 24, 36, 3), dtype=np.float32)
    prepared = glare.Filter(veil, 36, 24, fov_deg=3, edge="extend")
    assert (prepared.width, prepared.height) == (36, 24) and prepared.kept.shape == (3,)
    results = [None] * len(frames)

    def work(i):
        results[i] = prepared.apply(frames[i], threshold=0.1)

    workers = [threading.Thread(target=work, args=(i,)) for i in range(len(frames))]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    for frame, result in zip(frames, results):
        expected = glare.apply(frame, veil, fov_deg=3, edge="extend", threshold=0.1)
        np.testing.assert_array_equal(result, expected)


def test_unusable_pixels_are_told_and_kept(veil):
    image = np.full((24, 36, 3), 0.5)
    image[2, 3, 1], image[5, 6, 0], image[7, 8, 2], image[9, 9, 0] = np.nan, np.inf, -1, 1e300
    with pytest.warns(glare.GlareWarning, match="1 NaN and 2 infinite and 1 negative") as caught:
        out = glare.apply(image, veil, fov_deg=3)
    assert caught[0].filename == __file__
    assert np.isnan(out[2, 3, 1]) and np.isinf(out[5, 6, 0]) and out[7, 8, 2] < 0
    assert np.isfinite(out).sum() >= out.size - 9  # Of three pixels.
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        glare.apply(np.ones((4, 4, 3)), veil, fov_deg=3)


def test_points_are_the_picture_of_them(veil):
    image = impulse(81, 90, 40, 45) * np.float32([3, 2, 1]) + impulse(81, 90, 10, 80)
    points = [[45, 40, 3, 2, 1], [80, 10, 1, 1, 1]]
    expected = glare.apply(image, veil, pixel_deg=PITCH_DEG)
    # Both ways differ by rounding only, here of sums around 3.
    of_points = glare.apply(image, veil, pixel_deg=PITCH_DEG, sources=points)
    np.testing.assert_allclose(of_points, expected, atol=3e-6)
    added = glare.apply(image, veil, pixel_deg=PITCH_DEG, sources=points, only_glare=True)
    np.testing.assert_allclose(added, expected - image, atol=3e-6)
    new = glare.apply(np.zeros_like(image), veil, pixel_deg=PITCH_DEG, sources=points,
                      new_sources=True)
    np.testing.assert_allclose(new, expected, atol=3e-6)
    brighter = glare.apply(image, veil, pixel_deg=PITCH_DEG, sources=points, exposure=1)
    np.testing.assert_allclose(brighter, 2 * expected, atol=6e-6)


def test_no_points(veil):
    image = np.ones((4, 5, 3), np.float32)
    for none in ([], np.empty((0, 5))):
        np.testing.assert_array_equal(glare.apply(image, veil, fov_deg=3, sources=none), image)


def test_points_of_grey_pictures(veil):
    grey = glare.apply(np.zeros((81, 81)), veil, pixel_deg=PITCH_DEG, sources=[[40, 40, 3, 2, 1]],
                       new_sources=True)
    luminance = np.dot(veil.xyz_from_rgb[1], [3, 2, 1])
    expected = luminance * glare.apply(impulse(81, 81, 40, 40, ()), veil, pixel_deg=PITCH_DEG)
    np.testing.assert_allclose(grey, expected, atol=3e-6)


def test_points_beside_the_picture(veil):
    wide = glare.apply(np.zeros((60, 60, 3)), veil, pixel_deg=PITCH_DEG,
                       sources=[[5, 30, 1, 1, 1]], new_sources=True)
    narrow = glare.apply(np.zeros((60, 10, 3)), veil, pixel_deg=PITCH_DEG,
                         sources=[[-15, 30, 1, 1, 1]], new_sources=True)
    np.testing.assert_allclose(narrow, wide[:, 20:30], atol=FLOAT_NOISE)
    assert narrow.max() > 0


def test_points_leave_what_is_not_finite(veil):
    image = np.zeros((81, 81, 3), np.float32)
    image[40, 42, 1] = np.nan
    out = glare.apply(image, veil, pixel_deg=PITCH_DEG, sources=[[40, 40, 1, 1, 1]])
    assert np.isnan(out[40, 42, 1]) and (out[40, 42, ::2] == 0).all() and out[40, 38, 0] > 0


def test_lamp_color(veil):
    white = impulse(81, 81, 40, 40)
    divided = glare.apply(white, veil, pixel_deg=PITCH_DEG).sum(axis=(0, 1))
    kept = glare.apply(white, veil, pixel_deg=PITCH_DEG, lamp_color="keep").sum(axis=(0, 1))
    np.testing.assert_allclose(divided, 1, atol=1e-5)
    assert kept[0] > 1 > kept[2]  # Halogen is yellowish.


def test_picture_in_another_space(veil):
    """With the lamp's colour kept, a white point's glare is the template's colours in any space."""
    def glare_in(colorspace):
        out = glare.apply(impulse(81, 81, 40, 40), veil, pixel_deg=PITCH_DEG, lamp_color="keep",
                          only_glare=True, colorspace=colorspace)
        out[40, 40] = 0  # The point itself, whose white is another one.
        return out

    xyz = glare_in("xyz")
    np.testing.assert_allclose(glare_in("lin_rec709") @ veil.xyz_from_rgb.T, xyz, atol=FLOAT_NOISE)
    xyz_from_acescg = glare.template(pupil=np.ones((8, 8)), width_mm=0.5, size=8, fov_deg=0.1,
                                     colorspace="acescg").xyz_from_rgb
    np.testing.assert_allclose(glare_in("acescg") @ xyz_from_acescg.T, xyz, atol=FLOAT_NOISE)


def test_progress_stops(veil):
    image = np.ones((2000, 2000, 3), np.float32)
    with pytest.raises(glare.Cancelled):
        glare.apply(image, veil, fov_deg=3, threads=1, progress=lambda share: False)
