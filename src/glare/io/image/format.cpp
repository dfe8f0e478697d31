// What is told by the first bytes of a file, and by nothing else: names and extensions lie.
#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>
#include <utility>

#include "glare/io/image/byte_reader.h"
#include "glare/io/image/format.h"
#include "glare/io/image/structure.h"

namespace glare::image_io {

namespace {

constexpr Format kPng{"PNG", "png", checked_png};
constexpr Format kJpeg{"JPEG", "jpeg", checked_jpeg};
constexpr Format kTiff{"TIFF", "tiff", checked_tiff};
constexpr Format kExr{"OpenEXR", "openexr", checked_exr, true};
constexpr Format kPnm{"PNM", "pnm", checked_pnm};
constexpr Format kBmp{"BMP", "bmp", checked_bmp};
constexpr Format kHdr{"Radiance HDR", "hdr", checked_hdr};

bool is_pnm(const Bytes& bytes) {
  if (bytes.size() < 3 || !starts_with(bytes, "P")) return false;
  const std::string_view text = text_of(bytes);
  return std::string_view("123456Ff").find(text[1]) != std::string_view::npos &&
         (std::isspace(static_cast<unsigned char>(text[2])) || text[2] == '#');
}

const Format* format_of(const Bytes& bytes) {
  using std::string_view_literals::operator""sv;
  const std::pair<std::string_view, const Format*> magics[] = {{"\x89PNG\r\n\x1a\n"sv, &kPng},
                                                               {"\xFF\xD8\xFF"sv, &kJpeg},
                                                               {"II*\0"sv, &kTiff},
                                                               {"MM\0*"sv, &kTiff},
                                                               {"II+\0"sv, &kTiff},
                                                               {"MM\0+"sv, &kTiff},
                                                               {"v/1\x01"sv, &kExr},
                                                               {"BM"sv, &kBmp},
                                                               {"#?RADIANCE\n"sv, &kHdr},
                                                               {"#?RGBE\n"sv, &kHdr}};
  for (const auto& [magic, format] : magics) {
    if (starts_with(bytes, magic)) return format;
  }
  return is_pnm(bytes) ? &kPnm : nullptr;
}

bool is_text(const Bytes& bytes) {
  const std::string_view start = text_of(bytes).substr(0, 1024);
  return std::all_of(start.begin(), start.end(), [](unsigned char character) {
    return character >= 32 ? character != 127 : std::isspace(character) != 0;
  });
}

/// What a file is that is none of the formats, for the message; the start of a sentence.
std::string other_kind_of(const Bytes& bytes) {
  using std::string_view_literals::operator""sv;
  if (bytes.empty()) return "the file is empty";
  constexpr std::pair<std::string_view, const char*> magics[] = {
      {"GIF8"sv, "is a GIF"},
      {"%PDF"sv, "is a PDF"},
      {"8BPS"sv, "is a Photoshop file"},
      {"PK\x03\x04"sv, "is a ZIP archive"},
      {"\x1F\x8B"sv, "is gzip-compressed"},
      {"DDS "sv, "is a DDS texture"},
      {"P7\n"sv, "is a PAM picture"},
      {"SDPX"sv, "is a DPX picture"},
      {"XPDS"sv, "is a DPX picture"},
      {"SIMPLE  ="sv, "is a FITS file"},
      {"\0\0\0\x0CjP  "sv, "is a JPEG 2000 picture"},
      {"\xFF\x0A"sv, "is a JPEG XL picture"},
      {"\0\0\0\x0CJXL "sv, "is a JPEG XL picture"},
      {"\x7F"
       "ELF"sv,
       "is a program"}};
  for (const auto& [magic, kind] : magics) {
    if (starts_with(bytes, magic)) return kind;
  }
  const std::string_view text = text_of(bytes);
  if (text.starts_with("RIFF") && text.substr(0, 12).ends_with("WEBP")) return "is a WebP picture";
  if (text.substr(0, 12).find("ftyp") == 4) return "is a HEIF or AVIF picture or a video";
  const std::string_view first = text.substr(0, 512);
  if (first.find("<svg") != std::string_view::npos) return "is an SVG drawing";
  return is_text(bytes) ? "is a text" : "is of an unknown kind";
}

}  // namespace

const Format& recognized_format(const Bytes& bytes) {
  if (const Format* format = format_of(bytes)) return *format;
  throw BadImage(other_kind_of(bytes) +
                 ", not an image that Glare reads (PNG, JPEG, TIFF, OpenEXR, PNM, BMP, HDR)");
}

}  // namespace glare::image_io
