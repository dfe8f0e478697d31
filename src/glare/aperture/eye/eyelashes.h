// The eyelashes, as seen from the lamp. Internal.
#pragma once

#include <vector>

#include "glare/aperture/coverage.h"
#include "glare/aperture/eye/eyelids.h"

namespace glare {

enum class Lid { upper, lower };

/// The outlines of one lid's lashes, in front of the plane of the pupil; a lash that turns back has
/// two, one behind the other. The same for the same parameters on every machine.
std::vector<Outline> eyelashes(const EyelashParameters& parameters, Lid lid, const Eyelids& lids,
                               std::uint64_t seed);

}  // namespace glare
