// The loops over spectra of `PlaneTransform`, compiled as those of light_loops.h. Internal.
#pragma once

#include <complex>
#include <cstddef>

namespace glare {

/// A block of eight signals' spectra, [frequency][signal], each of two real columns a + i b, and
/// the columns' own, [group][column][frequency in the group]; `spectra` points at the first of the
/// sixteen columns in group 0, and groups lie `group_stride` values apart. `length` is even.

/// The columns' spectra (times 2) at frequencies 0 to length / 2, and something at those that fill
/// the last group.
void take_columns_apart(const std::complex<float>* block, std::size_t length,
                        std::size_t group_stride, std::complex<float>* spectra);

/// The opposite, but for the factor.
void put_columns_together(const std::complex<float>* spectra, std::size_t group_stride,
                          std::size_t length, std::complex<float>* block);

/// values[i] *= factors[i]; `count` is a multiple of 8, all is aligned to 64 bytes.
void multiply(std::complex<float>* values, const std::complex<float>* factors, std::size_t count);

}  // namespace glare
