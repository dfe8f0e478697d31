#include "glare/io/openexr/pixel_bands.h"

#include <algorithm>
#include <cmath>

#include "glare/io/openexr/rgb_pixels.h"
#include "glare/io/template_file.h"

namespace glare::openexr_io {

namespace {

std::size_t bytes_of(Imf::PixelType type) { return type == Imf::HALF ? 2 : 4; }

/// Rounded down, for coordinates that may be negative.
std::ptrdiff_t divided_down(int value, int by) {
  return value >= 0 ? value / by : -((by - 1 - value) / by);
}

/// What half precision holds of the value: itself where it isn't finite.
float limited_to_half(float value, bool& limited) {
  if (!std::isfinite(value) || std::abs(value) <= kLargestHalf) return value;
  limited = true;
  return std::copysign(kLargestHalf, value);
}

}  // namespace

KeptBand::KeptBand(const Imf::Header& header, const std::vector<std::string>& changed, int rows)
    : x_min_(header.dataWindow().min.x) {
  const auto width = static_cast<std::size_t>(header.dataWindow().max.x - x_min_ + 1);
  for (auto c = header.channels().begin(); c != header.channels().end(); ++c) {
    if (std::ranges::find(changed, c.name()) != changed.end()) continue;
    const Imf::Channel& stored = c.channel();
    // A band may begin between two of a subsampled channel's rows.
    const auto row_bytes =
        (width / static_cast<std::size_t>(stored.xSampling) + 1) * bytes_of(stored.type);
    const auto band_rows = static_cast<std::size_t>(rows / stored.ySampling + 2);
    channels_.push_back({c.name(), stored, row_bytes, std::vector<char>(row_bytes * band_rows)});
  }
}

void KeptBand::add_slices(Imf::FrameBuffer& frame_buffer, int y) {
  for (Channel& channel : channels_) {
    const auto [type, x_sampling, y_sampling, linear] = channel.stored;
    const std::size_t step = bytes_of(type);
    char* const origin =
        channel.band.data() - divided_down(x_min_, x_sampling) * static_cast<std::ptrdiff_t>(step) -
        divided_down(y, y_sampling) * static_cast<std::ptrdiff_t>(channel.row_bytes);
    frame_buffer.insert(channel.name,
                        Imf::Slice(type, origin, step, channel.row_bytes, x_sampling, y_sampling));
  }
}

ColorBand::ColorBand(const Imf::Header& header, const std::vector<std::string>& names,
                     const Picture& picture, int rows)
    : min_(header.dataWindow().min) {
  for (std::size_t k = 0; k < names.size(); ++k) {
    const bool half = header.channels()[names[k]].type == Imf::HALF;
    channels_.push_back({names[k], half, &picture.channels[k],
                         half ? Image<Imath::half>(picture.width(), rows) : Image<Imath::half>()});
  }
}

void ColorBand::convert(int first_row, int rows) {
  const int width = channels_[0].pixels->width();
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < width; ++column) {
      bool limited = false;
      for (Channel& channel : channels_)
        if (channel.half)
          channel.band(column, row) =
              limited_to_half((*channel.pixels)(column, first_row + row), limited);
      if (limited) ++limited_pixels_;
    }
}

void ColorBand::add_slices(Imf::FrameBuffer& frame_buffer, int y, int rows) {
  if (std::ranges::any_of(channels_, &Channel::half)) convert(y - min_.y, rows);
  for (const Channel& channel : channels_)
    frame_buffer.insert(channel.name, channel.half ? slice_of(Imf::HALF, channel.band, {min_.x, y})
                                                   : slice_of(Imf::FLOAT, *channel.pixels, min_));
}

}  // namespace glare::openexr_io
