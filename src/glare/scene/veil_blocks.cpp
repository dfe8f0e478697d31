#include "glare/scene/veil_blocks.h"

#include <algorithm>
#include <cmath>

namespace glare {

namespace {

constexpr std::size_t kSmallestBlock = 16;
constexpr double kBlockTangent = 0.04;

Line line_from(const AlongRow& number, int first) {
  return {static_cast<float>(number.start + first * number.step), static_cast<float>(number.step)};
}

/// The width of pixel i along an axis of the grid: of the box that has the pixel's variance.
double pixel_width(const AlongRow& number, const VeilRow& pixels, double i) {
  const double right = pixels.right.start + i * pixels.right.step, down = pixels.down.start;
  const double square = 1 + right * right + down * down, shrink = 1 / std::sqrt(square);
  const double place = (number.start + i * number.step) / square * pixels.right.step;
  const double along = number.step - place * right, below = number.below - place * down;
  return std::max(kNarrowestPixel, shrink * std::sqrt(along * along + below * below));
}

}  // namespace

VeilBlocks::VeilBlocks(const VeilRow& pixels, double widest) : pixels_(pixels), widest_(widest) {
  const double size = kBlockTangent / pixels.right.step / kSmallestBlock;
  const auto most = static_cast<double>(kBlock / kSmallestBlock);
  size_ = kSmallestBlock * static_cast<std::size_t>(std::clamp(size, 1.0, most));
  end_ = widths_at(0);
}

BlockLines VeilBlocks::next(std::size_t first) {
  const Widths begin = end_;
  end_ = widths_at(static_cast<double>(first + size_));
  const int i = static_cast<int>(first);
  return {line_from(pixels_.right, i),
          static_cast<float>(1 + pixels_.down.start * pixels_.down.start),
          line_from(pixels_.forward, i), axis_lines(pixels_.column, i, begin.column, end_.column),
          axis_lines(pixels_.row, i, begin.row, end_.row)};
}

VeilBlocks::Widths VeilBlocks::widths_at(double i) const {
  return {std::min(widest_, pixel_width(pixels_.column, pixels_, i)),
          std::min(widest_, pixel_width(pixels_.row, pixels_, i))};
}

AxisLines VeilBlocks::axis_lines(const AlongRow& place, int first, double begin, double end) const {
  const auto line = [this](double a, double b) {
    return Line{static_cast<float>(a), static_cast<float>((b - a) / static_cast<double>(size_))};
  };
  return {line_from(place, first), line(0.5 * begin, 0.5 * end), line(1 / begin, 1 / end),
          std::abs(end - begin) < 0.1 * begin};
}

}  // namespace glare
