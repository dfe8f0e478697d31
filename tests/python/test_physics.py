"""Laws that the templates keep, seen from Python."""
import glare
import numpy as np
import pytest
from pupils import bessel_j1, disc, narrow_line

pytestmark = pytest.mark.filterwarnings("ignore:lamp:glare.GlareWarning")
WAVELENGTH_NM, DIAMETER_MM, WIDTH_MM = 550.0, 2.0, 4.0


@pytest.fixture(scope="module")
def airy():
    return glare.template(pupil=disc(512, DIAMETER_MM / WIDTH_MM), width_mm=WIDTH_MM,
                          lamp=narrow_line(WAVELENGTH_NM), size=257, fov_deg=0.1,
                          normalize="absolute")


def radii_rad(template):
    x, y = template.center_px
    rows, columns = np.mgrid[:template.height, :template.width]
    return np.hypot(columns - x, rows - y) * template.pixel_pitch_rad


def test_airy_pattern(airy):
    # t at the edge is between 0 and 1, so that the integral of t^2 is less than the area.
    peak_area_m2 = (np.pi / 4 * DIAMETER_MM ** 2) ** 2 / airy.aperture_area_mm2 * 1e-6
    wavelength_m = WAVELENGTH_NM * 1e-9
    x = np.pi * DIAMETER_MM * 1e-3 * radii_rad(airy) / wavelength_m
    x[airy.center_px[1], airy.center_px[0]] = 1e-9
    expected = peak_area_m2 / wavelength_m ** 2 * (2 * bessel_j1(x) / x) ** 2
    # A pixel is a mean over a fiftieth of the dark ring's radius: 0.1 % of the peak at most.
    np.testing.assert_allclose(airy.luminance, expected, atol=1e-3 * expected.max())


def test_first_dark_ring_and_its_energy(airy):
    dark_rad = 1.2197 * WAVELENGTH_NM * 1e-6 / DIAMETER_MM
    row = airy.luminance[airy.center_px[1], airy.center_px[0]:]
    darkest = np.argmin(row[:int(1.5 * dark_rad / airy.pixel_pitch_rad)])
    assert abs(darkest * airy.pixel_pitch_rad - dark_rad) <= airy.pixel_pitch_rad
    # Rayleigh: 83.8 % within the first dark ring, by the area as above; pixels there count by their
    # share of area, to 0.1 %.
    share = airy.encircled_energy(np.degrees(dark_rad)) / (np.pi / 4 * DIAMETER_MM ** 2)
    assert share * airy.aperture_area_mm2 == pytest.approx(0.838, abs=1e-3)


def test_pixels_times_solid_angle_are_the_captured_energy(airy):
    total = airy.luminance.sum(dtype=float) * airy.pixel_pitch_rad ** 2
    assert total == pytest.approx(airy.captured_energy, rel=1e-5)  # Sums of floats.
    assert airy.per_steradian == 1


def test_longer_wavelengths_spread_wider():
    widths = []
    for wavelength_nm in (450.0, 675.0):
        t = glare.template(pupil=disc(256, 0.5), width_mm=WIDTH_MM, lamp=narrow_line(wavelength_nm),
                           size=129, fov_deg=0.1, observer="cie1964-10deg")
        row = t.luminance[64, 64:]
        widths.append(np.interp(-0.5, -row[:30] / row[0], np.arange(30)))
    # Proportional to wavelength; half a pixel of the interpolation over some ten.
    assert widths[1] / widths[0] == pytest.approx(675 / 450, rel=0.02)


def test_orientation_right_and_down():
    """A slit that stands upright spreads light sideways."""
    slit = np.zeros((256, 256), np.float32)
    slit[64:192, 120:136] = 1
    y = glare.template(pupil=slit, width_mm=WIDTH_MM, size=129, fov_deg=0.4).luminance
    assert y[64, :].sum() > 4 * y[:, 64].sum()


def test_straylight_is_the_cie_equation():
    options = {"pupil": disc(256, 0.5), "width_mm": 0.5, "size": 64, "fov_deg": 8,
               "normalize": "absolute"}
    t = glare.template(scatter="cie", age=70, pigment=1, **options)
    profile, diffraction = t.radial_profile(), glare.template(**options).radial_profile()
    straylight = profile.mean_per_steradian - (1 - t.scattered_energy) * diffraction[2]
    outside = profile.inner_deg > 0.13
    # Nearer the axis the equation is softened; from there on by less than 0.04 %.
    np.testing.assert_allclose(straylight[outside], t.cie_profile(70, 1)[outside], rtol=1e-3)
    assert outside.sum() > 5 and 0 < t.scattered_energy < 1
    assert glare.cie_glare(1.0, 70, 1) == pytest.approx(
        10 + (5 + 0.1) * (1 + (70 / 62.5) ** 4) + 0.0025)


def test_energy_in_no_circle(airy):
    assert np.isnan(airy.encircled_energy([np.nan, -1])).all()
