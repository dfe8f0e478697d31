// The inner loops of transforms of rays side by side: compiled as those of vector_loops.h.
// Internal.
#pragma once

#include <complex>
#include <cstddef>
#include <span>

#include "glare/integration/vector_loops.h"

namespace glare {

/// Multiplies row r of kRaysPerBlock / 2 complex values by factors[r].
void multiply_rows(std::span<const std::complex<float>> factors, const std::complex<float>* rows,
                   std::complex<float>* result);

/// One pass of a transform of length radix * runs * groups: `BlockTransform`.
struct TransformPass {
  int radix;   ///< 2, 3, 4 or 5.
  int runs;    ///< Inputs of one butterfly are runs * groups rows apart.
  int groups;  ///< The product of the radices of the passes before.
  bool backward;
  const std::complex<float>* turns;  ///< radix - 1 for each run.
};

/// Row r of the input begins at `input + r * stride`, of the output at
/// `output + r * kRaysPerBlock / 2`.
void transform_pass(const TransformPass& pass, const std::complex<float>* input, std::size_t stride,
                    std::complex<float>* output);

}  // namespace glare
