#include "glare/io/picture_document.h"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <utility>

#include "glare/base/error.h"
#include "glare/io/image/format.h"
#include "glare/io/image/loading.h"
#include "glare/io/openexr/plain_picture.h"
#include "glare/io/openexr/stored_picture.h"
#include "glare/io/picture_file.h"
#include "glare/io/radiance/hdr_picture.h"

namespace glare {

using image_io::Bytes;

struct PictureDocument::Content {
  Picture picture;
  bool is_gray = false;
  double pixel_aspect = 1;
  int display_width = 0;  ///< 0: the data are the whole picture.
  std::optional<ToldPixelPitch> pitch;
  std::vector<std::string> warnings;
  // What else there is, of the file's own kind.
  std::optional<openexr_io::StoredPicture> exr;
  std::optional<radiance_io::HdrHeader> hdr;
};

namespace {

using Content = PictureDocument::Content;

Content content_of(openexr_io::ReadPicture read) {
  Content content;
  content.picture = std::move(read.picture);
  content.is_gray = read.stored.color_channels.size() == 1;
  content.pixel_aspect = read.pixel_aspect;
  content.display_width = read.display_width;
  content.pitch = std::move(read.pitch);
  content.warnings = std::move(read.warnings);
  content.exr = std::move(read.stored);
  return content;
}

Content content_of(radiance_io::HdrPicture read) {
  Content content;
  content.pixel_aspect = read.header.pixel_aspect;
  content.pitch = radiance_io::told_pixel_pitch(read.header, read.picture.width());
  content.picture = std::move(read.picture);
  content.hdr = std::move(read.header);
  return content;
}

Content content_of(PictureFile read) {
  Content content;
  content.picture = std::move(read.picture);
  content.warnings = std::move(read.warnings);
  if (read.was_display_encoded)
    content.warnings.emplace_back(
        "it isn't of linear light: its values were decoded by the sRGB curve");
  return content;
}

void require_only_part_and_layer(const PictureDocumentOptions& options) {
  image_io::require(options.part <= 0 && options.layer.empty(),
                    "has no parts and layers; only OpenEXR files have them");
}

Content content_in(Bytes bytes, const std::filesystem::path& path,
                   const PictureDocumentOptions& options) {
  const std::string_view kind = image_io::recognized_format(bytes).reader;
  if (kind == "openexr")
    return content_of(openexr_io::read_stored_picture(std::move(bytes), options));
  require_only_part_and_layer(options);
  if (kind != "hdr") return content_of(read_picture(path, options.max_bytes));
  return content_of(radiance_io::read_hdr_picture(std::move(bytes), options.max_bytes));
}

bool ends_in(const std::filesystem::path& path, std::string_view ending) {
  std::string own = path.extension().string();
  std::ranges::transform(own, own.begin(), [](unsigned char c) { return std::tolower(c); });
  return own == ending;
}

}  // namespace

PictureDocument PictureDocument::read(const std::filesystem::path& path,
                                      const PictureDocumentOptions& options) {
  PictureDocument document;
  document.content_ = image_io::read_with(path, options.max_bytes, [&](Bytes bytes, std::uint64_t) {
    return std::make_shared<const Content>(content_in(std::move(bytes), path, options));
  });
  return document;
}

const Picture& PictureDocument::picture() const { return content_->picture; }
bool PictureDocument::is_gray() const { return content_->is_gray; }
int PictureDocument::display_width() const {
  return content_->display_width > 0 ? content_->display_width : content_->picture.width();
}
double PictureDocument::pixel_aspect() const { return content_->pixel_aspect; }
std::optional<ToldPixelPitch> PictureDocument::pixel_pitch() const { return content_->pitch; }
const std::vector<std::string>& PictureDocument::warnings() const { return content_->warnings; }

std::vector<std::string> PictureDocument::losses(const std::filesystem::path& path) const {
  if (content_->exr && ends_in(path, ".hdr"))
    return {
        "a Radiance picture holds the colours only, in 8 bits and an exponent: other channels, "
        "parts and attributes are left out"};
  if (content_->hdr && ends_in(path, ".exr"))
    return {
        "the lines of the Radiance header are left out, but for the colour space and the "
        "pixels' aspect"};
  return {};
}

std::uint64_t PictureDocument::write(const std::filesystem::path& path, const Picture& changed,
                                     const PictureWriting& options) const {
  const Content& own = *content_;
  if (changed.width() != own.picture.width() || changed.height() != own.picture.height())
    throw OptionError("the changed picture is of another size than the one that was read");
  if (ends_in(path, ".exr")) {
    if (own.exr) return openexr_io::write_stored_picture(path, *own.exr, changed, options);
    openexr_io::write_plain_picture(path, changed, own.pixel_aspect, options);
    return 0;
  }
  if (!ends_in(path, ".hdr"))
    throw OptionError("\"" + path.string() + "\" has an ending other than .exr and .hdr");
  const auto header =
      own.hdr ? *own.hdr : radiance_io::new_hdr_header(own.picture.color_space, own.pixel_aspect);
  if (!own.is_gray)
    return radiance_io::write_hdr_picture(path, header, changed, options.keep_going);
  Picture gray = changed;
  gray.channels[1] = gray.channels[2] = gray.channels[0];
  return radiance_io::write_hdr_picture(path, header, gray, options.keep_going);
}

}  // namespace glare
