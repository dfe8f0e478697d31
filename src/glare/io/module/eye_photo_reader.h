// What the module glare_eye_photo does, as the library sees it: C types, and nothing is thrown
// across. Internal.
#pragma once

#include "glare/io/module/message.h"

namespace glare::module {

enum class PhotoOutcome : int { found, no_pupil, no_memory, failed };

/// A photograph's grey values, row by row, and what a person knows of it.
struct EyePhotograph {
  int width, height;
  const float* grey;
  bool has_pupil_at;
  double pupil_at_x, pupil_at_y;  ///< A pixel within the pupil.
};

/// Lengths and places in pixels of the photograph, whose centres are at whole numbers.
struct FoundEye {
  static constexpr int kOutlinePoints = 360;
  double center_x, center_y;
  double semi_major, semi_minor, angle_rad;  ///< From the x axis to the major one, towards y.
  double confidence;                         ///< 0 to 1.
  double outline_x[kOutlinePoints], outline_y[kOutlinePoints];
  double iris_x, iris_y, iris_radius, iris_confidence;  ///< The radius is 0 where there is none.
};

/// `hairs` has room for width x height transmittances. `message` says what is wrong unless the eye
/// is found.
struct EyePhotoReader {
  const char* glare_version;  ///< First in every version, to be compared before anything is called.
  PhotoOutcome (*find)(const EyePhotograph& photograph, FoundEye& eye, float* hairs,
                       Message& message) noexcept;
};

}  // namespace glare::module

extern "C" __attribute__((visibility("default")))
const glare::module::EyePhotoReader glare_eye_photo;
