// The angle from pixel to pixel, as a file tells it.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "support/image_bytes.h"
#include "support/picture_document_fixture.h"

namespace glare::test {
namespace {

constexpr double kRadPerDeg = std::numbers::pi / 180;
constexpr double kFloat = 1e-6;  // A float's digits.

std::string number(const std::string& name, float value) {
  return attribute(name, "float", float_bytes(value));
}

std::string text(const std::string& name, const std::string& value) {
  return attribute(name, "string", value);
}

class CameraAttributesTest : public PictureDocumentTest {
 protected:
  /// Of a picture of 40 pixels across, 2 of them in the data window.
  std::optional<ToldPixelPitch> told(const std::string& attributes) const {
    return document(exr({.x = 3, .full_width = 40, .rows = {1, 2}, .extra = attributes}))
        .pixel_pitch();
  }
  void expect(const std::string& attributes, double pitch_rad, const std::string& source) const {
    const auto pitch = told(attributes);
    ASSERT_TRUE(pitch) << source;
    EXPECT_NEAR(pitch->pitch_rad, pitch_rad, kFloat * pitch_rad);
    EXPECT_EQ(pitch->source, source);
  }
};

const std::string kOwnAngle = text("glare:horizontalFov_deg", "60");
const std::string kPinhole = number("pinholeFocalLength", 50);
const std::string kPitch = number("sensorPhotositePitch", 6);  // Micrometres.

TEST_F(CameraAttributesTest, NothingIsToldByDefault) {
  EXPECT_FALSE(told(""));
  EXPECT_FALSE(told(kPinhole));
  EXPECT_FALSE(told(kPitch));
}

TEST_F(CameraAttributesTest, OwnAttributesComeFirst) {
  expect(number("glare:pixelPitch_deg", 0.02f) + kOwnAngle + kPinhole + kPitch, 0.02 * kRadPerDeg,
         "glare:pixelPitch_deg");
  expect(kOwnAngle + kPinhole + kPitch, 2 * std::tan(30 * kRadPerDeg) / 40,
         "glare:horizontalFov_deg");
}

TEST_F(CameraAttributesTest, LensAndSensor) {
  expect(kPinhole + kPitch, 0.006 / 50, "pinholeFocalLength, sensorPhotositePitch");
  const std::string all = number("nominalFocalLength", 40) + number("effectiveFocalLength", 45);
  expect(all + kPitch, 0.006 / 45, "effectiveFocalLength, sensorPhotositePitch");
  expect(number("nominalFocalLength", 40) + kPitch, 0.006 / 40,
         "nominalFocalLength, sensorPhotositePitch");
  // 400 photosites became 40 pixels.
  const std::string used = attribute("sensorAcquisitionRectangle", "box2i",
                                     little(100, 4) + little(0, 4) + little(499, 4) + little(9, 4));
  expect(kPinhole + kPitch + used, 0.06 / 50,
         "pinholeFocalLength, sensorPhotositePitch, sensorAcquisitionRectangle");
  expect(kPinhole + attribute("sensorOverallDimensions", "v2f", floats({36, 24})), 36.0 / 40 / 50,
         "pinholeFocalLength, sensorOverallDimensions");
}

// Camera: x right, y up, z along the view, moved and turned about y; its picture is 60 degrees
// wide.
TEST_F(CameraAttributesTest, MatricesOfAPerspective) {
  const float c = std::cos(0.3f), s = std::sin(0.3f);
  const float half = std::tan(static_cast<float>(30 * kRadPerDeg));
  const float world_to_camera[4][4] = {{c, 0, s, 0}, {0, 1, 0, 0}, {-s, 0, c, 0}, {1, 2, 3, 1}};
  // u = 0.5 + x / (2 half z), v = 0.5 - y / (2 half z).
  const float k = 1 / (2 * half);
  const float ndc[4][4] = {{k, 0, 0, 0}, {0, -k, 0, 0}, {0.5f, 0.5f, 1, 1}, {0, 0, -0.1f, 0}};
  Values camera, both;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      camera.push_back(world_to_camera[i][j]);
      float sum = 0;
      for (int m = 0; m < 4; ++m) sum += world_to_camera[i][m] * ndc[m][j];
      both.push_back(sum);
    }
  const std::string first = attribute("worldToCamera", "m44f", floats(camera));
  expect(first + attribute("worldToNDC", "m44f", floats(both)), 2 * half / 40,
         "worldToCamera, worldToNDC");
  // Parallel rays: no angle.
  EXPECT_FALSE(told(first + attribute("worldToNDC", "m44f", floats(camera))));
  EXPECT_FALSE(told(first));
}

TEST_F(CameraAttributesTest, ScreenWindow) {
  std::string file = exr({.full_width = 40, .rows = {1, 2}});
  const std::string width = std::string("screenWindowWidth") + '\0' + "float" + '\0';
  file.replace(file.find(width) + width.size() + 4, 4, float_bytes(0.5f));
  const auto pitch = document(file).pixel_pitch();
  ASSERT_TRUE(pitch);
  EXPECT_NEAR(pitch->pitch_rad, 0.5 / 40, kFloat);
  EXPECT_EQ(pitch->source, "screenWindowWidth");
}

TEST_F(CameraAttributesTest, ImplausibleNumbersTellNothing) {
  for (const float bad : {0.0f, -1.0f, std::nanf(""), INFINITY, 1e30f}) {
    EXPECT_FALSE(told(number("glare:pixelPitch_deg", bad))) << bad;
    EXPECT_FALSE(told(number("pinholeFocalLength", bad) + kPitch)) << bad;
    EXPECT_FALSE(told(kPinhole + number("sensorPhotositePitch", bad))) << bad;
  }
  for (const char* bad : {"", "x", "0", "-5", "180", "1e400"})
    EXPECT_FALSE(told(text("glare:horizontalFov_deg", bad))) << bad;
}

}  // namespace
}  // namespace glare::test
