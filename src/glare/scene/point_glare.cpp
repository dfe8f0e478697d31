#include "glare/scene/point_glare.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "glare/base/parallel.h"
#include "glare/base/range_check.h"
#include "glare/scene/kernel_grid.h"
#include "glare/scene/vector3.h"
#include "glare/scene/veil_row.h"
#include "glare/template/profile.h"

namespace glare {

namespace {

/// Nearer to the lamp than this, in the picture's pixels, the veil is summed in parts of pixels.
constexpr double kNear_px = 8;
/// From here on the two ways of summing blend.
constexpr double kBlend_px = 5;
/// The finest grid near the lamp has so many pixels to one of the picture.
constexpr double kFinestNear = 8;
/// Largest grid of the rest: 96 MB.
constexpr double kMostGridPixels = 6e6;
constexpr int kRowsPerTask = 8;

/// The pitch of the grid of the whole template: as many pixels to one of the picture as can be
/// summed, or fewer where they would be too many in all.
double whole_pitch_rad(const GlareTemplate& t, double picture_pitch_rad) {
  const double area = 1.0 * t.width() * t.height() * t.pixel_pitch_rad * t.pixel_pitch_rad;
  for (const double finer : {KernelGrid::kWidestPixel, 5.0, 4.0, 3.0, 2.0, 1.5})
    if (area * finer * finer <= kMostGridPixels * picture_pitch_rad * picture_pitch_rad)
      return picture_pitch_rad / finer;
  return picture_pitch_rad;
}

void require_usable(const GlareTemplate& t) {
  if (t.width() < 1 || t.height() < 1) throw InputError("", "the template has no pixels");
  if (!(t.pixel_pitch_rad > 0) || !(t.pixel_pitch_rad < 1))
    throw InputError("", "the template has no pitch in its range");
  if (!(t.per_steradian > 0) || !std::isfinite(t.per_steradian))
    throw InputError("", "the template has no absolute scale");
}

}  // namespace

struct GlareKernel::Parts {
  double picture_pitch_rad = 0;  ///< Of the camera's pixels, on its axis.
  KernelGrid whole;
  KernelGrid near;  ///< About the axis, finer; empty where `whole` has the template's own pixels.
  const KernelGrid& near_grid() const { return near.rgba.empty() ? whole : near; }
};

GlareKernel::GlareKernel(const GlareTemplate& t, const Camera& camera,
                         const RgbColorSpace& picture_space) {
  require_valid(camera);
  require_usable(t);
  const Matrix3 colors = picture_space.rgb_from_xyz() * t.color_space.xyz_from_rgb();
  auto parts = std::make_shared<Parts>();
  const double pitch = parts->picture_pitch_rad = 1 / camera.focal_length_px();
  const double softness = std::max(0.0, 1 - pitch / t.pixel_pitch_rad);
  parts->whole = kernel_grid(t, colors, whole_pitch_rad(t, pitch), 2, softness);
  if (parts->whole.pitch_rad > t.pixel_pitch_rad)
    parts->near = kernel_grid(t, colors, pitch / kFinestNear, (kNear_px + 2) * pitch, 0);
  parts_ = std::move(parts);
}

namespace {

/// The axes of the template about a lamp, in the viewer's (right, up, forward).
struct LampAxes {
  Vector3 right, down, forward;
};

/// The viewer's axes turned by the shortest way so that forward is the lamp's direction.
LampAxes lamp_axes(const Vector3& direction) {
  const Vector3 d = unit(direction);
  const auto [x, y, z] = d;
  if (z < -1 + 1e-12) return {{-1, 0, 0}, {0, -1, 0}, d};  // Turned by its right.
  const double s = 1 / (1 + z);
  return {{1 - x * x * s, -x * y * s, -x}, {x * y * s, -(1 - y * y * s), y}, d};
}

/// A lamp's veil in a picture: whichever rows are asked for.
class LampVeil {
 public:
  LampVeil(const PointOfLight& point, const Camera& camera)
      : kernel_(point.kernel.parts()),
        camera_(camera),
        focal_length_px_(camera.focal_length_px()),
        axes_(lamp_axes(point.direction)),
        illuminance_lux_(static_cast<float>(point.illuminance_lux)),
        place_(camera.pixel_of(point.direction)) {
    const double pixel = 1 / (focal_length_px_ * kernel_.near_grid().pitch_rad);
    parts_ = std::max(2, static_cast<int>(std::ceil(2 * pixel - 1e-6)));
  }

  void add_to_row(Picture& picture, int row) const {
    const auto [begin, end] = near_columns(row);
    add(picture, row, 0, begin);
    if (begin < end) add_near(picture, row, begin, end);
    add(picture, row, end, camera_.width);
  }

 private:
  /// The picture's columns in the square about the lamp; none is [0, 0).
  std::array<int, 2> near_columns(int row) const {
    if (!place_ || std::abs(row - (*place_)[1]) > kNear_px) return {0, 0};
    const auto clamped = [&](double column) {
      return static_cast<int>(std::clamp(column, 0.0, 1.0 * camera_.width));
    };
    return {clamped(std::ceil((*place_)[0] - kNear_px)),
            clamped(std::floor((*place_)[0] + kNear_px) + 1)};
  }

  /// The row of places that are 1 / `parts` of a pixel apart, the first of them at (column, row).
  VeilRow places(double column, double row, int parts, const KernelGrid& grid) const {
    const double step = 1 / (focal_length_px_ * parts);
    const double x = (column - 0.5 * (camera_.width - 1)) / focal_length_px_;
    const double y = (row - 0.5 * (camera_.height - 1)) / focal_length_px_;
    const auto along = [&](const Vector3& axis, double pitch) {
      return AlongRow{(axis[0] * x - axis[1] * y + axis[2]) / pitch, axis[0] * step / pitch,
                      -axis[1] * step / pitch};
    };
    return {{x, step, 0},
            {y, 0, step},
            along(axes_.right, grid.pitch_rad),
            along(axes_.down, grid.pitch_rad),
            along(axes_.forward, 1)};
  }

  void add(Picture& picture, int row, int begin, int end) const {
    std::array<float*, 3> values;
    for (std::size_t k = 0; k < 3; ++k) values[k] = picture.channels[k].row(row).data() + begin;
    add_veil(kernel_.whole, places(begin, row, 1, kernel_.whole), end - begin, illuminance_lux_,
             values);
  }

  /// The sum in parts of pixels, blending into the other one.
  void add_near(Picture& picture, int row, int begin, int end) const {
    const auto count = static_cast<std::size_t>(end - begin);
    const std::size_t finer = count * static_cast<std::size_t>(parts_);
    std::vector<float> plain(3 * count), fine(3 * finer);
    const auto channels = [](std::vector<float>& values) {
      const std::size_t n = values.size() / 3;
      return std::array{values.data(), values.data() + n, values.data() + 2 * n};
    };
    add_veil(kernel_.whole, places(begin, row, 1, kernel_.whole), end - begin, illuminance_lux_,
             channels(plain));
    const KernelGrid& grid = kernel_.near_grid();
    const auto middle = [&](int part) { return (part + 0.5) / parts_ - 0.5; };
    for (int part = 0; part < parts_; ++part)
      add_veil(grid, places(begin + middle(0), row + middle(part), parts_, grid),
               static_cast<int>(finer), illuminance_lux_, channels(fine));
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < count; ++i) {
        double sum = 0;
        for (int part = 0; part < parts_; ++part)
          sum += fine[k * finer + i * static_cast<std::size_t>(parts_) +
                      static_cast<std::size_t>(part)];
        const double share = near_share(begin + static_cast<int>(i), row);
        picture.channels[k](begin + static_cast<int>(i), row) += static_cast<float>(
            share * sum / (parts_ * parts_) + (1 - share) * plain[k * count + i]);
      }
  }

  /// How much of the sum in parts a pixel takes: 1 within kBlend_px of the lamp, 0 from kNear_px
  /// on.
  double near_share(int column, int row) const {
    const double distance = std::hypot(column - (*place_)[0], row - (*place_)[1]);
    return std::clamp((kNear_px - distance) / (kNear_px - kBlend_px), 0.0, 1.0);
  }

  const GlareKernel::Parts& kernel_;
  const Camera& camera_;
  double focal_length_px_;
  LampAxes axes_;
  float illuminance_lux_;
  std::optional<std::array<double, 2>> place_;
  int parts_;
};

void require_valid(const PointOfLight& point, double pitch_rad) {
  if (!is_finite(point.direction) || length(point.direction) == 0)
    throw OptionError("a point of light has no direction");
  require_in_range("a point of light's illuminance in lux", point.illuminance_lux, 0,
                   std::numeric_limits<float>::max());
  if (pitch_rad > point.kernel.parts().picture_pitch_rad * (1 + 1e-9))
    throw OptionError("a glare kernel was made for a picture of smaller pixels");
}

void require_size(const Picture& picture, const Camera& camera) {
  for (const Image<float>& channel : picture.channels)
    if (channel.width() != camera.width || channel.height() != camera.height)
      throw OptionError("the picture's size isn't the camera's");
}

/// The veils of those points that give light.
std::vector<LampVeil> veils_of(std::span<const PointOfLight> points, const Camera& camera) {
  require_valid(camera);
  std::vector<LampVeil> veils;
  for (const PointOfLight& point : points) {
    require_valid(point, 1 / camera.focal_length_px());
    if (point.illuminance_lux > 0) veils.emplace_back(point, camera);
  }
  return veils;
}

/// Calls `prepare(row)` and then adds the veils, row by row, a few rows a task.
template <typename Prepare>
void add_veils(Picture& picture, std::span<const LampVeil> veils, int threads,
               const Prepare& prepare) {
  const int height = picture.height();
  parallel_for((height + kRowsPerTask - 1) / kRowsPerTask, threads, [&](int task) {
    const int begin = task * kRowsPerTask, end = std::min(height, begin + kRowsPerTask);
    for (int row = begin; row < end; ++row) prepare(row);
    for (const LampVeil& veil : veils)
      for (int row = begin; row < end; ++row) veil.add_to_row(picture, row);
  });
}

}  // namespace

void add_glare(Picture& picture, const Camera& camera, std::span<const PointOfLight> points,
               int threads) {
  const auto veils = veils_of(points, camera);
  require_size(picture, camera);
  add_veils(picture, veils, threads, [](int) {});
}

void with_glare(const Picture& picture, const Camera& camera, std::span<const PointOfLight> points,
                Picture& result, int threads) {
  const auto veils = veils_of(points, camera);
  require_size(picture, camera);
  result.color_space = picture.color_space;
  for (Image<float>& channel : result.channels)
    if (channel.width() != picture.width() || channel.height() != picture.height())
      channel = Image<float>::uninitialized(picture.width(), picture.height());
  add_veils(result, veils, threads, [&](int row) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto values = picture.channels[k].row(row);
      std::copy(values.begin(), values.end(), result.channels[k].row(row).begin());
    }
  });
}

double illuminance_for_peak_lux(const GlareTemplate& t, double luminance) {
  require_usable(t);
  const double peak_per_steradian = peak(t).luminance * t.per_steradian;
  if (!(peak_per_steradian > 0)) throw InputError("", "the template is dark");
  return luminance / peak_per_steradian;
}

}  // namespace glare
