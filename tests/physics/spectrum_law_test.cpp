// What the template owes to the lamp: it is linear in the lamp's light and doesn't see its table.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "glare/glare.h"
#include "support/templates.h"

namespace glare {
namespace {

const WavelengthRange kRange{380, 780};

const Aperture& aperture() {
  static const Aperture lashed = test::lashed_pupil({400, 400, 4}, 3.6);
  return lashed;
}

TemplateOptions options() { return test::absolute_xyz(120, 100, 2e-4); }

double luminous(const Spectrum& lamp) {
  return luminous_integral(lamp, color_matching_functions("cie1931-2deg"), kRange);
}

/// The lamp's values times share(wavelength), at every nanometre.
template <typename Share>
Spectrum part_of(const Spectrum& lamp, const Share& share) {
  std::vector<double> nm, value;
  for (int i = 380; i <= 780; ++i) {
    nm.push_back(i);
    value.push_back(lamp(i) * share(i));
  }
  return Spectrum(nm, value);
}

TEST(SpectrumLaw, TheLightOfTwoLampsAddsUp) {
  const Spectrum whole = part_of(*find_lamp("FL11"), [](double) { return 1.0; });
  // Linear between whole nanometres, as the table itself: the two parts sum to it exactly.
  const auto blue = [](double nm) { return std::clamp((580 - nm) / 80, 0.0, 1.0); };
  const Spectrum first = part_of(*find_lamp("FL11"), blue);
  const Spectrum second = part_of(*find_lamp("FL11"), [&](double nm) { return 1 - blue(nm); });
  const GlareTemplate all = make_template(aperture(), whole, options());
  const GlareTemplate a = make_template(aperture(), first, options());
  const GlareTemplate b = make_template(aperture(), second, options());
  const double share = luminous(first) / luminous(whole);
  EXPECT_NEAR(luminous(second) / luminous(whole), 1 - share, 1e-12);
  for (int k = 0; k < 3; ++k) {
    Image<float> sum = all.channels[k];
    for (std::size_t i = 0; i < sum.values().size(); ++i)
      sum.values()[i] = static_cast<float>(share * a.channels[k].values()[i] +
                                           (1 - share) * b.channels[k].values()[i]);
    // The same sums in another order, in single precision.
    EXPECT_LT(test::difference(sum, all.channels[k]).relative, 1e-5) << k;
  }
}

TEST(SpectrumLaw, APartOfTheRangeAndTheRestAddUp) {
  const Spectrum lamp = *find_lamp("HP5");
  auto blue = options(), red = options();
  blue.wavelength_range_nm = {380, 552.3};
  red.wavelength_range_nm = {552.3, 780};
  const auto& observer = color_matching_functions("cie1931-2deg");
  const FarField field = template_far_field(aperture(), options(), kRange);
  const GlareTemplate all = make_template(field, lamp, options());
  const GlareTemplate a = make_template(field, lamp, blue);
  const GlareTemplate b = make_template(field, lamp, red);
  const double share = luminous_integral(lamp, observer, blue.wavelength_range_nm) / luminous(lamp);
  Image<float> sum = all.channels[1];
  for (std::size_t i = 0; i < sum.values().size(); ++i)
    sum.values()[i] = static_cast<float>(share * a.channels[1].values()[i] +
                                         (1 - share) * b.channels[1].values()[i]);
  const auto off = test::difference(sum, all.channels[1]);
  EXPECT_LT(off.of_peak, 2e-6);  // Three quadratures with different nodes: what each leaves.
  EXPECT_LT(off.relative, 5e-4);
}

TEST(SpectrumLaw, TenTimesAsManyRowsChangeNothing) {
  const Spectrum lamp = *find_lamp("HP3");
  std::vector<double> nm, value;
  for (int i = 3800; i <= 7800; i += 5) {
    nm.push_back(i / 10.0);
    value.push_back(lamp(i / 10.0));
  }
  const GlareTemplate few = make_template(aperture(), lamp, options());
  const GlareTemplate many = make_template(aperture(), Spectrum(nm, value), options());
  for (int k = 0; k < 3; ++k)
    EXPECT_LT(test::difference(many.channels[k], few.channels[k]).relative, 1e-5)
        << k;  // Rounding.
}

TEST(SpectrumLaw, ABrighterLampIsTheSameLamp) {
  const Spectrum lamp = *find_lamp("LED-V1");
  std::vector<double> tenfold(lamp.values().begin(), lamp.values().end());
  for (double& value : tenfold) value *= 1e7;
  const Spectrum brighter({lamp.wavelengths_nm().begin(), lamp.wavelengths_nm().end()}, tenfold);
  const GlareTemplate a = make_template(aperture(), lamp, options());
  const GlareTemplate b = make_template(aperture(), brighter, options());
  for (int k = 0; k < 3; ++k)
    EXPECT_LT(test::difference(b.channels[k], a.channels[k]).relative, 1e-5) << k;  // Rounding.
}

TEST(SpectrumLaw, ThePatternScalesWithTheWavelength) {
  // PSF(theta, lambda) lambda^2 depends on theta / lambda alone.
  const auto scaled = [&](double nm) {
    Image<float> y = test::luminance_of(aperture(), test::line_lamp(nm, nm * 1e-4),
                                        test::absolute_xyz(121, 121, 3e-7 * nm));
    for (float& value : y.values()) value *= static_cast<float>(nm * nm * 1e-6);
    return y;
  };
  const Image<float> green = scaled(550);
  for (const double nm : {420.0, 488.0, 700.0}) {
    const auto off = test::difference(scaled(nm), green);
    // The observer's slope across the line shifts its mean wavelength by less than 1e-6.
    EXPECT_LT(off.of_peak, 1e-5) << nm;
    EXPECT_LT(off.relative, 2e-3) << nm;
  }
}

TEST(SpectrumLaw, ThePatternScalesInverselyWithTheAperture) {
  const Spectrum lamp = *find_lamp("A");
  const Image<float> y = test::luminance_of(aperture(), lamp, options());
  for (const double s : {0.25, 0.618, 1.75}) {
    Aperture other = aperture();
    other.width_mm *= s;
    Image<float> scaled = test::luminance_of(other, lamp, test::absolute_xyz(120, 100, 2e-4 / s));
    for (float& value : scaled.values()) value /= static_cast<float>(s * s);
    EXPECT_LT(test::difference(scaled, y).relative, 1e-4) << s;  // Rounding of the positions.
  }
}

}  // namespace
}  // namespace glare
