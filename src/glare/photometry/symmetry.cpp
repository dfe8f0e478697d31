#include "glare/photometry/symmetry.h"

#include <algorithm>
#include <cmath>

#include "glare/base/error.h"
#include "glare/photometry/text_reading.h"

namespace glare {

std::string name_of(PhotometricSymmetry symmetry) {
  switch (symmetry) {
    case PhotometricSymmetry::none:
      return "none";
    case PhotometricSymmetry::rotational:
      return "rotational";
    case PhotometricSymmetry::plane_0_180:
      return "C0-C180";
    case PhotometricSymmetry::plane_90_270:
      return "C90-C270";
    case PhotometricSymmetry::quadrants:
      return "quadrants";
    case PhotometricSymmetry::lateral:
      return "lateral";
  }
  return {};
}

namespace photometry {

namespace {

bool multiple_of(double angle_deg, double of_deg) {
  return same_angle(std::remainder(angle_deg, of_deg), 0);
}

/// Planes of `grid` at new angles: `sources[i]` is the plane that stands at `horizontal_deg[i]`.
MeasuredGrid with_planes(const MeasuredGrid& grid, std::vector<double> horizontal_deg,
                         const std::vector<int>& sources) {
  MeasuredGrid result{std::move(horizontal_deg), grid.vertical_deg,
                      Image<float>(static_cast<int>(sources.size()), grid.candela.height())};
  for (int j = 0; j < result.candela.height(); ++j)
    for (int i = 0; i < result.candela.width(); ++i)
      result.candela(i, j) = grid.candela(sources[static_cast<std::size_t>(i)], j);
  return result;
}

std::vector<int> all_planes(const MeasuredGrid& grid) {
  std::vector<int> sources(grid.horizontal_deg.size());
  for (std::size_t i = 0; i < sources.size(); ++i) sources[i] = static_cast<int>(i);
  return sources;
}

double span_deg(const MeasuredGrid& grid) {
  return grid.horizontal_deg.back() - grid.horizontal_deg.front();
}

}  // namespace

bool same_angle(double a_deg, double b_deg) { return std::abs(a_deg - b_deg) < kSameAngle_deg; }

void snap_to_right_angles(std::vector<double>& angles_deg) {
  for (double& angle_deg : angles_deg)
    if (const double right_deg = 90 * std::round(angle_deg / 90); same_angle(angle_deg, right_deg))
      angle_deg = right_deg;
}

Image<float> room_for_intensities(const MeasuredGrid& grid, std::size_t text_size,
                                  const std::string& place) {
  const std::size_t planes = grid.horizontal_deg.size(), count = grid.vertical_deg.size();
  if (planes * count > text_size)
    throw InputError(place, "the file is too short for " + std::to_string(planes) + " x " +
                                std::to_string(count) + " intensities");
  return Image<float>(static_cast<int>(planes), static_cast<int>(count));
}

LuminousIntensityDistribution distribution_from(PhotometricType type, const MeasuredGrid& grid,
                                                const std::string& place) try {
  return {type, grid.horizontal_deg, grid.vertical_deg, grid.candela};
} catch (const InputError& error) {
  throw InputError(place, error.message());
}

bool is_closed(const MeasuredGrid& grid) { return same_angle(span_deg(grid), 360); }

MeasuredGrid mirrored_about_last(const MeasuredGrid& grid) {
  std::vector<double> angles_deg = grid.horizontal_deg;
  std::vector<int> sources = all_planes(grid);
  const double last_deg = angles_deg.back();
  for (int i = static_cast<int>(sources.size()) - 2; i >= 0; --i) {
    angles_deg.push_back(2 * last_deg - grid.horizontal_deg[static_cast<std::size_t>(i)]);
    sources.push_back(i);
  }
  return with_planes(grid, std::move(angles_deg), sources);
}

MeasuredGrid mirrored_about_first(const MeasuredGrid& grid) {
  std::vector<double> angles_deg;
  std::vector<int> sources;
  const double first_deg = grid.horizontal_deg.front();
  for (int i = static_cast<int>(grid.horizontal_deg.size()) - 1; i > 0; --i) {
    angles_deg.push_back(2 * first_deg - grid.horizontal_deg[static_cast<std::size_t>(i)]);
    sources.push_back(i);
  }
  const std::vector<int> rest = all_planes(grid);
  angles_deg.insert(angles_deg.end(), grid.horizontal_deg.begin(), grid.horizontal_deg.end());
  sources.insert(sources.end(), rest.begin(), rest.end());
  return with_planes(grid, std::move(angles_deg), sources);
}

MeasuredGrid around_the_axis(const MeasuredGrid& grid) {
  return with_planes(grid, {0, 360}, {0, 0});
}

MeasuredGrid closed_circle(const MeasuredGrid& grid) {
  std::vector<double> angles_deg = grid.horizontal_deg;
  std::vector<int> sources = all_planes(grid);
  angles_deg.push_back(angles_deg.front() + 360);
  sources.push_back(0);
  return with_planes(grid, std::move(angles_deg), sources);
}

MeasuredGrid from_zero(const MeasuredGrid& grid) {
  const std::vector<double>& angles_deg = grid.horizontal_deg;
  const auto zero = std::find_if(angles_deg.begin(), angles_deg.end(),
                                 [](double angle_deg) { return multiple_of(angle_deg, 360); });
  if (!same_angle(span_deg(grid), 360) || zero == angles_deg.end()) return grid;
  const double zero_deg = *zero;
  const auto begin = static_cast<int>(zero - angles_deg.begin());
  const auto count = static_cast<int>(angles_deg.size()) - 1;  // The last plane is the first one.
  std::vector<double> turned_deg;
  std::vector<int> sources;
  for (int i = 0; i < count; ++i) {
    const int source = (begin + i) % count;
    const double turns_deg = begin + i >= count ? 360 : 0;
    turned_deg.push_back(angles_deg[static_cast<std::size_t>(source)] - zero_deg + turns_deg);
    sources.push_back(source);
  }
  turned_deg.push_back(360);
  // A circle that was given from 0 to 360 keeps its last plane.
  sources.push_back(begin == 0 ? count : sources.front());
  return with_planes(grid, std::move(turned_deg), sources);
}

Unfolded unfolded_type_c(const MeasuredGrid& grid) {
  using enum PhotometricSymmetry;
  if (grid.horizontal_deg.size() == 1) return {around_the_axis(grid), rotational};
  const double first_deg = grid.horizontal_deg.front(), last_deg = grid.horizontal_deg.back();
  const double span = span_deg(grid);
  if (same_angle(span, 360)) return {from_zero(grid), none};
  if (same_angle(span, 180) && multiple_of(first_deg, 90))
    return {from_zero(mirrored_about_last(grid)),
            multiple_of(first_deg, 180) ? plane_0_180 : plane_90_270};
  if (same_angle(span, 90) && multiple_of(first_deg, 90))
    return {from_zero(mirrored_about_last(mirrored_about_last(grid))), quadrants};
  const double last_step = last_deg - *(grid.horizontal_deg.end() - 2);
  if (same_angle(span + last_step, 360)) return {from_zero(closed_circle(grid)), none, true};
  throw InputError("", "the horizontal angles of type C go from " + text_of(first_deg) + " to " +
                           text_of(last_deg) +
                           ", which fits no symmetry; expected 0 alone, or 0 to 90, 0 to 180, 90 "
                           "to 270 or 0 to 360");
}

Unfolded unfolded_type_ab(const MeasuredGrid& grid) {
  const std::vector<double>& angles_deg = grid.horizontal_deg;
  if (angles_deg.size() > 1 && same_angle(angles_deg.front(), 0) &&
      angles_deg.back() <= 180 + kSameAngle_deg)
    return {mirrored_about_first(grid), PhotometricSymmetry::lateral};
  return {grid, PhotometricSymmetry::none};
}

}  // namespace photometry
}  // namespace glare
