// The photograph as the search for the eye sees it. Internal; of the module glare_eye_photo.
#pragma once

#include <opencv2/core.hpp>
#include <span>
#include <vector>

namespace glare::photo {

/// Grey values, contrast stretched: 0 and 1 are near the darkest and the brightest of the picture.
struct Picture {
  cv::Mat1f raw;     ///< As it is.
  cv::Mat1f smooth;  ///< Denoised, and without glints.
  cv::Mat1b glints;  ///< 255 where a glint was.
  float noise =
      0;  ///< Standard deviation of what is left of the noise in `smooth`, at least 0.008.

  int width() const { return raw.cols; }
  int height() const { return raw.rows; }
};

/// A full ellipse: `a` and `b` are semi-axes in pixels, a >= b, `angle_rad` from the x axis to a,
/// towards y (down). Pixel centres are at whole numbers.
struct PupilEllipse {
  cv::Point2d center;
  double a = 0, b = 0, angle_rad = 0;

  double mean_radius() const;
  /// The length of the ray from the centre in direction `angle_rad` to the ellipse.
  double radius_at(double direction_rad) const;
  cv::Point2d point_at(double direction_rad) const;
};

/// The value at a place between pixels, linearly interpolated; negative outside of the picture.
float sample(const cv::Mat1f& image, double x, double y);

/// The value below which a share of the values is; reorders them. 0 of no values.
float quantile(std::vector<float>& values, double share);

/// Denoised, stretched and without glints. A picture without contrast gives one of zeros.
Picture prepared(const cv::Mat1f& grey);

/// The same at `1 / factor` of the size.
Picture reduced(const Picture& picture, double factor);

}  // namespace glare::photo
