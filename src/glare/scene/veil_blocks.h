// A picture's row in blocks, along which the places of its pixels about a lamp are simple.
// Internal.
#pragma once

#include <cstddef>

#include "glare/scene/veil_row.h"

namespace glare {

/// A narrower pixel is taken for one of this width, in pixels of the grid; that keeps the digits.
inline constexpr double kNarrowestPixel = 0.01;

/// So many pixels are in a block at most.
inline constexpr std::size_t kBlock = 64;

/// A number along a block: at pixel i, start + i * step.
struct Line {
  float start, step;
};

/// Where a block's pixels lie along one axis of the grid.
struct AxisLines {
  Line place;  ///< Of the middle about the axis, times the length of (right, down, 1).
  Line half;   ///< Half the width.
  Line scale;  ///< About 1 / width, where `even`.
  bool even;   ///< The width changes by a few per cent at most.
};

/// A block's pixels in the grid.
struct BlockLines {
  Line right;
  float down_square;  ///< And 1.
  Line forward;
  AxisLines column, row;
};

/// The blocks of a row, one after the other. Places are exact; widths, slow to compute, are linear
/// between a block's ends, which are 16 to kBlock pixels and, where that leaves a choice, no more
/// than 0.04 of tangent apart: the error is below 1e-3 of the width.
class VeilBlocks {
 public:
  /// `widest` limits the pixels' width, in pixels of the grid. Keeps a reference to `pixels`.
  VeilBlocks(const VeilRow& pixels, double widest);

  std::size_t size() const { return size_; }

  /// The block from pixel `first` on, where the last one ended.
  BlockLines next(std::size_t first);

 private:
  /// The widths of one pixel along both axes.
  struct Widths {
    double column, row;
  };
  Widths widths_at(double i) const;
  AxisLines axis_lines(const AlongRow& place, int first, double begin, double end) const;

  const VeilRow& pixels_;
  double widest_;
  std::size_t size_;
  Widths end_;
};

}  // namespace glare
