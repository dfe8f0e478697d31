// The integral's inner loops, compiled for several instruction sets, of which the best that the
// machine has is taken when the program runs. Internal.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "glare/integration/interpolation_table.h"

namespace glare {

/// Rays that are convolved side by side: a row of theirs is one cache line.
inline constexpr int kRaysPerBlock = 16;

/// Places in a row of samples: `first`, `first + step`, ... , as many as asked for.
struct EvenPlaces {
  double first;
  double step;
  int count;
};

/// result[i] = the row's value at place i, by the table's kernel. `row` points at sample 0; samples
/// from floor(place) - 3 to floor(place) + 4 are read.
void interpolate(const float* row, const EvenPlaces& places, const InterpolationTable<8>& table,
                 float* result);

/// The same with twelve taps: from floor(place) - 5 to floor(place) + 6.
void interpolate(const float* row, const EvenPlaces& places, const InterpolationTable<12>& table,
                 float* result);

/// The same in three rows at once.
void interpolate(const std::array<const float*, 3>& rows, const EvenPlaces& places,
                 const InterpolationTable<12>& table, const std::array<float*, 3>& results);

/// result[i] = sum over t of weights[t] * rows[t * stride + i] for i < count.
void sum_weighted_rows(std::span<const float> weights, const float* rows, std::size_t stride,
                       int count, float* result);

/// The same for each of `blocks` blocks of kRaysPerBlock columns, whose rows follow one another:
/// result[b * kRaysPerBlock + i] = sum over t of weights[t] * rows[b * block_stride + t *
/// kRaysPerBlock + i].
void sum_weighted_block_rows(std::span<const float> weights, const float* rows,
                             std::size_t block_stride, int blocks, float* result);

/// result[i] = sum over t of weights[t] * line[i * step + t] for i < count.
void sum_weighted_neighbours(std::span<const float> weights, const float* line, int step, int count,
                             float* result);

/// target[i] += weight * line[i] for i < count.
void add_weighted(float weight, const float* line, int count, float* target);

/// target[c * target_stride + r] = source[r * row_stride + c * step] for r < rows, c < columns;
/// `step` is 1 or -1.
void transpose(const float* source, std::ptrdiff_t row_stride, int step, int rows, int columns,
               float* target, std::size_t target_stride);

/// The instruction set in use, such as "AVX2".
const char* vector_target_name();

}  // namespace glare
