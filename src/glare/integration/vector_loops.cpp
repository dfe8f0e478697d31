#include "glare/integration/vector_loops.h"

#include <algorithm>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "glare/integration/vector_loops.cpp"
#include <hwy/foreach_target.h>  // Compiles this file again for each instruction set.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace glare {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

template <int kTaps>
using Entry = typename InterpolationTable<kTaps>::Entry;

/// Vectors of eight floats, or of four where there are none of eight. The taps of a place lie in
/// one to three of them.
using Taps = hn::CappedTag<float, 8>;
using TapVector = hn::Vec<Taps>;
using Lanes = hn::ScalableTag<float>;

/// Where the taps of a few places are and what they weigh.
template <int kTaps>
struct TapPlaces {
  static constexpr int kCount = static_cast<int>(hn::MaxLanes(Taps()));
  HWY_ALIGN std::array<int, kCount> sample;  ///< First sample, counted from the row's.
  HWY_ALIGN std::array<int, kCount> entry;
  HWY_ALIGN std::array<float, kCount> rest;

  HWY_INLINE TapPlaces(float first, float step) {
    using Table = InterpolationTable<kTaps>;
    const Taps d;
    const hn::RebindToSigned<Taps> whole_numbers;
    constexpr float kSteps = Table::kSteps;
    const auto steps =
        hn::MulAdd(hn::Iota(d, 0), hn::Set(d, step * kSteps), hn::Set(d, first * kSteps));
    const auto whole = hn::ConvertTo(whole_numbers, steps);
    hn::Store(hn::ShiftRight<Table::kLogSteps>(whole), whole_numbers, sample.data());
    hn::Store(hn::And(whole, hn::Set(whole_numbers, Table::kSteps - 1)), whole_numbers,
              entry.data());
    hn::Store(hn::Sub(steps, hn::ConvertTo(d, whole)), d, rest.data());
  }
};

#if HWY_TARGET == HWY_SCALAR

HWY_INLINE TapVector lane_sums(const TapVector* v) { return v[0]; }

#else

/// [a0 + a1, a2 + a3, ..., b0 + b1, ...]
HWY_INLINE TapVector pairwise_sum(TapVector a, TapVector b) {
  const Taps d;
  return hn::Add(hn::ConcatEven(d, b, a), hn::ConcatOdd(d, b, a));
}

/// The sums of the lanes of as many vectors as a vector has lanes.
HWY_INLINE TapVector lane_sums(const TapVector* v) {
  const TapVector a = pairwise_sum(v[0], v[1]), b = pairwise_sum(v[2], v[3]);
  if constexpr (hn::MaxLanes(Taps()) == 4) {
    return pairwise_sum(a, b);
  } else {
    const TapVector c = pairwise_sum(v[4], v[5]), d = pairwise_sum(v[6], v[7]);
    return pairwise_sum(pairwise_sum(a, b), pairwise_sum(c, d));
  }
}

#endif

/// The weighted samples of one place, in as many lanes as a vector has.
template <int kTaps>
HWY_INLINE TapVector weighted_taps(const float* samples, const Entry<kTaps>& entry, float rest) {
  const Taps d;
  const auto share = hn::Set(d, rest);
  TapVector sum = hn::Zero(d);
  std::size_t t = 0;
  for (; t + hn::MaxLanes(d) <= kTaps; t += hn::MaxLanes(d)) {
    const auto weights = hn::MulAdd(share, hn::Load(d, entry.change.data() + t),
                                    hn::Load(d, entry.weights.data() + t));
    sum = hn::MulAdd(weights, hn::LoadU(d, samples + t), sum);
  }
#if HWY_TARGET != HWY_SCALAR
  if constexpr (kTaps % hn::MaxLanes(Taps()) != 0) {
    const hn::Half<Taps> half;
    const auto weights = hn::MulAdd(hn::Set(half, rest), hn::Load(half, entry.change.data() + t),
                                    hn::Load(half, entry.weights.data() + t));
    sum = hn::Add(sum, hn::ZeroExtendVector(d, hn::Mul(weights, hn::LoadU(half, samples + t))));
  }
#endif
  return sum;
}

/// As many places from `first` on as a vector has lanes.
template <int kTaps, std::size_t kRows>
HWY_INLINE std::array<TapVector, kRows> interpolated(const std::array<const float*, kRows>& rows,
                                                     double first, double step,
                                                     const Entry<kTaps>* entries) {
  constexpr int kCount = TapPlaces<kTaps>::kCount;
  const double whole = std::floor(first);
  const TapPlaces<kTaps> at(static_cast<float>(first - whole), static_cast<float>(step));
  const auto base = static_cast<std::ptrdiff_t>(whole) - (kTaps / 2 - 1);
  std::array<TapVector, kRows> result;
  for (std::size_t r = 0; r < kRows; ++r) {
    TapVector taps[kCount];
    for (int i = 0; i < kCount; ++i)
      taps[i] =
          weighted_taps<kTaps>(rows[r] + base + at.sample[i], entries[at.entry[i]], at.rest[i]);
    result[r] = lane_sums(taps);
  }
  return result;
}

template <int kTaps, std::size_t kRows>
HWY_INLINE void interpolate_rows(const std::array<const float*, kRows>& rows,
                                 const EvenPlaces& places, const Entry<kTaps>* entries,
                                 const std::array<float*, kRows>& results) {
  const Taps d;
  constexpr int kCount = TapPlaces<kTaps>::kCount;
  if (places.count < kCount) {
    for (int i = 0; i < places.count; ++i) {
      const auto values =
          interpolated<kTaps, kRows>(rows, places.first + i * places.step, 0, entries);
      for (std::size_t r = 0; r < kRows; ++r) results[r][i] = hn::GetLane(values[r]);
    }
    return;
  }
  for (int i = 0; i < places.count; i += kCount) {
    const int begin = std::min(i, places.count - kCount);  // The last group may overlap.
    const auto values =
        interpolated<kTaps, kRows>(rows, places.first + begin * places.step, places.step, entries);
    for (std::size_t r = 0; r < kRows; ++r) hn::StoreU(values[r], d, results[r] + begin);
  }
}

void InterpolateEight(const float* row, const EvenPlaces& places, const Entry<8>* entries,
                      float* result) {
  interpolate_rows<8, 1>({row}, places, entries, {result});
}

void InterpolateTwelve(const float* row, const EvenPlaces& places, const Entry<12>* entries,
                       float* result) {
  interpolate_rows<12, 1>({row}, places, entries, {result});
}

void InterpolateThree(const std::array<const float*, 3>& rows, const EvenPlaces& places,
                      const Entry<12>* entries, const std::array<float*, 3>& results) {
  interpolate_rows<12, 3>(rows, places, entries, results);
}

void SumWeightedRows(std::span<const float> weights, const float* rows, std::size_t stride,
                     int count, float* result) {
  const Lanes d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  int i = 0;
  for (; i + 2 * lanes <= count; i += 2 * lanes) {
    auto a = hn::Zero(d), b = hn::Zero(d);
    const float* row = rows + i;
    for (const float weight : weights) {
      const auto w = hn::Set(d, weight);
      a = hn::MulAdd(w, hn::LoadU(d, row), a);
      b = hn::MulAdd(w, hn::LoadU(d, row + lanes), b);
      row += stride;
    }
    hn::StoreU(a, d, result + i);
    hn::StoreU(b, d, result + i + lanes);
  }
  const hn::CappedTag<float, 4> few;
  const int few_lanes = static_cast<int>(hn::Lanes(few));
  for (; i + few_lanes <= count; i += few_lanes) {
    auto a = hn::Zero(few);
    const float* row = rows + i;
    for (const float weight : weights) {
      a = hn::MulAdd(hn::Set(few, weight), hn::LoadU(few, row), a);
      row += stride;
    }
    hn::StoreU(a, few, result + i);
  }
  for (; i < count; ++i) {
    float a = 0;
    for (std::size_t t = 0; t < weights.size(); ++t) a += weights[t] * rows[t * stride + i];
    result[i] = a;
  }
}

void SumWeightedBlockRows(std::span<const float> weights, const float* rows,
                          std::size_t block_stride, int blocks, float* result) {
  const hn::CappedTag<float, kRaysPerBlock> d;
  const std::size_t lanes = hn::Lanes(d);
  for (int block = 0; block < blocks; ++block) {
    for (std::size_t i = 0; i < kRaysPerBlock; i += lanes) {
      const float* row = rows + i;
      auto even = hn::Zero(d), odd = hn::Zero(d);
      std::size_t t = 0;
      for (; t + 2 <= weights.size(); t += 2, row += 2 * kRaysPerBlock) {
        even = hn::MulAdd(hn::Set(d, weights[t]), hn::LoadU(d, row), even);
        odd = hn::MulAdd(hn::Set(d, weights[t + 1]), hn::LoadU(d, row + kRaysPerBlock), odd);
      }
      if (t < weights.size()) even = hn::MulAdd(hn::Set(d, weights[t]), hn::LoadU(d, row), even);
      hn::StoreU(hn::Add(even, odd), d, result + i);
    }
    rows += block_stride;
    result += kRaysPerBlock;
  }
}

void SumWeightedNeighbours(std::span<const float> weights, const float* line, int step, int count,
                           float* result) {
  if (step == 1) {
    SumWeightedRows(weights, line, 1, count, result);
    return;
  }
  const Lanes d;
  const std::size_t lanes = hn::Lanes(d);
  for (int i = 0; i < count; ++i) {
    const float* const samples = line + static_cast<std::ptrdiff_t>(i) * step;
    auto sums = hn::Zero(d);
    std::size_t t = 0;
    for (; t + lanes <= weights.size(); t += lanes)
      sums = hn::MulAdd(hn::LoadU(d, weights.data() + t), hn::LoadU(d, samples + t), sums);
    float sum = hn::GetLane(hn::SumOfLanes(d, sums));
    for (; t < weights.size(); ++t) sum += weights[t] * samples[t];
    result[i] = sum;
  }
}

void AddWeighted(float weight, const float* line, int count, float* target) {
  const Lanes d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const auto w = hn::Set(d, weight);
  int i = 0;
  for (; i + lanes <= count; i += lanes)
    hn::StoreU(hn::MulAdd(w, hn::LoadU(d, line + i), hn::LoadU(d, target + i)), d, target + i);
  for (; i < count; ++i) target[i] += weight * line[i];
}

void TransposePlainly(const float* source, std::ptrdiff_t row_stride, int step, int rows,
                      int columns, float* target, std::size_t target_stride) {
  for (int c = 0; c < columns; ++c)
    for (int r = 0; r < rows; ++r)
      target[static_cast<std::size_t>(c) * target_stride + static_cast<std::size_t>(r)] =
          source[r * row_stride + c * step];
}

/// Four rows and columns at a time, and the rest plainly.
void Transpose(const float* source, std::ptrdiff_t row_stride, int step, int rows, int columns,
               float* target, std::size_t target_stride) {
  int r = 0;
#if HWY_TARGET != HWY_SCALAR
  const hn::FixedTag<float, 4> d;
  const hn::Repartition<double, decltype(d)> pairs;
  const int whole_columns = columns / 4 * 4;
  for (; r + 4 <= rows; r += 4) {
    const float* const from = source + r * row_stride;
    const auto row = [&](int i, int c) {
      const float* const p = from + i * row_stride + c * step;
      return step > 0 ? hn::LoadU(d, p) : hn::Reverse(d, hn::LoadU(d, p - 3));
    };
    float* to = target + r;
    for (int c = 0; c < whole_columns; c += 4, to += 4 * target_stride) {
      const auto v0 = row(0, c), v1 = row(1, c), v2 = row(2, c), v3 = row(3, c);
      const auto a = hn::BitCast(pairs, hn::InterleaveLower(d, v0, v1));
      const auto b = hn::BitCast(pairs, hn::InterleaveLower(d, v2, v3));
      const auto e = hn::BitCast(pairs, hn::InterleaveUpper(d, v0, v1));
      const auto f = hn::BitCast(pairs, hn::InterleaveUpper(d, v2, v3));
      hn::StoreU(hn::BitCast(d, hn::InterleaveLower(pairs, a, b)), d, to);
      hn::StoreU(hn::BitCast(d, hn::InterleaveUpper(pairs, a, b)), d, to + target_stride);
      hn::StoreU(hn::BitCast(d, hn::InterleaveLower(pairs, e, f)), d, to + 2 * target_stride);
      hn::StoreU(hn::BitCast(d, hn::InterleaveUpper(pairs, e, f)), d, to + 3 * target_stride);
    }
    TransposePlainly(from + whole_columns * step, row_stride, step, 4, columns - whole_columns, to,
                     target_stride);
  }
#endif
  TransposePlainly(source + r * row_stride, row_stride, step, rows - r, columns, target + r,
                   target_stride);
}

const char* TargetName() { return hwy::TargetName(HWY_TARGET); }

}  // namespace HWY_NAMESPACE
}  // namespace glare
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace glare {

HWY_EXPORT(InterpolateEight);
HWY_EXPORT(InterpolateTwelve);
HWY_EXPORT(InterpolateThree);
HWY_EXPORT(SumWeightedRows);
HWY_EXPORT(SumWeightedBlockRows);
HWY_EXPORT(SumWeightedNeighbours);
HWY_EXPORT(AddWeighted);
HWY_EXPORT(Transpose);
HWY_EXPORT(TargetName);

void interpolate(const float* row, const EvenPlaces& places, const InterpolationTable<8>& table,
                 float* result) {
  HWY_DYNAMIC_DISPATCH(InterpolateEight)(row, places, table.entries(), result);
}

void interpolate(const float* row, const EvenPlaces& places, const InterpolationTable<12>& table,
                 float* result) {
  HWY_DYNAMIC_DISPATCH(InterpolateTwelve)(row, places, table.entries(), result);
}

void interpolate(const std::array<const float*, 3>& rows, const EvenPlaces& places,
                 const InterpolationTable<12>& table, const std::array<float*, 3>& results) {
  HWY_DYNAMIC_DISPATCH(InterpolateThree)(rows, places, table.entries(), results);
}

void sum_weighted_rows(std::span<const float> weights, const float* rows, std::size_t stride,
                       int count, float* result) {
  HWY_DYNAMIC_DISPATCH(SumWeightedRows)(weights, rows, stride, count, result);
}

void sum_weighted_block_rows(std::span<const float> weights, const float* rows,
                             std::size_t block_stride, int blocks, float* result) {
  HWY_DYNAMIC_DISPATCH(SumWeightedBlockRows)(weights, rows, block_stride, blocks, result);
}

void sum_weighted_neighbours(std::span<const float> weights, const float* line, int step, int count,
                             float* result) {
  HWY_DYNAMIC_DISPATCH(SumWeightedNeighbours)(weights, line, step, count, result);
}

void add_weighted(float weight, const float* line, int count, float* target) {
  HWY_DYNAMIC_DISPATCH(AddWeighted)(weight, line, count, target);
}

void transpose(const float* source, std::ptrdiff_t row_stride, int step, int rows, int columns,
               float* target, std::size_t target_stride) {
  HWY_DYNAMIC_DISPATCH(Transpose)(source, row_stride, step, rows, columns, target, target_stride);
}

const char* vector_target_name() { return HWY_DYNAMIC_DISPATCH(TargetName)(); }

}  // namespace glare

#endif  // HWY_ONCE
