#include "glare/diffraction/fourier_transform.h"

#include <fftw3.h>

#include <cassert>
#include <cstdint>
#include <cstdlib>
#include <mutex>
#include <new>

#include "glare/base/aligned_buffer.h"
#include "glare/diffraction/transform_plans.h"

namespace glare {

namespace {

fftwf_complex* fftw_pointer(std::span<std::complex<float>> values) {
  assert(reinterpret_cast<std::uintptr_t>(values.data()) % FourierTransform::kAlignment == 0);
  return reinterpret_cast<fftwf_complex*>(values.data());  // FFTW's manual: the layouts agree.
}

/// FFTW's planner, and what it knows, may be used by one thread at a time only.
std::mutex& planner_mutex() {
  static std::mutex mutex;
  return mutex;
}

/// FFTW takes what it has learnt by timing for a plan by estimate too.
fftwf_plan planned(FourierTransform::Kind kind, int length, unsigned effort) {
  const auto count = static_cast<std::size_t>(length);
  AlignedBuffer<std::complex<float>> input(count), output(count);
  fftwf_complex* const in = fftw_pointer(input.values());
  fftwf_complex* const out = fftw_pointer(output.values());
  const unsigned flags = effort | FFTW_DESTROY_INPUT;
  const fftwf_plan plan =
      kind == FourierTransform::Kind::real_to_complex
          ? fftwf_plan_dft_r2c_1d(length, reinterpret_cast<float*>(in), out, flags)
          : fftwf_plan_dft_1d(length, in, out, FFTW_FORWARD, flags);
  if (!plan) throw std::bad_alloc();
  return plan;
}

}  // namespace

struct FourierTransform::Plan {
  fftwf_plan plan = nullptr;
};

FourierTransform::FourierTransform(Kind kind, int length) : plan_(std::make_unique<Plan>()) {
  const std::scoped_lock lock(planner_mutex());
  plan_->plan = planned(kind, length, FFTW_ESTIMATE);
}

FourierTransform::~FourierTransform() {
  const std::scoped_lock lock(planner_mutex());
  fftwf_destroy_plan(plan_->plan);
}

void FourierTransform::execute(AlignedBuffer<float>& input,
                               AlignedBuffer<std::complex<float>>& output) const {
  fftwf_execute_dft_r2c(plan_->plan, input.values().data(), fftw_pointer(output.values()));
}

void FourierTransform::execute(std::span<std::complex<float>> input,
                               std::span<std::complex<float>> output) const {
  fftwf_execute_dft(plan_->plan, fftw_pointer(input), fftw_pointer(output));
}

int fast_transform_length(int minimum) {
  for (int length = minimum + minimum % 2;; length += 2) {
    int rest = length;
    for (const int factor : {2, 3, 5, 7})
      while (rest % factor == 0) rest /= factor;
    if (rest == 1) return length;
  }
}

void measure_transforms(std::span<const int> lengths) {
  for (const int length : lengths) {
    const std::scoped_lock lock(planner_mutex());  // Others may plan between two lengths.
    fftwf_destroy_plan(planned(FourierTransform::Kind::complex_to_complex, length, FFTW_MEASURE));
  }
}

std::string transform_plans_text() {
  const std::scoped_lock lock(planner_mutex());
  const std::unique_ptr<char, decltype(&std::free)> text(fftwf_export_wisdom_to_string(),
                                                         &std::free);
  if (!text) throw std::bad_alloc();
  return text.get();
}

bool adopt_transform_plans(const std::string& text) {
  const std::scoped_lock lock(planner_mutex());
  return fftwf_import_wisdom_from_string(text.c_str()) != 0;
}

void forget_transform_plans() {
  const std::scoped_lock lock(planner_mutex());
  fftwf_forget_wisdom();
}

std::string transform_library() { return fftwf_version; }

}  // namespace glare
