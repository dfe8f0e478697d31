// What no template can be made of, and how making one is limited and stopped.

#include <gtest/gtest.h>

#include <limits>

#include "glare/base/error.h"
#include "glare/spectrum/lamps.h"
#include "glare/template/make_template.h"
#include "support/templates.h"

namespace glare {
namespace {

const Aperture& pupil() { return test::small_pupil(); }
Spectrum lamp() { return *find_lamp("LED-B3"); }
TemplateOptions small() { return test::small_options(); }

GlareTemplate made(const TemplateOptions& options) {
  return make_template(pupil(), lamp(), options);
}

template <typename Exception, typename Change>
void expect_refused(const Change& change) {
  auto options = small();
  change(options);
  EXPECT_THROW(made(options), Exception);
}

TEST(MakeTemplate, RefusesOptionsOutsideTheirRange) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  for (const int size : {0, -1, 65536}) {
    expect_refused<OptionError>([&](auto& o) { o.width = size; });
    expect_refused<OptionError>([&](auto& o) { o.height = size; });
  }
  for (const double deg : {0.0, -1.0, 115.0, kNan, 3.0})
    expect_refused<OptionError>([&](auto& o) { o.field_of_view_deg = deg; });
  expect_refused<OptionError>([](auto& o) { o.observer = "cat"; });
  for (const WavelengthRange range : {WavelengthRange{700, 400},
                                      {500, 500},
                                      {-10, 700},
                                      {0, 700},
                                      {400, kNan},
                                      {900, 1000},
                                      {400, std::numeric_limits<double>::infinity()}})
    expect_refused<OptionError>([&](auto& o) { o.wavelength_range_nm = range; });
}

TEST(MakeTemplate, RefusesInputsThatGiveNoPicture) {
  EXPECT_THROW(make_template(Aperture{Image<float>(8, 8), 1}, lamp(), small()), InputError);
  EXPECT_THROW(make_template(pupil(), Spectrum({900, 1000}, {1, 1}), small()), InputError);
  EXPECT_THROW(make_template(pupil(), Spectrum({400, 700}, {0, 0}), small()), InputError);
}

TEST(MakeTemplate, AsksForNoMoreMemoryThanAllowed) {
  auto options = small();
  const std::uint64_t bytes =
      template_bytes({128, 128, pupil().pixel_mm()}, options, options.wavelength_range_nm);
  EXPECT_GT(bytes, 128u * 128 * 4);
  options.memory_limit_bytes = bytes;
  EXPECT_NO_THROW(made(options));
  options.memory_limit_bytes = 100'000;
  EXPECT_THROW(made(options), MemoryError);
}

TEST(MakeTemplate, CanBeWatchedAndCancelled) {
  auto options = small();
  double last = 0;
  options.progress = [&](double fraction) {
    last = fraction;
    return true;
  };
  made(options);
  EXPECT_EQ(last, 1);
  options.progress = [](double) { return false; };
  EXPECT_THROW(made(options), Cancelled);
}

}  // namespace
}  // namespace glare
