#include "fftw_yardstick.h"

#include <fftw3.h>

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

}  // namespace glare::bench
