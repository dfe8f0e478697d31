"""The plots of docs/python.md: what a glare template is made of, drawn with Matplotlib.

    physics_plots.py [FOLDER [--quick]]      writes PNG files; --quick makes them coarse

The cells (# %%) run one by one in an editor that knows them.
"""
# %% What is needed
import argparse
import pathlib
import warnings

import glare
import matplotlib.pyplot as plt
import numpy as np

parser = argparse.ArgumentParser(description="Plots of the physics of glare templates")
parser.add_argument("folder", nargs="?", default="plots", type=pathlib.Path)
parser.add_argument("--quick", action="store_true", help="coarse, for a test")
options = parser.parse_args()
options.folder.mkdir(parents=True, exist_ok=True)
SIZE, EYE_FOV_DEG = (129, 3) if options.quick else (513, 10)

plt.rcParams.update({"figure.dpi": 90, "font.size": 9, "axes.grid": True, "grid.alpha": 0.3,
                     "axes.spines.top": False, "axes.spines.right": False,
                     "legend.frameon": False, "lines.linewidth": 1.4})


def finished(figure, name):
    """Writes a figure, without the time and the versions that would make its bytes change."""
    figure.savefig(options.folder / f"{name}.png", metadata={"Software": None})
    plt.close(figure)


def round_pupil(diameter_share, size=512, finer=4):
    """(size, size): the share of each pixel that is within a disc in the middle."""
    places = (np.arange(size * finer) + 0.5) / (size * finer) - 0.5
    inside = np.hypot(places[:, None], places) < diameter_share / 2
    return inside.reshape(size, finer, size, finer).mean(axis=(1, 3), dtype=np.float32)


def radii_deg(template):
    """(h, w): each pixel's angle from the axis."""
    column, row = template.center_px
    y, x = np.mgrid[:template.height, :template.width]
    return np.hypot(x - column, y - row) * template.pixel_pitch_deg


def ring_means(template, values, edges_deg):
    """The means of (h, w, ...) values between the edges of rings: (rings, ...)."""
    ring = np.digitize(radii_deg(template), edges_deg) - 1
    return np.array([values[ring == i].mean(axis=0) for i in range(len(edges_deg) - 1)])


def displayed(rgb, white, decades=5):
    """Scene-linear Rec.709 as sRGB values for a display, on a logarithmic scale up to white."""
    y = np.maximum(rgb @ [0.2126, 0.7152, 0.0722], 1e-30)[..., None]
    shown = np.clip(1 + np.log10(y / white) / decades, 0, 1) * np.clip(rgb / y, 0, None)
    shown /= np.maximum(shown.max(axis=-1, keepdims=True), 1)
    return np.where(shown <= 0.0031308, 12.92 * shown, 1.055 * shown ** (1 / 2.4) - 0.055)


# %% A round pupil gives Airy's pattern
diameter_mm, wavelength_nm = 3.0, 555.0
line = ([wavelength_nm - 1, wavelength_nm, wavelength_nm + 1], [0, 1, 0])
warnings.filterwarnings("ignore", "lamp array", glare.GlareWarning)  # That it is a line only.
airy = glare.template(pupil=round_pupil(0.6), width_mm=diameter_mm / 0.6, lamp=line, fov_deg=0.15,
                      wavelength_range_nm=(550, 560), size=SIZE, normalize="absolute")

angle_rad = np.radians(np.linspace(1e-5, 0.072, 800))
x = np.pi * diameter_mm * 1e6 * angle_rad / wavelength_nm
steps = (np.arange(400) + 0.5) * np.pi / 400
bessel_j1 = np.cos(steps - np.multiply.outer(x, np.sin(steps))).mean(axis=-1)
area_m2 = np.pi / 4 * (diameter_mm * 1e-3) ** 2
theory = area_m2 / (wavelength_nm * 1e-9) ** 2 * (2 * bessel_j1 / x) ** 2

figure, axes = plt.subplots(figsize=(6.2, 3.4), layout="constrained")
column, row = airy.center_px
along = airy.luminance[row, column:]
axes.semilogy(np.degrees(angle_rad), theory, color="0.2", label="Airy: $(2 J_1(x) / x)^2$")
axes.semilogy(np.arange(len(along)) * airy.pixel_pitch_deg, along, ".", ms=4, color="tab:orange",
              label="template, pixel means")
axes.set(xlim=(0, 0.072), ylim=(theory.max() * 1e-6, theory.max() * 2), xlabel="angle (degrees)",
         ylabel="PSF (1/sr)", title=f"A round pupil of {diameter_mm:g} mm at {wavelength_nm:g} nm")
axes.legend()
finished(figure, "airy")

# %% The eye: diffraction, with straylight, and the CIE's glare equation
eye = {"size": SIZE, "fov_deg": EYE_FOV_DEG, "lamp": "D65", "normalize": "absolute"}
bare, clear, whole = (glare.template(**eye, **more) for more in
                      ({}, {"clear_media": True}, {"scatter": "cie", "age": 35}))

figure, axes = plt.subplots(figsize=(6.2, 3.8), layout="constrained")
for template, label, style in ((clear, "pupil, lids and lashes alone", ":"),
                               (bare, "with particles and fibres of the media", "--"),
                               (whole, "with all straylight (scatter='cie')", "-")):
    profile = template.radial_profile()
    middle_deg = (profile.inner_deg + profile.outer_deg) / 2
    axes.loglog(middle_deg[1:], profile.mean_per_steradian[1:], style, label=label)
angles_deg = np.geomspace(0.1, 5, 100)
axes.loglog(angles_deg, glare.cie_glare(angles_deg, age=35), color="0.2", lw=3, alpha=0.35,
            label="CIE general glare equation, 35 years")
axes.set(xlabel="angle (degrees)", ylabel="veil (cd/m² per lux)",
         title="The built-in eye's veil, mean over rings")
axes.legend()
finished(figure, "eye_and_cie")

# %% Colour along the radius: longer waves go wider
small = glare.template(pupil=round_pupil(0.6), width_mm=2 / 0.6, lamp="D65", fov_deg=0.5, size=SIZE,
                       normalize="absolute")
edges_deg = np.arange(0.5, SIZE / 2) * small.pixel_pitch_deg
rgb = ring_means(small, small.rgb.astype(float), edges_deg)
xyz = rgb @ small.xyz_from_rgb.T
middle_deg = (edges_deg[1:] + edges_deg[:-1]) / 2

figure, (upper, lower) = plt.subplots(2, 1, figsize=(6.2, 4.2), sharex=True, layout="constrained",
                                      height_ratios=(3, 1))
for k, name in enumerate("xy"):
    upper.plot(middle_deg, xyz[:, k] / xyz.sum(axis=1), color=("tab:red", "tab:green")[k],
               label=f"${name}$")
    upper.axhline(small.lamp_xyz[k] / sum(small.lamp_xyz), color="0.5", lw=0.8, ls=":")
upper.set(ylabel="CIE 1931 chromaticity", title="Colour around daylight (D65) behind a 2 mm pupil")
upper.legend()
lower.imshow(displayed(rgb, rgb.max())[None], aspect="auto",
             extent=(edges_deg[0], edges_deg[-1], 0, 1))
lower.set(yticks=[], xlabel="angle (degrees)", ylabel="colour,\nlog scale")
finished(figure, "chromaticity")

# %% Encircled energy: small pupils spread, and lashes and media cost light
figure, axes = plt.subplots(figsize=(6.2, 3.4), layout="constrained")
radius_deg = np.geomspace(0.004, 0.24, 60)
for diameter_mm in (2, 4, 6):
    t = glare.template(pupil=round_pupil(0.6), width_mm=diameter_mm / 0.6, size=SIZE, fov_deg=0.5)
    axes.semilogx(radius_deg, t.encircled_energy(radius_deg),
                  label=f"round pupil, {diameter_mm} mm")
t = glare.template(size=SIZE, fov_deg=0.5)
axes.semilogx(radius_deg, t.encircled_energy(radius_deg), "--", color="0.2",
              label="the built-in eye, 6.5 mm")
axes.set(xlabel="radius (degrees)", ylabel="share of the light within", ylim=(0, 1.02),
         title="Encircled energy, daylight (D65)")
axes.legend()
finished(figure, "encircled_energy")

# %% Lamps: one far field, and each its own glare
lamps = {"A": "halogen (A)", "hid": "HID", "led": "white LED", "FL11": "fluorescent (FL11)"}
templates = glare.templates(list(lamps), size=SIZE // 2, fov_deg=3)

figure, grid = plt.subplots(2, len(lamps), figsize=(7.6, 3.5), layout="constrained",
                            height_ratios=(2.2, 1))
for (upper, lower), template, (name, label) in zip(grid.T, templates, lamps.items()):
    upper.imshow(displayed(template.rgb.astype(float), 3e-2, decades=5.5))
    upper.set(xticks=[], yticks=[], title=label)
    upper.grid(False)
    wavelength_nm, power = glare.spectrum(name)
    lower.fill_between(wavelength_nm, power / power[wavelength_nm > 380].max(), color="0.6", lw=0)
    lower.set(xlim=(380, 780), ylim=(0, 1.02), yticks=[], xticks=[400, 600], xlabel="nm")
grid[0, 0].set_ylabel("3 degrees")
grid[1, 0].set_ylabel("power")
finished(figure, "lamps")
