// PBM, PGM, PPM and PFM files, plain and binary. The header's sizes have to agree with the bytes
// that are there, and the file is written anew: a header without comments, and samples of the kinds
// that OpenImageIO 2.4 decodes without loss.
#include <bit>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "glare/io/image/byte_reader.h"
#include "glare/io/image/structure.h"

namespace glare::image_io {

using std::uint32_t;
using std::uint64_t;

namespace {

/// The next word of a PNM header: comments and white space before it are skipped.
std::string pnm_word(Reader& reader) {
  std::string word;
  while (true) {
    char character = static_cast<char>(reader.u8());
    if (character == '#' && word.empty()) {
      while (character != '\n' && character != '\r') character = static_cast<char>(reader.u8());
    } else if (!std::isspace(static_cast<unsigned char>(character))) {
      word += character;
      require(word.size() <= 32, "the header is damaged");
    } else if (!word.empty()) {
      return word;
    }
  }
}

std::string sign_of_pfm_scale(const std::string& word) {
  const float scale = number_from<float>(word);
  require(std::isfinite(scale) && scale != 0, "the header is damaged");
  return scale < 0 ? "-1.0" : "1.0";  // Only its sign, the byte order: values are used as stored.
}

/// The digits of a plain PBM, which may stand without spaces between them.
std::string spaced_bits(std::string_view text, uint64_t count) {
  std::string bits;
  for (const char character : text) {
    if (bits.size() == 2 * count) break;
    if (std::isspace(static_cast<unsigned char>(character))) continue;
    require(character == '0' || character == '1', "has something else than 0 and 1");
    bits += character;
    bits += '\n';
  }
  require(bits.size() == 2 * count, "the file is cut short");
  return bits;
}

uint64_t least_pnm_bytes(char kind, uint64_t width, uint64_t height, uint64_t channels,
                         unsigned maximum) {
  const uint64_t samples = width * height * channels;
  switch (kind) {
    case '1':
      return samples;
    case '2':
    case '3':
      return 2 * samples - 1;
    case '4':
      return divided_up(width, 8) * height;
    case 'F':
    case 'f':
      return samples * 4;
    default:
      return samples * (maximum > 255 ? 2 : 1);
  }
}

/// The samples of a PGM or PPM as a share of the maximum.
std::vector<float> pnm_samples(Reader reader, bool plain, uint64_t count, unsigned maximum) {
  Bytes text;
  if (plain) append(text, reader.take(reader.left()));
  if (plain) append(text, "\n");  // A plain number may be the file's last byte.
  Reader words(text);
  std::vector<float> samples;
  samples.reserve(count);
  for (uint64_t i = 0; i < count; ++i) {
    const uint64_t value =
        plain ? number_from<uint64_t>(pnm_word(words)) : reader.number(maximum > 255 ? 2 : 1);
    require(value <= maximum, "has a value above its maximum");
    samples.push_back(static_cast<float>(static_cast<double>(value) / maximum));
  }
  return samples;
}

/// The samples as the pixels of a PFM file of scale -1: from the last row to the first.
Bytes pfm_pixels(std::span<const float> samples, std::size_t row_samples) {
  Bytes pixels;
  pixels.reserve(4 * samples.size());
  for (std::size_t end = samples.size(); end > 0; end -= row_samples) {
    for (const float sample : samples.subspan(end - row_samples, row_samples)) {
      append_number(pixels, std::bit_cast<uint32_t>(sample), 4, std::endian::little);
    }
  }
  return pixels;
}

/// The header of a PNM file. `fields` is what stands after the sizes: a maximum, or a scale.
std::string pnm_start(char kind, const Header& header, const std::string& fields) {
  return std::string("P") + kind + "\n" + std::to_string(header.width) + " " +
         std::to_string(header.height) + "\n" + (fields.empty() ? "" : fields + "\n");
}

/// The file anew: a header without comments, and pixels of a kind that is decoded well. Of 16-bit
/// ones OpenImageIO 2.4 makes 65534 out of 65535, and of other maxima than 255 it keeps 8 bits.
Bytes rewritten_pnm(Reader& reader, char kind, const Header& header, const std::string& scale,
                    unsigned maximum) {
  Bytes kept;
  const uint64_t row_samples = header.width * header.channels;
  const bool plain = kind == '2' || kind == '3';
  const bool whole = kind == '5' || kind == '6';
  if (kind == '1') {
    append(kept, pnm_start(kind, header, ""));
    append(kept, spaced_bits(text_of(reader.take(reader.left())), row_samples * header.height));
  } else if (plain || (whole && maximum != 255)) {
    const Reader pixels(reader.take(reader.left()), std::endian::big);
    append(kept, pnm_start(header.channels == 3 ? 'F' : 'f', header, "-1.0"));
    append(kept, pfm_pixels(pnm_samples(pixels, plain, row_samples * header.height, maximum),
                            row_samples));
  } else {
    append(kept, pnm_start(kind, header, whole ? "255" : scale));
    append(kept, reader.take(header.least_bytes));
  }
  return kept;
}

}  // namespace

Header checked_pnm(Bytes& bytes) {
  Reader reader(bytes);
  reader.skip(1);
  const char kind = static_cast<char>(reader.u8());
  const uint64_t width = number_from<uint64_t>(pnm_word(reader));
  const uint64_t height = number_from<uint64_t>(pnm_word(reader));
  require_sides(width, height);
  const bool real = kind == 'f' || kind == 'F';
  const bool bits = kind == '1' || kind == '4';
  const std::string scale = real ? sign_of_pfm_scale(pnm_word(reader)) : "";
  const unsigned maximum = real || bits ? 1 : number_from<unsigned>(pnm_word(reader));
  require(maximum >= 1 && maximum <= 65535, "has a maximum outside 1 to 65535");
  Header header{width, height, kind == '3' || kind == '6' || kind == 'F' ? 3u : 1u};
  header.least_bytes = least_pnm_bytes(kind, width, height, header.channels, maximum);
  header.decoder_bytes = width * height * header.channels * 12;
  header.linear_light = real;
  require(reader.left() >= header.least_bytes, "the file is cut short");
  bytes = rewritten_pnm(reader, kind, header, scale, maximum);
  return header;
}

}  // namespace glare::image_io
