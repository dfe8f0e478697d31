#include "glare/diffraction/fourier_transform.h"

#include <fftw3.h>

#include <mutex>
#include <new>

namespace glare {

namespace {

fftwf_complex* fftw_pointer(std::complex<float>* values) {
  return reinterpret_cast<fftwf_complex*>(values);  // The layouts agree, as FFTW's manual says.
}

/// FFTW's planner may run in one thread at a time only.
std::mutex& planner_mutex() {
  static std::mutex mutex;
  return mutex;
}

}  // namespace

template <typename T>
TransformBuffer<T>::TransformBuffer(std::size_t count)
    : data_(static_cast<T*>(fftwf_malloc(count * sizeof(T)))), count_(count) {
  if (!data_) throw std::bad_alloc();
}

template <typename T>
void TransformBuffer<T>::Release::operator()(T* data) const {
  fftwf_free(data);
}

template class TransformBuffer<float>;
template class TransformBuffer<std::complex<float>>;

struct FourierTransform::Plan {
  fftwf_plan plan = nullptr;
};

FourierTransform::FourierTransform(Kind kind, int length) : plan_(std::make_unique<Plan>()) {
  const auto count = static_cast<std::size_t>(length);
  TransformBuffer<std::complex<float>> complex_values(count);
  TransformBuffer<float> real_values(count);
  fftwf_complex* const values = fftw_pointer(complex_values.values().data());
  const std::scoped_lock lock(planner_mutex());
  plan_->plan = kind == Kind::real_to_complex
                    ? fftwf_plan_dft_r2c_1d(length, real_values.values().data(), values,
                                            FFTW_ESTIMATE | FFTW_DESTROY_INPUT)
                    : fftwf_plan_dft_1d(length, values, values, FFTW_FORWARD, FFTW_ESTIMATE);
  if (!plan_->plan) throw std::bad_alloc();
}

FourierTransform::~FourierTransform() {
  const std::scoped_lock lock(planner_mutex());
  fftwf_destroy_plan(plan_->plan);
}

void FourierTransform::execute(TransformBuffer<float>& input,
                               TransformBuffer<std::complex<float>>& output) const {
  fftwf_execute_dft_r2c(plan_->plan, input.values().data(), fftw_pointer(output.values().data()));
}

void FourierTransform::execute(TransformBuffer<std::complex<float>>& values) const {
  fftwf_complex* const in_place = fftw_pointer(values.values().data());
  fftwf_execute_dft(plan_->plan, in_place, in_place);
}

int fast_transform_length(int minimum) {
  for (int length = minimum + minimum % 2;; length += 2) {
    int rest = length;
    for (const int factor : {2, 3, 5, 7})
      while (rest % factor == 0) rest /= factor;
    if (rest == 1) return length;
  }
}

}  // namespace glare
