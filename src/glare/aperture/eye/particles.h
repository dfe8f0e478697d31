// Small particles in the eye's media, in front of the pupil's plane: the light they diffract is the
// ciliary corona.
#pragma once

namespace glare {

/// The particles of one medium, projected along the axis onto the pupil's plane: opaque discs at
/// random places. An opaque disc diffracts the light that falls on it (Babinet), as a transparent
/// particle larger than the wavelength does to within a factor of about 2; it also takes away as
/// much, which a transparent one doesn't.
struct MediumParticles {
  /// Particles per square millimetre of the pupil's plane, 0 to 20000; 0 is none.
  double number_per_mm2 = 0;

  /// Median diameter, 0.2 to 200 um. Particles of diameter d diffract into a disc of radius
  /// asin(1.22 wavelength / d).
  double diameter_um = 1;

  /// Spread of the diameters: the standard deviation of their natural logarithm, 0 to 0.6. The
  /// logarithm is the sum of 12 uniform deviates: normal, but within 6 standard deviations.
  double diameter_spread = 0;

  /// Root-mean-square speed at which each particle drifts, 0 to 1 mm/s; 0 stays where it is.
  double drift_mm_per_s = 0;
};

/// The eye's particles. The defaults are a young, healthy eye's: together they diffract about 4 %
/// of the light; their luminance is 0.4 to 0.5 of the straylight of CIE 146:2002 (age 24) between 1
/// and 5 degrees, the rest of which is of the iris, the sclera and the retina.
struct ParticleParameters {
  /// About 30 % of the straylight is the cornea's (Vos and Boogaard 1963, J. Opt. Soc. Am. 53, 869,
  /// at 30 to 70 degrees). The size is a choice, about that of a keratocyte's nucleus, and the
  /// number is chosen to give that share at 1 to 5 degrees.
  MediumParticles cornea = {200, 10, 0.3, 0};

  /// Lens: multilamellar bodies have diameters of 1 to 4 um (Gilliland and others 2008, Mol. Vis.
  /// 14, 572), and particles in 6e-6 of the lens's volume explain its straylight (van den Berg,
  /// Hagenouw and Coppens 2005, IOVS 46, 2627). 7500/mm2 of median 1.6 um are that share of a lens
  /// 4 mm thick; their light reaches tens of degrees, as there.
  MediumParticles lens = {7500, 1.6, 0.3, 0};

  /// Vitreous: floating collagen clumps and cells. Number, size and speed are choices: they make
  /// the innermost 2 degrees move, as Ritschel and others (2009, Temporal Glare, Computer Graphics
  /// Forum 28) have it.
  MediumParticles vitreous = {10, 20, 0.4, 0.2};
};

/// Particles per square millimetre of the pupil's plane, of a medium in which particles of this
/// median diameter and spread fill `volume_fraction` over `thickness_mm` along the axis.
double particles_per_mm2(double volume_fraction, double thickness_mm, double diameter_um,
                         double diameter_spread);

/// Share of the pupil's plane that the medium's particles cover on average, overlaps counted twice:
/// also the share of the light that they diffract.
double area_share(const MediumParticles& particles);

/// Throws `OptionError` for a parameter outside its range, or particles that cover more than 30 %
/// of the plane together.
void require_valid(const ParticleParameters& parameters);

}  // namespace glare
