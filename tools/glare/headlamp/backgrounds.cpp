#include "headlamp/backgrounds.h"

#include <algorithm>
#include <cmath>

#include "frames.h"
#include "glare/base/error.h"
#include "glare/io/picture_file.h"
#include "glare/io/sha256.h"

namespace glare::tool {

namespace {

namespace fs = std::filesystem;

Picture plain_picture(const SceneBackground& background) {
  const auto [width, height] = background.size_px;
  Picture picture;
  for (Image<float>& channel : picture.channels)
    channel = Image<float>(width, height, static_cast<float>(background.luminance_cd_m2));
  return picture;
}

void scale(Picture& picture, double factor) {
  if (factor == 1) return;
  for (Image<float>& channel : picture.channels)
    for (float& value : channel.values())
      value = static_cast<float>(static_cast<double>(value) * factor);
}

void require_memory(const SceneBackground& background, std::uint64_t limit) {
  const auto pixels = static_cast<std::uint64_t>(background.size_px[0]) *
                      static_cast<std::uint64_t>(background.size_px[1]);
  constexpr std::uint64_t kBytesPerPixel = 3 * sizeof(float);
  if (pixels * kBytesPerPixel > limit) throw MemoryError(pixels * kBytesPerPixel, limit);
}

/// Throws `InputError` where there is no regular file.
void require_file(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) throw InputError(file.string(), "no such file");
}

bool same_matrix(const RgbColorSpace& a, const RgbColorSpace& b) {
  return a.rgb_from_xyz() == b.rgb_from_xyz();
}

}  // namespace

Backgrounds::Backgrounds(const Scene& scene, int frames, std::uint64_t memory_limit_bytes,
                         const Console& console)
    : scene_(scene), memory_limit_bytes_(memory_limit_bytes) {
  const SceneBackground& background = scene.background;
  if (background.is_plain()) {
    require_memory(background, memory_limit_bytes);
    first_ = plain_picture(background);
  } else {
    for (const fs::path& file : files(frames)) require_file(file);
    first_ = read(0, console);
    if (!background.is_sequence()) sha256_ = sha256_of_file(background.file);
  }
  camera_ = {first_.width(), first_.height(), background.horizontal_fov_deg};
}

fs::path Backgrounds::file_of(int frame) const {
  const SceneBackground& background = scene_.background;
  return with_frame(background.file.string(), background.first_frame - 1 + frame);
}

std::vector<fs::path> Backgrounds::files(int frames) const {
  if (scene_.background.is_plain()) return {};
  if (!scene_.background.is_sequence()) return {scene_.background.file};
  std::vector<fs::path> files;
  for (int i = 0; i < frames; ++i) files.push_back(file_of(i));
  return files;
}

Picture Backgrounds::read(int frame, const Console& console) const {
  PictureFile file = read_picture(file_of(frame), memory_limit_bytes_);
  for (const std::string& warning : file.warnings)
    console.warn(file_of(frame).string() + ": " + warning);
  const double usual = file.was_display_encoded ? kDisplayWhite_cd_m2 : 1;
  scale(file.picture, scene_.background.luminance_scale_cd_m2.value_or(usual));
  return std::move(file.picture);
}

void Backgrounds::copy_picture(int frame, Picture& result) const {
  if (!scene_.background.is_sequence()) {
    result = first_;
    return;
  }
  result = read(frame, Console(Verbosity::quiet));  // Their warnings are the first one's.
  if (result.width() != camera_.width || result.height() != camera_.height ||
      !same_matrix(result.color_space, first_.color_space))
    throw InputError(file_of(frame).string(),
                     "expected the size and primaries of " + file_of(0).string());
}

void Backgrounds::require_all(int frames) const {
  if (!scene_.background.is_sequence()) return;
  Picture picture;
  for (int i = 1; i < frames; ++i) copy_picture(i, picture);
}

std::string Backgrounds::sha256(int frame) const {
  if (!scene_.background.is_sequence()) return sha256_;
  return sha256_of_file(file_of(frame));
}

}  // namespace glare::tool
