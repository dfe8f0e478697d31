#include "glare/io/eye_photo.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <numbers>

#include "glare/base/error.h"
#include "glare/io/module/modules.h"
#include "glare/io/photo/curve.h"

namespace glare {

namespace {

using photo::Place;

constexpr int kSmallestSide = 96, kLargestSide = 16384;
/// Bytes that a pixel of the photograph takes here and in the module, and one of the apertures.
constexpr std::uint64_t kPhotoPixelBytes = 40, kAperturePixelBytes = 16;
constexpr double kLeastIrisConfidence = 0.3;

std::string text_of(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

void require_range(const char* name, double value, double low, double high) {
  if (!(value >= low && value <= high))
    throw OptionError(std::string(name) + " must be from " + text_of(low) + " to " + text_of(high) +
                      ", not " + text_of(value));
}

void require_valid(const EyePhotoOptions& o, int width, int height) {
  if (o.pupil_mm && o.mm_per_px)
    throw OptionError("the pupil's diameter and mm per pixel both give the scale; one is expected");
  require_range("the iris' diameter in mm", o.iris_mm, 5, 20);
  if (o.pupil_mm) require_range("the pupil's diameter in mm", *o.pupil_mm, 0.5, 12);
  if (o.mm_per_px) require_range("mm per pixel", *o.mm_per_px, 1e-4, 1);
  require_range("the apertures' width in mm", o.width_mm, 0.5, 50);
  require_range("the apertures' size in pixels", o.size, 16, 16384);
  for (const double shift : o.lashes_shift_mm)
    require_range("the eyelashes' shift in mm", shift, -50, 50);
  if (o.pupil_at_px) {
    require_range("the pupil's column", (*o.pupil_at_px)[0], 0, width - 1);
    require_range("the pupil's row", (*o.pupil_at_px)[1], 0, height - 1);
  }
  if (const auto& r = o.lashes_region_px) {
    const bool within = r->x >= 0 && r->y >= 0 && r->width >= 1 && r->height >= 1 &&
                        r->x + r->width <= width && r->y + r->height <= height;
    if (!within)
      throw OptionError("the eyelashes' region must lie within the photograph of " +
                        std::to_string(width) + " x " + std::to_string(height) + " pixels");
  }
}

void require_fits(const RgbImage& photograph, const EyePhotoOptions& options) {
  const std::uint64_t needed = kPhotoPixelBytes * photograph.values().size() +
                               kAperturePixelBytes * static_cast<std::uint64_t>(options.size) *
                                   static_cast<std::uint64_t>(options.size);
  if (needed > options.memory_limit_bytes) throw MemoryError(needed, options.memory_limit_bytes);
}

/// The value that one in a hundred is above.
float bright_value(const RgbImage& picture, std::size_t channel) {
  std::vector<std::uint64_t> counts(1024, 0);
  for (const auto& pixel : picture.values())
    ++counts[static_cast<std::size_t>(std::clamp(pixel[channel], 0.0f, 1.0f) * 1023)];
  std::uint64_t above = picture.values().size() / 100;
  std::size_t bin = 1023;
  while (bin > 0 && counts[bin] <= above) above -= counts[bin--];
  return static_cast<float>(bin + 1) / 1024;
}

/// Mostly the red channel: melanin and the iris' blue scatter less there, so that the pupil stands
/// out from any iris as it does in the infrared. Each channel is divided by its own bright value,
/// which takes a colour cast away; a channel without light has no weight.
Image<float> grey_of(const RgbImage& picture) {
  constexpr std::array<float, 3> kShares = {0.6f, 0.3f, 0.1f};
  std::array<float, 3> weights{};
  float sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const float bright = bright_value(picture, k);
    const float share = bright < 0.04f ? 0 : kShares[k];
    weights[k] = share / bright;
    sum += share;
  }
  Image<float> grey(picture.width(), picture.height());
  for (std::size_t i = 0; i < grey.values().size(); ++i) {
    const auto& p = picture.values()[i];
    if (sum > 0)
      grey.values()[i] = (weights[0] * p[0] + weights[1] * p[1] + weights[2] * p[2]) / sum;
  }
  return grey;
}

module::FoundEye found_eye(const RgbImage& photograph, const EyePhotoOptions& options,
                           Image<float>& hairs) {
  const Image<float> grey = grey_of(photograph);
  module::EyePhotograph question = {
      grey.width(), grey.height(), grey.values().data(), options.pupil_at_px.has_value(), 0, 0};
  if (options.pupil_at_px) {
    question.pupil_at_x = (*options.pupil_at_px)[0];
    question.pupil_at_y = (*options.pupil_at_px)[1];
  }
  module::FoundEye eye{};
  module::Message message;
  switch (module::eye_photo_reader().find(question, eye, hairs.values().data(), message)) {
    case module::PhotoOutcome::found:
      return eye;
    case module::PhotoOutcome::no_pupil:
      throw InputError("", message.text);
    case module::PhotoOutcome::no_memory:
      throw std::bad_alloc();
    case module::PhotoOutcome::failed:
      break;
  }
  throw Error(std::string("the search for the pupil failed: ") + message.text);
}

double scale_of(const EyePhoto& eye, const EyePhotoOptions& options) {
  if (options.mm_per_px) return *options.mm_per_px;
  if (options.pupil_mm)
    return *options.pupil_mm / std::sqrt(eye.pupil_axes_px[0] * eye.pupil_axes_px[1]);
  if (eye.iris_diameter_px <= 0 || eye.iris_confidence < kLeastIrisConfidence)
    throw InputError("",
                     "the iris' edge, which gives the scale, isn't clear; the pupil's diameter in "
                     "mm or mm per pixel is needed (--pupil-mm, --mm-per-px)");
  return options.iris_mm / eye.iris_diameter_px;
}

Image<std::uint8_t> mask_of(const EyePhoto& eye, int width, int height) {
  std::vector<Place> polygon = eye.outline_px;
  for (Place& p : polygon) p = {p[0] + 0.5, p[1] + 0.5};
  const Image<float> area = photo::covered_area(polygon, width, height);
  Image<std::uint8_t> mask(width, height);
  for (std::size_t i = 0; i < mask.values().size(); ++i)
    mask.values()[i] = area.values()[i] >= 0.5f ? 255 : 0;
  return mask;
}

Aperture pupil_aperture(const EyePhoto& eye, const EyePhotoOptions& options) {
  const double pixels = eye.mm_per_px * options.size / options.width_mm;
  std::vector<Place> points;
  for (const Place& p : eye.outline_px)
    points.push_back({0.5 * options.size + pixels * (p[0] - eye.pupil_center_px[0]),
                      0.5 * options.size + pixels * (p[1] - eye.pupil_center_px[1])});
  const auto curve = photo::smooth_closed_curve(points, 8);
  return {photo::covered_area(curve, options.size, options.size), options.width_mm};
}

/// The hairs' transmittance with 1 outside of the region, whose border is soft over two pixels.
Image<float> within_region(Image<float> hairs, const std::optional<PixelRectangle>& region) {
  if (!region) return hairs;
  for (int y = 0; y < hairs.height(); ++y)
    for (int x = 0; x < hairs.width(); ++x) {
      const double depth = std::min({x + 1 - region->x, region->x + region->width - x,
                                     y + 1 - region->y, region->y + region->height - y});
      const auto share = static_cast<float>(std::clamp(0.5 * depth, 0.0, 1.0));
      hairs(x, y) = 1 - share * (1 - hairs(x, y));
    }
  return hairs;
}

std::array<double, 4> cubic_weights(double t) {
  // Catmull-Rom: through the samples, with a continuous slope.
  return {0.5 * t * (-1 + t * (2 - t)), 1 + 0.5 * t * t * (-5 + 3 * t),
          0.5 * t * (1 + t * (4 - 3 * t)), 0.5 * t * t * (t - 1)};
}

/// Cubic interpolation, limited to [0, 1]; 1 outside of the picture.
float interpolated(const Image<float>& image, double x, double y) {
  if (!(x > -2 && y > -2 && x < image.width() + 1 && y < image.height() + 1)) return 1;
  const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
  const auto across = cubic_weights(x - x0), down = cubic_weights(y - y0);
  double sum = 0;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) {
      const int column = x0 + i - 1, row = y0 + j - 1;
      const bool inside = column >= 0 && row >= 0 && column < image.width() && row < image.height();
      sum += across[static_cast<std::size_t>(i)] * down[static_cast<std::size_t>(j)] *
             (inside ? image(column, row) : 1.0f);
    }
  return static_cast<float>(std::clamp(sum, 0.0, 1.0));
}

Aperture eyelash_aperture(const EyePhoto& eye, const EyePhotoOptions& options) {
  const double pitch = options.width_mm / options.size / eye.mm_per_px;  // In the photograph's.
  const PixelRectangle region = options.lashes_region_px.value_or(PixelRectangle{
      0, 0, static_cast<double>(eye.hairs.width()), static_cast<double>(eye.hairs.height())});
  Aperture result{Image<float>(options.size, options.size), options.width_mm};
  const auto place = [&](int index, std::size_t axis) {
    return eye.pupil_center_px[axis] + (index + 0.5 - 0.5 * options.size) * pitch -
           options.lashes_shift_mm[axis] / eye.mm_per_px;
  };
  for (int y = 0; y < options.size; ++y) {
    double row = place(y, 1);
    if (options.flip_lashes) row = 2 * region.y + region.height - 1 - row;
    for (int x = 0; x < options.size; ++x)
      result.transmittance(x, y) = interpolated(eye.hairs, place(x, 0), row);
  }
  return result;
}

EyePhoto measured(const module::FoundEye& found) {
  EyePhoto eye;
  eye.pupil_center_px = {found.center_x, found.center_y};
  eye.pupil_axes_px = {2 * found.semi_major, 2 * found.semi_minor};
  eye.pupil_angle_deg = found.angle_rad * 180 / std::numbers::pi;
  eye.confidence = found.confidence;
  for (int k = 0; k < module::FoundEye::kOutlinePoints; ++k)
    eye.outline_px.push_back({found.outline_x[k], found.outline_y[k]});
  eye.iris_center_px = {found.iris_x, found.iris_y};
  eye.iris_diameter_px = 2 * found.iris_radius;
  eye.iris_confidence = found.iris_confidence;
  return eye;
}

}  // namespace

double EyePhoto::pupil_diameter_mm() const {
  return mm_per_px * std::sqrt(pupil_axes_px[0] * pupil_axes_px[1]);
}

EyePhoto eye_from_photo(const RgbImage& photograph, const EyePhotoOptions& options) {
  const int width = photograph.width(), height = photograph.height();
  if (std::min(width, height) < kSmallestSide || std::max(width, height) > kLargestSide)
    throw InputError("", "the photograph has " + std::to_string(width) + " x " +
                             std::to_string(height) + " pixels; 96 to 16384 each way are expected");
  require_valid(options, width, height);
  require_fits(photograph, options);
  Image<float> hairs(width, height);
  EyePhoto eye = measured(found_eye(photograph, options, hairs));
  eye.mm_per_px = scale_of(eye, options);
  eye.hairs = within_region(std::move(hairs), options.lashes_region_px);
  eye.mask = mask_of(eye, width, height);
  eye.pupil = pupil_aperture(eye, options);
  eye.eyelashes = eyelash_aperture(eye, options);
  return eye;
}

}  // namespace glare
