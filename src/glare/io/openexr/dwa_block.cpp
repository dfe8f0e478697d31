#include "glare/io/openexr/dwa_block.h"

#include <algorithm>
#include <cctype>
#include <limits>

#include "glare/io/image/byte_reader.h"
#include "glare/io/openexr/inflated.h"

// OpenEXR's Huffman decoder. Versions that don't have it for others any more (3.3 and later) decode
// in OpenEXRCore, which looks for the coefficients' end itself.
#if __has_include(<OpenEXR/ImfHuf.h>)
#include <OpenEXR/ImfHuf.h>
#define GLARE_HAS_HUF 1
#else
#define GLARE_HAS_HUF 0
#endif

namespace glare::openexr_io {

using image_io::Reader;
using std::uint64_t;
using Bytes = std::span<const std::byte>;

namespace {

enum Scheme : unsigned { deflated, cosines, runs };

/// How the channels are stored whose names end in this, of this type.
struct Rule {
  std::string own_name;
  Scheme scheme = deflated;
  bool any_case = false;
  unsigned type = 0;
};

/// What a block's header says, in its order.
struct Sizes {
  uint64_t version, deflated_bytes, deflated_stored, cosines_stored, means_stored, runs_stored;
  uint64_t runs_inflated, runs_bytes, cosines_count, means_count, cosines_kind;
};

void require(bool condition) { image_io::require(condition, "a block of pixels is damaged"); }

Sizes sizes_of(Reader& reader) {
  Sizes s{};
  for (uint64_t* const size : {&s.version, &s.deflated_bytes, &s.deflated_stored, &s.cosines_stored,
                               &s.means_stored, &s.runs_stored, &s.runs_inflated, &s.runs_bytes,
                               &s.cosines_count, &s.means_count, &s.cosines_kind}) {
    *size = reader.number(8);
    require(*size < uint64_t{1} << 40);
  }
  image_io::require(s.version == 2, "has DWA blocks of an unknown version");
  return s;
}

std::vector<Rule> rules_in(Reader& reader) {
  const unsigned size = reader.u16();
  require(size >= 2);
  Reader content(reader.take(size - 2));
  std::vector<Rule> rules;
  while (content.left() > 0) {
    Rule rule;
    rule.own_name = content.text_z();
    const unsigned bits = content.u8();
    require((bits >> 2 & 3) <= runs);
    rule.scheme = static_cast<Scheme>(bits >> 2 & 3);
    rule.any_case = (bits & 1) != 0;
    rule.type = content.u8();
    rules.push_back(rule);
  }
  return rules;
}

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

bool holds(const Rule& rule, const DwaChannel& channel) {
  const std::string own = channel.name.substr(channel.name.rfind('.') + 1);
  return rule.type == channel.type &&
         (rule.any_case ? lower(own) == lower(rule.own_name) : own == rule.own_name);
}

/// The last rule that holds counts.
Scheme scheme_of(const std::vector<Rule>& rules, const DwaChannel& channel) {
  Scheme scheme = deflated;
  for (const Rule& rule : rules)
    if (holds(rule, channel)) scheme = rule.scheme;
  return scheme;
}

#if GLARE_HAS_HUF
/// The coefficients of the cosines that aren't means, with runs of zeros.
std::vector<unsigned short> unpacked_cosines(Bytes stored, const Sizes& sizes) {
  std::vector<unsigned short> values(static_cast<std::size_t>(sizes.cosines_count));
  require(stored.size() <= std::numeric_limits<int>::max());
  if (sizes.cosines_kind == 0)
    Imf::hufUncompress(reinterpret_cast<const char*>(stored.data()),
                       static_cast<int>(stored.size()), values.data(),
                       static_cast<int>(values.size()));
  else
    inflate_to(stored, std::as_writable_bytes(std::span(values)));
  return values;
}

/// Requires that there are enough for so many blocks of 8 x 8 pixels: for each 63 numbers, or runs
/// of zeros, of which the run 0 goes to the end of its block.
void require_cosines_of(uint64_t blocks, const std::vector<unsigned short>& values) {
  std::size_t at = 0;
  for (uint64_t block = 0; block < blocks; ++block)
    for (unsigned place = 1; place < 64;) {
      require(at < values.size());
      const unsigned value = values[at++];
      const unsigned run = (value >> 8) == 0xFF ? value & 0xFF : 1;
      place += run == 0 ? 64 : run;
    }
}
#endif

}  // namespace

void require_whole_dwa_block(Bytes data, const std::vector<DwaChannel>& channels) {
  Reader reader(data);
  const Sizes sizes = sizes_of(reader);
  const std::vector<Rule> rules = rules_in(reader);
  uint64_t deflated_bytes = 0, runs_bytes = 0, means = 0;
  for (const DwaChannel& channel : channels) {
    const uint64_t bytes = channel.columns * channel.rows * (channel.type == 1 ? 2 : 4);
    switch (scheme_of(rules, channel)) {
      case deflated:
        deflated_bytes += bytes;
        break;
      case runs:
        runs_bytes += bytes;
        break;
      case cosines:
        means += image_io::divided_up(channel.columns, 8) * image_io::divided_up(channel.rows, 8);
    }
  }
  require(sizes.deflated_bytes == deflated_bytes && sizes.runs_bytes == runs_bytes &&
          sizes.means_count == means);
  require((sizes.cosines_count > 0) == (sizes.cosines_stored > 0) &&
          (means > 0) == (sizes.means_stored > 0) && (runs_bytes > 0) == (sizes.runs_stored > 0));
  const Bytes stored = reader.take(sizes.deflated_stored);
  if (deflated_bytes > 0) require_inflates_to(stored, deflated_bytes);
  require(sizes.cosines_count <= 64 * means);
#if GLARE_HAS_HUF
  require_cosines_of(means, unpacked_cosines(reader.take(sizes.cosines_stored), sizes));
#endif
}

}  // namespace glare::openexr_io
