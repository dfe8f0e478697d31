#include "glare/io/photo/hairs.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <opencv2/photo.hpp>

namespace glare::photo {

namespace {

/// Non-local means (A. Buades and others, 2005), which keeps thin lines.
cv::Mat1f denoised(const Picture& picture) {
  cv::Mat1b bytes, calm;
  cv::Mat(cv::min(cv::max(picture.raw, 0), 1) * 255).convertTo(bytes, CV_8U);
  cv::fastNlMeansDenoising(bytes, calm, 255 * std::min(0.04f, picture.noise), 3, 11);
  cv::Mat1f result;
  calm.convertTo(result, CV_32F, 1 / 255.0);
  return result;
}

cv::Mat1f background_of(const cv::Mat1f& image, double widest_px) {
  const int side = 2 * std::max(2, static_cast<int>(std::lround(0.75 * widest_px))) + 1;
  cv::Mat1f closed;
  cv::morphologyEx(image, closed, cv::MORPH_CLOSE,
                   cv::getStructuringElement(cv::MORPH_ELLIPSE, {side, side}));
  cv::GaussianBlur(closed, closed, {}, 0.25 * side);
  return closed;
}

/// The connected parts of `weak` with something of `strong` in them that are long.
cv::Mat1b long_parts(const cv::Mat1b& weak, const cv::Mat1b& strong, double shortest_px) {
  cv::Mat1i labels;
  cv::Mat statistics, centers;
  const int count = cv::connectedComponentsWithStats(weak, labels, statistics, centers, 8, CV_32S);
  std::vector<unsigned char> wanted(static_cast<std::size_t>(count), 0);
  for (int y = 0; y < weak.rows; ++y)
    for (int x = 0; x < weak.cols; ++x)
      if (strong(y, x)) wanted[static_cast<std::size_t>(labels(y, x))] = 255;
  for (int i = 0; i < count; ++i) {
    const double diagonal = std::hypot(statistics.at<int>(i, cv::CC_STAT_WIDTH),
                                       statistics.at<int>(i, cv::CC_STAT_HEIGHT));
    if (i == 0 || diagonal < shortest_px) wanted[static_cast<std::size_t>(i)] = 0;
  }
  cv::Mat1b kept(weak.size());
  for (int y = 0; y < weak.rows; ++y)
    for (int x = 0; x < weak.cols; ++x) kept(y, x) = wanted[static_cast<std::size_t>(labels(y, x))];
  return kept;
}

}  // namespace

cv::Mat1f hair_transmittance(const Picture& picture, const PupilEllipse& pupil, double dark,
                             double widest_px) {
  constexpr float kWeak = 0.06f, kStrong = 0.14f;
  const cv::Mat1f image = denoised(picture);
  const cv::Mat1f background = background_of(image, widest_px);
  const cv::Mat1f depth = background - image;
  const float noise = picture.noise;
  cv::Mat1b kept = long_parts(depth > std::max(kWeak, 2 * noise),
                              depth > std::max(kStrong, 4 * noise), 2.5 * widest_px);
  const cv::RotatedRect around(pupil.center, cv::Size2d(2.2 * pupil.a, 2.2 * pupil.b),
                               static_cast<float>(pupil.angle_rad * 180 / CV_PI));
  cv::ellipse(kept, around, cv::Scalar(0), cv::FILLED);
  cv::dilate(kept, kept, cv::getStructuringElement(cv::MORPH_ELLIPSE, {3, 3}));
  cv::Mat1f soft;
  kept.convertTo(soft, CV_32F, 1 / 255.0);
  cv::GaussianBlur(soft, soft, {}, 0.8);
  cv::Mat1f result(image.size(), 1.0f);
  for (int y = 0; y < image.rows; ++y)
    for (int x = 0; x < image.cols; ++x) {
      // A thin hair is blurred by the camera: half of the way to the dark counts as opaque.
      const float full = std::max(0.6f * (background(y, x) - static_cast<float>(dark)), 0.1f);
      const float opacity = std::clamp((depth(y, x) - 0.5f * kWeak) / full, 0.0f, 1.0f);
      result(y, x) = 1 - soft(y, x) * opacity;
    }
  return result;
}

}  // namespace glare::photo
