"""Types of the package glare. Lengths, angles and wavelengths carry their unit in their names."""

from collections.abc import Callable, Sequence
from os import PathLike
from typing import Any, Literal, NamedTuple, TypedDict, Unpack, overload

from numpy import bool_, float32, float64, floating
from numpy.typing import ArrayLike, NDArray

__all__ = ["Aperture", "Cancelled", "Error", "Filter", "GlareWarning", "InputError", "Lamp",
           "MemoryLimitError", "Observer", "OptionError", "OutputError", "RadialProfile",
           "Spectrum", "Template", "__version__", "aperture", "apply", "cie_glare", "lamps",
           "observer", "read_template", "spectrum", "template", "templates"]

__version__: str

_Path = str | PathLike[str]
_Progress = Callable[[float], bool | None] | None
_Picture = _Path | NDArray[floating[Any]] | NDArray[bool_] | None
_Lamp = _Path | tuple[ArrayLike, ArrayLike]
_Edge = Literal["black", "extend"]
_LampColor = Literal["divide", "keep"]

class Error(Exception): ...
class InputError(Error, ValueError): ...
class OptionError(Error, ValueError): ...
class OutputError(Error, OSError): ...
class MemoryLimitError(Error, MemoryError): ...
class Cancelled(Error): ...
class GlareWarning(UserWarning): ...

class Lamp(NamedTuple):
    name: str
    alias: str
    description: str

class Spectrum(NamedTuple):
    wavelength_nm: NDArray[float64]
    power: NDArray[float64]

class Observer(NamedTuple):
    wavelength_nm: NDArray[float64]
    x_bar: NDArray[float64]
    y_bar: NDArray[float64]
    z_bar: NDArray[float64]

class RadialProfile(NamedTuple):
    inner_deg: NDArray[float64]
    outer_deg: NDArray[float64]
    mean_per_steradian: NDArray[float64]

class Aperture(NamedTuple):
    transmittance: NDArray[float32]
    width_mm: float

class Template:
    @property
    def rgb(self) -> NDArray[float32]: ...
    @property
    def luminance(self) -> NDArray[float32]: ...
    @property
    def xyz_from_rgb(self) -> NDArray[float64]: ...
    @property
    def width(self) -> int: ...
    @property
    def height(self) -> int: ...
    @property
    def center_px(self) -> tuple[int, int]: ...
    @property
    def pixel_pitch_deg(self) -> float: ...
    @property
    def pixel_pitch_rad(self) -> float: ...
    @property
    def per_steradian(self) -> float: ...
    @property
    def captured_energy(self) -> float: ...
    @property
    def scattered_energy(self) -> float: ...
    @property
    def normalization(self) -> Literal["peak", "energy", "absolute"]: ...
    @property
    def colorspace(self) -> str: ...
    @property
    def lamp(self) -> str: ...
    @property
    def lamp_xyz(self) -> tuple[float, float, float]: ...
    @property
    def light_xyz(self) -> tuple[float, float, float]: ...
    @property
    def observer(self) -> str: ...
    @property
    def wavelength_range_nm(self) -> tuple[float, float]: ...
    @property
    def aberrations(self) -> str: ...
    @property
    def aperture_width_mm(self) -> float: ...
    @property
    def aperture_area_mm2(self) -> float: ...
    @property
    def recipe(self) -> str: ...
    @property
    def software(self) -> str: ...
    def radial_profile(self) -> RadialProfile: ...
    def cie_profile(self, age: float = 35.0, pigment: float = 0.5) -> NDArray[float64]: ...
    @overload
    def encircled_energy(self, radius_deg: float) -> float: ...
    @overload
    def encircled_energy(self, radius_deg: ArrayLike) -> NDArray[float64]: ...
    def peak(self) -> tuple[int, int, float]: ...
    def chromaticity(self) -> tuple[float, float]: ...
    def save(self, path: _Path, *, half: bool = False, threads: int = 0,
             progress: _Progress = None) -> None: ...

class _EyeOptions(TypedDict, total=False):
    age: float
    threads: int
    pupil_mm: float
    pupil_axis_ratio: float
    pupil_longer_axis_deg: float
    pupil_right_mm: float
    pupil_down_mm: float
    pupil_crypts_mm: float
    pupil_ruff_mm: float
    adapting_luminance_cd_m2: float
    field_area_deg2: float
    adapting_eyes: int
    seed: int
    lid_opening_mm: float
    lid_share_above: float
    upper_lashes: int
    upper_lash_length_mm: float
    upper_lash_root_width_mm: float
    upper_lash_tip_share: float
    upper_lash_droop_deg: float
    upper_lash_curl_deg: float
    upper_lash_fan_deg: float
    upper_lash_scatter_deg: float
    upper_lash_clumping: float
    lower_lashes: int
    lower_lash_length_mm: float
    lower_lash_root_width_mm: float
    lower_lash_tip_share: float
    lower_lash_droop_deg: float
    lower_lash_curl_deg: float
    lower_lash_fan_deg: float
    lower_lash_scatter_deg: float
    lower_lash_clumping: float
    cornea_particles_per_mm2: float
    cornea_particle_um: float
    cornea_particle_spread: float
    cornea_particle_drift_mm_per_s: float
    lens_particles_per_mm2: float
    lens_particle_um: float
    lens_particle_spread: float
    lens_particle_drift_mm_per_s: float
    vitreous_particles_per_mm2: float
    vitreous_particle_um: float
    vitreous_particle_spread: float
    vitreous_particle_drift_mm_per_s: float
    fibre_pitch_um: float
    fibre_pitch_variation: float
    fibre_zone_inner_mm: float
    fibre_zone_outer_mm: float
    fibre_modulation: float
    suture_branches: int
    suture_length_mm: float
    suture_width_um: float
    suture_contrast: float
    clear_media: bool
    hippus_mm: float
    blinks_per_minute: float
    time_s: float

class _EyePictureOptions(_EyeOptions, total=False):
    size: int
    pixel_um: float

class _TemplateOptions(_EyeOptions, total=False):
    width_mm: float
    size: int | tuple[int, int] | str
    fov_deg: float
    observer: str
    wavelength_range_nm: tuple[float, float]
    colorspace: str
    ocio: _Path
    white: Literal["none", "lamp"]
    normalize: Literal["peak", "energy", "absolute"]
    gamut: Literal["keep", "desaturate"]
    scatter: Literal["none", "cie"]
    pigment: float
    defocus_d: float
    zernike: _Path
    chromatic_aberration: bool
    focused_nm: float
    stiles_crawford: bool
    stiles_crawford_rho_per_mm2: float
    stiles_crawford_peak_mm: tuple[float, float]
    memory_limit: int | str

def template(*, lamp: _Lamp = "D65", pupil: _Picture = None, eyelashes: _Picture = None,
             progress: _Progress = None, **options: Unpack[_TemplateOptions]) -> Template: ...
def templates(lamps: Sequence[_Lamp], *, pupil: _Picture = None, eyelashes: _Picture = None,
              progress: _Progress = None,
              **options: Unpack[_TemplateOptions]) -> list[Template]: ...
def read_template(path: _Path, *, memory_limit: int | str = 0) -> Template: ...
def aperture(*, view: Literal["whole", "pupil", "eyelashes"] = "whole",
             progress: _Progress = None, **options: Unpack[_EyePictureOptions]) -> Aperture: ...
def lamps() -> list[Lamp]: ...
def spectrum(name: _Path) -> Spectrum: ...
def observer(name: str = "cie1931-2deg") -> Observer: ...
@overload
def cie_glare(angle_deg: float, age: float = 35.0, pigment: float = 0.5) -> float: ...
@overload
def cie_glare(angle_deg: ArrayLike, age: float = 35.0,
              pigment: float = 0.5) -> NDArray[float64]: ...

class Filter:
    def __init__(self, template: Template, width: int, height: int, *,
                 fov_deg: float | None = None, pixel_deg: float | None = None,
                 perspective: bool = False, pixel_aspect: float = 1.0, edge: _Edge = "black",
                 lamp_color: _LampColor = "divide", colorspace: str = "lin_rec709",
                 ocio: _Path | None = None, grey: bool = False, threads: int = 0,
                 memory_limit: int | str = 0) -> None: ...
    @property
    def width(self) -> int: ...
    @property
    def height(self) -> int: ...
    @property
    def kept(self) -> NDArray[float64]: ...
    def apply(self, image: NDArray[floating[Any]], *, exposure: float = 0.0,
              threshold: float = 0.0, knee: float = 0.5, strength: float = 1.0,
              only_glare: bool = False, threads: int = 0, progress: _Progress = None,
              out: NDArray[floating[Any]] | None = None) -> NDArray[float32]: ...

def apply(image: NDArray[floating[Any]], template: Template, *, fov_deg: float | None = None,
          pixel_deg: float | None = None, perspective: bool = False, pixel_aspect: float = 1.0,
          edge: _Edge = "black", threshold: float = 0.0, knee: float = 0.5,
          strength: float = 1.0, exposure: float = 0.0, only_glare: bool = False,
          lamp_color: _LampColor = "divide", colorspace: str = "lin_rec709",
          ocio: _Path | None = None, sources: ArrayLike | Literal["auto"] | None = None,
          new_sources: bool = False,
          threads: int = 0, memory_limit: int | str = 0, progress: _Progress = None,
          out: NDArray[floating[Any]] | None = None) -> NDArray[float32]: ...
