#include "glare/io/openexr/part_header.h"

#include <map>
#include <set>
#include <string>

namespace glare::openexr_io {

using image_io::kMaxSide;
using image_io::Reader;
using image_io::require;
using std::uint32_t;
using std::uint64_t;
using Bytes = std::span<const std::byte>;

namespace {

constexpr uint32_t kTiles = 0x200, kLongNames = 0x400, kDeep = 0x800, kParts = 0x1000;
constexpr uint64_t kMostParts = 4096, kMostChannels = 4096;

/// How long the values of types of one length are: OpenEXR reads as much, whatever the file says.
void require_length_of_type(const std::string& type, uint64_t length) {
  static const std::map<std::string, uint64_t> lengths = {
      {"box2f", 16},      {"box2i", 16},   {"chromaticities", 32},
      {"compression", 1}, {"double", 8},   {"envmap", 1},
      {"float", 4},       {"int", 4},      {"keycode", 28},
      {"lineOrder", 1},   {"m33d", 72},    {"m33f", 36},
      {"m44d", 128},      {"m44f", 64},    {"rational", 8},
      {"tiledesc", 9},    {"timecode", 8}, {"v2d", 16},
      {"v2f", 8},         {"v2i", 8},      {"v3d", 24},
      {"v3f", 12},        {"v3i", 12},     {"deepImageState", 1}};
  const auto known = lengths.find(type);
  require(known == lengths.end() || known->second == length, "an attribute has the wrong length");
}

void require_preview(Reader content) {
  const uint64_t width = content.u32(), height = content.u32();
  require(width <= kMaxSide && height <= kMaxSide && content.left() == width * height * 4,
          "the preview is damaged");
}

/// A compressed table of names, which starts with its size.
void require_manifest(Reader content) {
  require(content.number(8) <= content.left() * image_io::kDeflateRatio,
          "the manifest of identities is damaged");
}

void note_channels(Reader content, PartHeader& part) {
  for (std::string name = content.text_z(); !name.empty(); name = content.text_z()) {
    PartHeader::Channel channel;
    channel.name = name;
    channel.type = content.u32();
    require(channel.type <= 2, "has a channel of an unknown type");
    channel.bytes = channel.type == 1 ? 2 : 4;
    content.skip(4);
    channel.x_sampling = content.i32();
    channel.y_sampling = content.i32();
    constexpr auto most = static_cast<std::int64_t>(kMaxSide);
    require(channel.x_sampling >= 1 && channel.y_sampling >= 1 && channel.x_sampling <= most &&
                channel.y_sampling <= most,
            "has a channel of an absurd sampling");
    part.channels.push_back(channel);
    require(part.channels.size() <= kMostChannels, "has more channels than are read");
  }
  require(!part.channels.empty(), "has no channels");
}

void note_data_window(Reader content, PartHeader& part) {
  part.x_min = content.i32();
  part.y_min = content.i32();
  const auto x_max = content.i32(), y_max = content.i32();
  constexpr auto most = static_cast<std::int64_t>(kMaxSide);
  require(part.x_min <= x_max && part.y_min <= y_max, "has an empty data window");
  require(x_max - part.x_min < most && y_max - part.y_min < most,
          "has a data window of an absurd size");
  part.width = static_cast<uint64_t>(x_max - part.x_min + 1);
  part.height = static_cast<uint64_t>(y_max - part.y_min + 1);
}

void note_tiles(Reader content, PartHeader& part) {
  part.tiles.width = content.u32();
  part.tiles.height = content.u32();
  image_io::require_sides(part.tiles.width, part.tiles.height);
  const unsigned mode = content.u8();
  require((mode & 15) <= 2 && (mode >> 4) <= 1, "has tiles of an unknown kind");
  part.tiles.levels = static_cast<decltype(part.tiles.levels)>(mode & 15);
  part.tiles.round_up = (mode >> 4) == 1;
}

void note_type(Bytes value, PartHeader& part) {
  const std::string_view type = image_io::text_of(value);
  part.has_type = true;
  part.deep = type.starts_with("deep");
  part.tiled = type == "tiledimage" || type == "deeptile";
  require(part.tiled || type == "scanlineimage" || type == "deepscanline",
          "has a part of an unknown type");
}

void note_attribute(const std::string& name, const std::string& type, Bytes value,
                    PartHeader& part) {
  const Reader content(value);
  require_length_of_type(type, value.size());
  if (type == "preview") require_preview(content);
  if (type == "idmanifest") require_manifest(content);
  using Note = void (*)(Reader, PartHeader&);
  struct Known {
    const char* type;
    Note note;
  };
  static const std::map<std::string, Known> known_names = {
      {"channels", {"chlist", note_channels}},
      {"compression", {"compression", [](Reader r, PartHeader& p) { p.compression = r.u8(); }}},
      {"dataWindow", {"box2i", note_data_window}},
      {"displayWindow", {"box2i", [](Reader, PartHeader&) {}}},
      {"lineOrder", {"lineOrder", [](Reader, PartHeader&) {}}},
      {"pixelAspectRatio", {"float", [](Reader, PartHeader&) {}}},
      {"tiles", {"tiledesc", note_tiles}},
      {"chunkCount", {"int", [](Reader r, PartHeader& p) { p.chunk_count = r.u32(); }}}};
  if (name == "type" && type == "string") note_type(value, part);
  const auto known = known_names.find(name);
  if (known == known_names.end()) return;
  require(type == known->second.type, "an attribute has the wrong type");
  known->second.note(content, part);
}

PartHeader part_header(Reader& reader) {
  PartHeader part;
  std::set<std::string> names;
  for (std::string name = reader.text_z(); !name.empty(); name = reader.text_z()) {
    const std::string type = reader.text_z();
    const Bytes value = reader.take(reader.u32());
    require(names.insert(name).second, "has an attribute twice");
    note_attribute(name, type, value, part);
  }
  for (const char* name : {"channels", "compression", "dataWindow", "displayWindow", "lineOrder"})
    require(names.contains(name), "the header is incomplete");
  require(!part.deep || names.contains("version"), "the header of a deep part is incomplete");
  return part;
}

/// What the version says where the part doesn't; both must say the same of the only part.
void note_version(uint32_t version, PartHeader& part) {
  const bool deep = (version & kDeep) != 0;
  if (!part.has_type) {
    part.tiled = (version & kTiles) != 0 || (deep && part.tiles.width > 0);
    part.deep = deep;
  }
  require((version & kParts) != 0 ||
              (part.deep == deep && (deep || part.tiled == ((version & kTiles) != 0))),
          "the header is damaged");
  require(!part.tiled || part.tiles.width > 0, "has no size of tiles");
}

}  // namespace

uint64_t PartHeader::pixel_bytes() const {
  uint64_t bytes = 0;
  for (const Channel& channel : channels) bytes += channel.bytes;
  return bytes;
}

FileHeaders part_headers(Reader& reader) {
  require(reader.left() >= 8 && reader.u32() == 20000630, "is not an OpenEXR file");
  const uint32_t version = reader.u32();
  require((version & 0xFF) == 2, "is of an unknown version of OpenEXR");
  require((version & ~(0xFFu | kTiles | kLongNames | kDeep | kParts)) == 0,
          "the header is damaged");
  FileHeaders headers;
  headers.multi_part = (version & kParts) != 0;
  do {
    headers.parts.push_back(part_header(reader));
    note_version(version, headers.parts.back());
    require(headers.parts.size() <= kMostParts, "has more parts than are read");
    if (!headers.multi_part) return headers;
    Reader next = reader;
    if (next.u8() == 0) break;
  } while (true);
  reader.skip(1);
  return headers;
}

}  // namespace glare::openexr_io
