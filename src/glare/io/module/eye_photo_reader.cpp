// The module glare_eye_photo: pupil, iris and hairs in a photograph, with OpenCV.
#include "glare/io/module/eye_photo_reader.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <new>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "glare/io/photo/eye_finder.h"
#include "glare/io/photo/hairs.h"
#include "glare/io/photo/outline.h"

namespace glare::module {

namespace {

/// A larger photograph is analysed at this size.
constexpr double kLargestSide_px = 1280;
/// A lash's root is up to about 0.15 mm wide, and an iris 11.8 mm; with room for two side by side.
constexpr double kWidestHair_of_iris = 0.3 / 11.8;
/// Where no limbus is seen: the usual pupil is a third of the iris.
constexpr double kUsualIris_of_pupil = 3;

/// Between the photograph's pixels and those of the analysis.
struct Scale {
  double factor;
  double to_photo(double place) const { return factor * (place + 0.5) - 0.5; }
  double from_photo(double place) const { return (place + 0.5) / factor - 0.5; }
};

cv::Mat1f analysed_picture(const EyePhotograph& photograph, const Scale& scale) {
  const cv::Mat1f whole(photograph.height, photograph.width, const_cast<float*>(photograph.grey));
  if (scale.factor == 1) return whole.clone();
  cv::Mat1f small;
  cv::resize(whole, small,
             {static_cast<int>(std::lround(whole.cols / scale.factor)),
              static_cast<int>(std::lround(whole.rows / scale.factor))},
             0, 0, cv::INTER_AREA);
  return small;
}

void set_pupil(FoundEye& eye, const photo::SeenPupil& pupil, const Scale& scale) {
  eye.center_x = scale.to_photo(pupil.ellipse.center.x);
  eye.center_y = scale.to_photo(pupil.ellipse.center.y);
  eye.semi_major = scale.factor * pupil.ellipse.a;
  eye.semi_minor = scale.factor * pupil.ellipse.b;
  eye.angle_rad = pupil.ellipse.angle_rad;
  eye.confidence = pupil.confidence;
}

void set_outline(FoundEye& eye, const photo::Picture& picture, const photo::SeenPupil& pupil,
                 const Scale& scale) {
  static_assert(FoundEye::kOutlinePoints == photo::kEdgePoints);
  const auto ratios =
      photo::pupil_outline(picture, pupil.ellipse, pupil.evidence.inside, pupil.evidence.contrast);
  for (int k = 0; k < photo::kEdgePoints; ++k) {
    const double direction = 2 * CV_PI * k / photo::kEdgePoints;
    const cv::Point2d center = pupil.ellipse.center;
    const cv::Point2d at =
        center + ratios[static_cast<std::size_t>(k)] * (pupil.ellipse.point_at(direction) - center);
    eye.outline_x[k] = scale.to_photo(at.x);
    eye.outline_y[k] = scale.to_photo(at.y);
  }
}

void set_iris(FoundEye& eye, const photo::SeenPupil& pupil, const Scale& scale) {
  const auto& limbus = pupil.evidence.limbus;
  if (!limbus) return;
  eye.iris_x = scale.to_photo(limbus->center.x);
  eye.iris_y = scale.to_photo(limbus->center.y);
  eye.iris_radius = scale.factor * limbus->radius;
  eye.iris_confidence = photo::limbus_confidence(pupil.evidence, pupil.ellipse);
}

void set_hairs(float* hairs, const EyePhotograph& photograph, const photo::Picture& picture,
               const photo::SeenPupil& pupil) {
  const auto& limbus = pupil.evidence.limbus;
  const double iris =
      limbus ? 2 * limbus->radius : 2 * kUsualIris_of_pupil * pupil.ellipse.mean_radius();
  const cv::Mat1f found = photo::hair_transmittance(picture, pupil.ellipse, pupil.evidence.inside,
                                                    std::max(3.0, kWidestHair_of_iris * iris));
  cv::Mat1f whole(photograph.height, photograph.width, hairs);
  cv::resize(found, whole, whole.size(), 0, 0, cv::INTER_LINEAR);
}

PhotoOutcome find_eye(const EyePhotograph& photograph, FoundEye& eye, float* hairs,
                      Message& message) {
  cv::setNumThreads(1);  // The same on every machine.
  const Scale scale = {
      std::max(1.0, std::max(photograph.width, photograph.height) / kLargestSide_px)};
  const photo::Picture picture = photo::prepared(analysed_picture(photograph, scale));
  std::optional<cv::Point2d> pupil_at;
  if (photograph.has_pupil_at)
    pupil_at = {scale.from_photo(photograph.pupil_at_x), scale.from_photo(photograph.pupil_at_y)};
  const auto pupil = photo::likeliest_pupil(picture, pupil_at);
  if (!pupil || pupil->confidence < photo::kLeastConfidence) {
    char text[160];
    std::snprintf(text, sizeof text,
                  "no pupil was found%s; the likeliest place is %.2f sure, %.2f is expected",
                  pupil_at ? " around that place" : "", pupil ? pupil->confidence : 0.0,
                  photo::kLeastConfidence);
    message.set(text);
    return PhotoOutcome::no_pupil;
  }
  eye = {};
  set_pupil(eye, *pupil, scale);
  set_outline(eye, picture, *pupil, scale);
  set_iris(eye, *pupil, scale);
  set_hairs(hairs, photograph, picture, *pupil);
  return PhotoOutcome::found;
}

PhotoOutcome find(const EyePhotograph& photograph, FoundEye& eye, float* hairs,
                  Message& message) noexcept try {
  return find_eye(photograph, eye, hairs, message);
} catch (const std::bad_alloc&) {
  return PhotoOutcome::no_memory;
} catch (const cv::Exception& error) {
  message.set(error.err);
  return error.code == cv::Error::StsNoMem ? PhotoOutcome::no_memory : PhotoOutcome::failed;
} catch (const std::exception& error) {
  message.set(error.what());
  return PhotoOutcome::failed;
} catch (...) {
  message.set("OpenCV fails");
  return PhotoOutcome::failed;
}

}  // namespace

}  // namespace glare::module

const glare::module::EyePhotoReader glare_eye_photo = {GLARE_VERSION, glare::module::find};
