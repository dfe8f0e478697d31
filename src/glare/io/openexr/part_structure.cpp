#include "glare/io/openexr/part_structure.h"

#include <algorithm>
#include <bit>
#include <string>
#include <vector>

#include "glare/base/parallel.h"
#include "glare/io/openexr/blocks.h"
#include "glare/io/openexr/dwa_block.h"
#include "glare/io/openexr/inflated.h"
#include "glare/io/openexr/part_header.h"

namespace glare::openexr_io {

using image_io::BadImage;
using image_io::divided_up;
using image_io::Reader;
using image_io::require;
using std::int64_t;
using std::uint32_t;
using std::uint64_t;

namespace {

/// How many whole numbers from `first` on, `count` in all, are multiples of `step`.
uint64_t multiples(int64_t first, uint64_t count, int64_t step) {
  const auto up_to = [&](int64_t end) {  // Below `end`, and not below 0 or a multiple under first.
    const int64_t base = first - ((first % step) + step) % step;
    return (end - base + step - 1) / step;
  };
  return static_cast<uint64_t>(up_to(first + static_cast<int64_t>(count)) - up_to(first));
}

/// Pixels, in the file's coordinates as far as subsampled channels go by them.
struct Area {
  int64_t x = 0, y = 0;
  uint64_t width = 0, height = 0;

  uint64_t columns(const PartHeader::Channel& c) const { return multiples(x, width, c.x_sampling); }
  uint64_t rows(const PartHeader::Channel& c) const { return multiples(y, height, c.y_sampling); }
  uint64_t bytes(const PartHeader& part) const {
    uint64_t sum = 0;
    for (const PartHeader::Channel& c : part.channels) sum += c.bytes * columns(c) * rows(c);
    return sum;
  }
};

struct BlockContent {
  std::span<const std::byte> data;
  Area area;
};

/// Deep scan lines are compressed one by one, but for ZIP's blocks.
uint64_t deep_rows(unsigned compression) { return compression == 3 ? 16 : 1; }

/// Walks through the tables of all parts, in the file's order, and through the blocks they name.
class Walk {
 public:
  Walk(std::span<const std::byte> file, Reader tables, bool multi_part)
      : file_(file), tables_(tables), multi_part_(multi_part) {}

  void through(const PartHeader& part) {
    block_contents_.clear();
    require(part.compression <= 9, "is compressed in an unknown way");
    if (part.tiled)
      through_tiles(part);
    else
      through_rows(part);
    require(part.chunk_count == 0 ? !multi_part_ && !part.deep : part.chunk_count == blocks_,
            "the header is damaged");
    ++part_;
  }
  /// Of the part that was walked through last.
  uint64_t blocks() const { return blocks_; }
  const std::vector<BlockContent>& block_contents() const { return block_contents_; }

 private:
  void through_rows(const PartHeader& part) {
    const uint64_t rows =
        part.deep ? deep_rows(part.compression) : block_kind(part.compression).rows;
    blocks_ = divided_up(part.height, rows);
    require_table();
    for (uint64_t row = 0; row < part.height; row += rows) {
      Reader block = next_block();
      const int64_t y = part.y_min + static_cast<int64_t>(row);
      require(block.i32() == y, "a block of scan lines is damaged");
      if (part.deep)
        skip_deep(block);
      else
        note_block(part, block.take(block.u32()),
                   {part.x_min, y, part.width, std::min(rows, part.height - row)});
    }
  }

  /// Checks a block's size now; its content, if it is of a part to be decoded, later.
  void note_block(const PartHeader& part, std::span<const std::byte> data, const Area& area) {
    require_whole_block(data, area.bytes(part), part.compression);
    block_contents_.push_back({data, area});
  }

  static uint64_t level_count(uint64_t size, bool round_up) {
    const auto floor_log2 = static_cast<uint64_t>(std::bit_width(size) - 1);
    return floor_log2 + (round_up && !std::has_single_bit(size) ? 2 : 1);
  }

  static uint64_t level_size(uint64_t size, uint64_t level, bool round_up) {
    const uint64_t step = uint64_t{1} << level;
    return std::max<uint64_t>(round_up ? divided_up(size, step) : size / step, 1);
  }

  void through_tiles(const PartHeader& part) {
    const PartHeader::Tiles& tiles = part.tiles;
    for (const PartHeader::Channel& c : part.channels)
      require(c.x_sampling == 1 && c.y_sampling == 1, "has tiles of subsampled channels");
    blocks_ = 0;
    const uint64_t larger = std::max(part.width, part.height);
    if (tiles.levels == PartHeader::Tiles::ripmap) {
      for (uint64_t ly = 0; ly < level_count(part.height, tiles.round_up); ++ly)
        for (uint64_t lx = 0; lx < level_count(part.width, tiles.round_up); ++lx)
          through_level(part, lx, ly);
    } else {
      const bool one = tiles.levels == PartHeader::Tiles::one_level;
      for (uint64_t l = 0; l < (one ? 1 : level_count(larger, tiles.round_up)); ++l)
        through_level(part, l, l);
    }
  }

  void through_level(const PartHeader& part, uint64_t lx, uint64_t ly) {
    const PartHeader::Tiles& tiles = part.tiles;
    const uint64_t width = level_size(part.width, lx, tiles.round_up);
    const uint64_t height = level_size(part.height, ly, tiles.round_up);
    for (uint64_t y = 0; y * tiles.height < height; ++y)
      for (uint64_t x = 0; x * tiles.width < width; ++x) {
        Reader block = next_block();
        for (const uint64_t number : {x, y, lx, ly})
          require(block.u32() == number, "a tile is damaged");
        if (part.deep)
          skip_deep(block);
        else
          note_block(part, block.take(block.u32()),
                     {0, 0, std::min(tiles.width, width - x * tiles.width),
                      std::min(tiles.height, height - y * tiles.height)});
        ++blocks_;
      }
  }

  void require_table() const { require(blocks_ * 8 <= tables_.left(), "the file is cut short"); }

  Reader next_block() {
    Reader block(file_);
    block.seek(tables_.number(8));
    if (multi_part_) require(block.u32() == part_, "a block belongs to another part");
    return block;
  }

  /// Deep data, of a part that is only copied.
  static void skip_deep(Reader& block) {
    const uint64_t table = block.number(8), data = block.number(8);
    block.skip(8);
    block.skip(table);
    block.skip(data);
  }

  std::span<const std::byte> file_;
  Reader tables_;
  bool multi_part_;
  uint64_t part_ = 0;
  uint64_t blocks_ = 0;
  std::vector<BlockContent> block_contents_;
};

/// Requires that the compressed data make all of the pixels, where OpenEXR doesn't.
void require_all_pixels(const PartHeader& part, const BlockContent& block) {
  constexpr unsigned zips = 2, zip = 3, dwaa = 8, dwab = 9;
  const uint64_t bytes = block.area.bytes(part);
  if (block.data.size() == bytes) return;  // Not compressed.
  if (part.compression == zips || part.compression == zip) require_inflates_to(block.data, bytes);
  if (part.compression != dwaa && part.compression != dwab) return;
  std::vector<DwaChannel> channels;
  for (const PartHeader::Channel& c : part.channels)
    channels.push_back({c.name, c.type, block.area.columns(c), block.area.rows(c)});
  require_whole_dwa_block(block.data, channels);
}

void require_all_pixels(const PartHeader& part, const std::vector<BlockContent>& blocks,
                        int threads) {
  parallel_for(static_cast<int>(blocks.size()), threads,
               [&](int i) { require_all_pixels(part, blocks[static_cast<std::size_t>(i)]); });
}

/// Before any table is walked through: the blocks' own headers must have room.
void require_room(const PartHeader& part, uint64_t file_bytes) {
  if (part.deep) return;
  const uint64_t ratio = block_kind(part.compression).ratio;
  uint64_t bytes = 0;
  for (const PartHeader::Channel& c : part.channels)
    bytes += c.bytes * (part.width / static_cast<uint64_t>(c.x_sampling)) *
             (part.height / static_cast<uint64_t>(c.y_sampling));
  require(bytes / ratio <= file_bytes, "has too little data for its size");
}

uint64_t decoder_bytes(const PartHeader& part, uint64_t blocks, uint64_t threads) {
  const uint64_t rows = part.deep ? deep_rows(part.compression) : block_kind(part.compression).rows;
  const uint64_t pixels =
      part.tiled ? part.tiles.width * part.tiles.height : part.width * std::min(rows, part.height);
  // OpenEXR has two blocks for each thread: as stored, decompressed, and in between. Of deep
  // pixels, which are only copied, it has their numbers of samples.
  const uint64_t buffers = part.tiled ? 2 * threads : std::min(2 * threads, blocks);
  return 4 * buffers * pixels * (part.deep ? sizeof(uint32_t) : part.pixel_bytes());
}

}  // namespace

PartStructure checked_parts(std::span<const std::byte> file, int part, int threads) {
  Reader reader(file);
  const FileHeaders headers = part_headers(reader);
  const auto chosen = static_cast<std::size_t>(part);
  const std::size_t count = headers.parts.size();
  if (chosen >= count)
    throw BadImage("has no part " + std::to_string(part) + "; it has " + std::to_string(count) +
                   ", counted from 0");
  require(!headers.parts[chosen].deep, "holds deep pixels; plain ones were expected");
  Walk walk(file, reader, headers.multi_part);
  PartStructure structure;
  for (const PartHeader& header : headers.parts) {
    require_room(header, file.size());
    walk.through(header);
    structure.decoder_bytes =
        std::max(structure.decoder_bytes,
                 decoder_bytes(header, walk.blocks(), static_cast<uint64_t>(threads)));
    if (&header != &headers.parts[chosen]) continue;
    require_all_pixels(header, walk.block_contents(), threads);
    structure.pixels = header.width * header.height;
  }
  return structure;
}

bool has_type_attribute(std::span<const std::byte> file) {
  Reader reader(file);
  return part_headers(reader).parts[0].has_type;
}

}  // namespace glare::openexr_io
