// Lamps and observers for comparisons with the exact reference.
#pragma once

#include "glare/spectrum/observer.h"
#include "glare/spectrum/spectrum.h"
#include "support/exact_template.h"

namespace glare::test {

/// Sampled at 1 nm, 380 to 780 nm, with lines 1.2 to 8 nm wide (full width at half maximum):
/// harder than any CIE table.
Spectrum lamp_with_narrow_lines();

/// The same function of wavelength with a sample every `step_nm`.
Spectrum resampled(const Spectrum& spectrum, double step_nm);

/// A spectrum and an observer as the exact reference takes them.
exact::SpectralTable table_of(const Spectrum& spectrum);
exact::Observer tables_of(const ColorMatchingFunctions& observer);

}  // namespace glare::test
