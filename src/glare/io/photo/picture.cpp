#include "glare/io/photo/picture.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <opencv2/photo.hpp>

namespace glare::photo {

namespace {

/// One pixel in this many, at least, is darker than 0, and as many are brighter than 1.
constexpr double kTail = 0.004;
/// Two grey values of an 8-bit picture: less contrast is none.
constexpr float kLeastContrast = 6.0f / 255;

std::vector<float> values_of(const cv::Mat1f& image) {
  std::vector<float> values;
  values.reserve(image.total());
  for (int y = 0; y < image.rows; ++y) values.insert(values.end(), image[y], image[y] + image.cols);
  return values;
}

cv::Mat1f stretched(const cv::Mat1f& grey) {
  cv::Mat1f calm;
  cv::medianBlur(grey, calm, 5);
  std::vector<float> values = values_of(calm);
  const float low = quantile(values, kTail), high = quantile(values, 1 - kTail);
  if (!(high - low >= kLeastContrast)) return cv::Mat1f::zeros(grey.size());
  cv::Mat1f result = (grey - low) / (high - low);
  return cv::min(cv::max(result, -0.2), 1.5);
}

/// After J. Immerkaer, Fast noise variance estimation, 1996, with the median in place of the mean.
float noise_of(const cv::Mat1f& image) {
  const cv::Mat1f kernel = (cv::Mat1f(3, 3) << 1, -2, 1, -2, 4, -2, 1, -2, 1);
  cv::Mat1f difference;
  cv::filter2D(image, difference, CV_32F, kernel);
  std::vector<float> values = values_of(cv::abs(difference));
  return quantile(values, 0.5) / 0.6745f / 6;
}

cv::Mat ellipse_of(double radius) {
  const int side = 2 * std::max(1, static_cast<int>(std::lround(radius))) + 1;
  return cv::getStructuringElement(cv::MORPH_ELLIPSE, {side, side});
}

/// Leaves the compact parts only, which a lamp's image in the cornea is, and no strip of skin.
cv::Mat1b compact_parts(const cv::Mat1b& found) {
  cv::Mat1i labels;
  cv::Mat statistics, centers;
  const int count = cv::connectedComponentsWithStats(found, labels, statistics, centers, 8, CV_32S);
  std::vector<unsigned char> compact(static_cast<std::size_t>(count), 0);
  for (int i = 1; i < count; ++i) {
    const double width = statistics.at<int>(i, cv::CC_STAT_WIDTH);
    const double height = statistics.at<int>(i, cv::CC_STAT_HEIGHT);
    const double area = statistics.at<int>(i, cv::CC_STAT_AREA);
    if (area > 0.55 * width * height && std::max(width, height) < 1.8 * std::min(width, height))
      compact[static_cast<std::size_t>(i)] = 255;
  }
  cv::Mat1b kept(found.size());
  for (int y = 0; y < found.rows; ++y)
    for (int x = 0; x < found.cols; ++x)
      kept(y, x) = compact[static_cast<std::size_t>(labels(y, x))];
  return kept;
}

/// Small and much brighter than what is around, or larger and compact.
cv::Mat1b glints_of(const cv::Mat1f& image, double unit) {
  cv::Mat1f small, large;
  cv::morphologyEx(image, small, cv::MORPH_TOPHAT, ellipse_of(8 * unit));
  cv::morphologyEx(image, large, cv::MORPH_TOPHAT, ellipse_of(18 * unit));
  const cv::Mat1b found = (small > 0.22f) | compact_parts(large > 0.35f);
  cv::Mat1b wide;
  cv::dilate(found, wide, ellipse_of(1.5 * unit));
  return wide;
}

cv::Mat1f without(const cv::Mat1f& image, const cv::Mat1b& glints, double unit) {
  cv::Mat1b bytes;
  cv::Mat(cv::min(cv::max(image, 0), 1) * 255).convertTo(bytes, CV_8U);
  cv::Mat1b filled;
  cv::inpaint(bytes, glints, filled, 2 * unit, cv::INPAINT_TELEA);
  cv::Mat1f values, result = image.clone();
  filled.convertTo(values, CV_32F, 1 / 255.0);
  values.copyTo(result, glints);
  return result;
}

}  // namespace

double PupilEllipse::mean_radius() const { return std::sqrt(a * b); }

double PupilEllipse::radius_at(double direction_rad) const {
  const double c = std::cos(direction_rad - angle_rad), s = std::sin(direction_rad - angle_rad);
  return a * b / std::hypot(b * c, a * s);
}

cv::Point2d PupilEllipse::point_at(double direction_rad) const {
  const double r = radius_at(direction_rad);
  return center + r * cv::Point2d(std::cos(direction_rad), std::sin(direction_rad));
}

float sample(const cv::Mat1f& image, double x, double y) {
  if (!(x >= 0 && y >= 0 && x <= image.cols - 1 && y <= image.rows - 1)) return -1;
  const int x0 = std::min(static_cast<int>(x), image.cols - 2);
  const int y0 = std::min(static_cast<int>(y), image.rows - 2);
  const auto u = static_cast<float>(x - x0), v = static_cast<float>(y - y0);
  const float* const top = image[y0] + x0;
  const float* const bottom = image[y0 + 1] + x0;
  const float value =
      (1 - v) * ((1 - u) * top[0] + u * top[1]) + v * ((1 - u) * bottom[0] + u * bottom[1]);
  return std::max(value, 0.0f);
}

float quantile(std::vector<float>& values, double share) {
  if (values.empty()) return 0;
  const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + place, values.end());
  return values[static_cast<std::size_t>(place)];
}

Picture prepared(const cv::Mat1f& grey) {
  const double unit = std::max(grey.cols, grey.rows) / 320.0;
  Picture picture;
  picture.raw = stretched(grey);
  cv::Mat1f calm;
  cv::medianBlur(picture.raw, calm, 3);
  cv::GaussianBlur(calm, calm, {}, std::max(0.8, 0.6 * unit));
  picture.glints = glints_of(calm, unit);
  picture.smooth = without(calm, picture.glints, unit);
  picture.noise = std::max(0.008f, 2 * noise_of(picture.smooth));
  return picture;
}

Picture reduced(const Picture& picture, double factor) {
  if (factor <= 1) return picture;
  Picture small;
  const cv::Size size(static_cast<int>(std::lround(picture.width() / factor)),
                      static_cast<int>(std::lround(picture.height() / factor)));
  cv::resize(picture.raw, small.raw, size, 0, 0, cv::INTER_AREA);
  cv::resize(picture.smooth, small.smooth, size, 0, 0, cv::INTER_AREA);
  cv::resize(picture.glints, small.glints, size, 0, 0, cv::INTER_NEAREST);
  small.noise = picture.noise;
  return small;
}

}  // namespace glare::photo
