// Blocks of OpenEXR's DWA compressions, checked before they are decoded: OpenEXR believes the sizes
// that a block tells, and leaves pixels unset where they are too small. Internal.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace glare::openexr_io {

/// A channel's share of a block.
struct DwaChannel {
  std::string name;
  unsigned type = 0;  ///< 0: uint, 1: half, 2: float.
  std::uint64_t columns = 0, rows = 0;
};

/// Requires that the sizes are those that the channels take, sorted by the block's own rules: of
/// deflated values, of run-length coded ones, and of cosine transforms' mean values, one for each 8
/// x 8 pixels. Throws `image_io::BadImage`, also for blocks without rules (versions before 2, which
/// OpenEXR has not written since 2014).
void require_whole_dwa_block(std::span<const std::byte> data,
                             const std::vector<DwaChannel>& channels);

}  // namespace glare::openexr_io
