// Which blocks a picture is convolved in. Internal.
#pragma once

#include <array>
#include <cstdint>

#include "glare/convolution/axis_blocks.h"

namespace glare {

/// What of a convolution decides its blocks.
struct ConvolutionSize {
  int width = 1, height = 1;
  KernelReach across, down;
  bool extends = false;  ///< Light comes from beyond the picture's border.
  int threads = 1;
};

struct BlockPlan {
  AxisBlocks across, down;
  int columns = 2, rows = 2;  ///< The transforms' lengths.

  bool is_whole() const { return across.count() == 1 && down.count() == 1; }
  /// Blocks are done from left to right, and one below the other. Where there are several, so many
  /// columns of light are held: those of the blocks below one another, and those left of them that
  /// they need, which have their glare already.
  int held_columns() const;
  /// Bytes of the kernel's transforms, and of what a call works in.
  std::uint64_t kernel_bytes() const;
  std::uint64_t call_bytes(int threads) const;
};

/// Columns that are held for so many, in whole lines.
int whole_lines(int columns);

/// The quickest blocks that take at most `limit_bytes` (0: any). Throws `MemoryError` where none
/// do; it then tells `other_bytes` more, of needed and of allowed.
BlockPlan quickest_blocks(const ConvolutionSize& size, std::uint64_t limit_bytes,
                          std::uint64_t other_bytes);

}  // namespace glare
