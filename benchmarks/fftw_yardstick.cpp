#include "fftw_yardstick.h"

#include <fftw3.h>

#include <algorithm>
#include <cstddef>
#include <new>

namespace glare::bench {

struct FftwYardstick::Plan {
  float* in = nullptr;
  fftwf_complex* out = nullptr;
  fftwf_plan plan = nullptr;
};

FftwYardstick::FftwYardstick(int n) : plan_(std::make_unique<Plan>()) {
  const auto side = static_cast<std::size_t>(n);
  plan_->in = fftwf_alloc_real(side * side);
  plan_->out = fftwf_alloc_complex(side * (side / 2 + 1));
  if (!plan_->in || !plan_->out) throw std::bad_alloc();
  plan_->plan = fftwf_plan_dft_r2c_2d(n, n, plan_->in, plan_->out, FFTW_MEASURE);
  // An aperture of a quarter of the length, open everywhere.
  for (std::size_t y = 0; y < side; ++y)
    for (std::size_t x = 0; x < side; ++x)
      plan_->in[y * side + x] = x < side / 4 && y < side / 4 ? 1.0f : 0.0f;
}

FftwYardstick::~FftwYardstick() {
  fftwf_destroy_plan(plan_->plan);
  fftwf_free(plan_->out);
  fftwf_free(plan_->in);
}

void FftwYardstick::run() { fftwf_execute(plan_->plan); }

struct FftwThereAndBack::Plans {
  float* values = nullptr;
  fftwf_complex* spectrum = nullptr;
  fftwf_plan there = nullptr, back = nullptr;
};

FftwThereAndBack::FftwThereAndBack(int columns, int rows, int threads)
    : plans_(std::make_unique<Plans>()) {
  const auto width = static_cast<std::size_t>(columns), height = static_cast<std::size_t>(rows);
  plans_->values = fftwf_alloc_real(width * height);
  plans_->spectrum = fftwf_alloc_complex((width / 2 + 1) * height);
  if (!plans_->values || !plans_->spectrum || fftwf_init_threads() == 0) throw std::bad_alloc();
  fftwf_plan_with_nthreads(threads);
  plans_->there =
      fftwf_plan_dft_r2c_2d(rows, columns, plans_->values, plans_->spectrum, FFTW_ESTIMATE);
  plans_->back =
      fftwf_plan_dft_c2r_2d(rows, columns, plans_->spectrum, plans_->values, FFTW_ESTIMATE);
  fftwf_plan_with_nthreads(1);
  // Zeros stay zeros, however often they are transformed; they take the time of any values.
  std::fill_n(plans_->values, width * height, 0.0f);
}

FftwThereAndBack::~FftwThereAndBack() {
  fftwf_destroy_plan(plans_->back);
  fftwf_destroy_plan(plans_->there);
  fftwf_free(plans_->spectrum);
  fftwf_free(plans_->values);
}

void FftwThereAndBack::run() {
  fftwf_execute(plans_->there);
  fftwf_execute(plans_->back);
}

}  // namespace glare::bench
