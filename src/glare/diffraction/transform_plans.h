// How the Fourier transforms are planned: by estimate, or faster, by timing.
#pragma once

#include <span>
#include <string>

namespace glare {

/// By default transforms are planned by estimate: at once, and so that every bit of a result
/// depends on the machine alone. A long-lived program can have those of the given lengths (see
/// `far_field_transform_lengths`) planned by timing several ways, some 0.05 to 1 s each; every
/// later transform of such a length in this process is then planned so. Results agree with the
/// estimated ones, and with those of another timing, within float rounding only. A length that has
/// been measured takes no time again. May be called in any thread at any time; lengths below 1 are
/// misuse.
void measure_transforms(std::span<const int> lengths);

/// The plans of this process as text, for `adopt_transform_plans` in a later process. The format is
/// FFTW's own.
std::string transform_plans_text();

/// Adds plans, as if measured here. False, and nothing is changed, where they are of another
/// version of the transforms' library or another kind of processor. The text must be one that
/// `transform_plans_text` gave: a damaged one may end the process. `load_transform_plans` checks
/// it.
bool adopt_transform_plans(const std::string& text);

/// Forgets all plans: transforms are planned by estimate again.
void forget_transform_plans();

/// Name and version of the transforms' library.
std::string transform_library();

}  // namespace glare
