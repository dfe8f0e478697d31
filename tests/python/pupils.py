"""Pupils and lamps as arrays, for the tests."""
import numpy as np


def disc(size, diameter_share, finer=8):
    """(size, size): the share of each pixel's square within a disc in the picture's middle."""
    places = (np.arange(size * finer) + 0.5) / (size * finer) - 0.5
    inside = np.hypot(places[:, None], places[None, :]) < diameter_share / 2
    return inside.reshape(size, finer, size, finer).mean(axis=(1, 3)).astype(np.float32)


def narrow_line(wavelength_nm, half_width_nm=0.5):
    """A triangle of a spectrum."""
    return (np.array([wavelength_nm - half_width_nm, wavelength_nm, wavelength_nm + half_width_nm]),
            np.array([0.0, 1.0, 0.0]))


def bessel_j1(x):
    """By Bessel's integral, whose trapezoidal sum is exact to rounding for |x| < 100."""
    angle = (np.arange(200) + 0.5) * np.pi / 200
    return np.cos(angle - np.multiply.outer(x, np.sin(angle))).mean(axis=-1)
