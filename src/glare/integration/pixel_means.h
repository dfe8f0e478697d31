// From rays to the means over pixels. Internal.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "glare/integration/ray_band.h"
#include "glare/integration/ray_convolution.h"
#include "glare/integration/windowed_sinc.h"

namespace glare {

/// The pixels of a band, tile by tile.
class PixelMeans {
 public:
  /// Memory for one tile at a time: on rays, at places, of pixels and their sums.
  struct Workspace {
    std::array<std::vector<float>, 3> rays, places, pixels, sums;
    std::vector<float> turned;
  };

  PixelMeans(const RayXyz& rays, const RayBand& band, const SubPixels& sub, const PixelGrid& grid,
             bool odd = false);

  int tile_count() const { return static_cast<int>(tiles_.size()); }
  /// Writes the tile's pixels and those opposite to the axis. Tiles may be computed at the same
  /// time.
  void compute_tile(int tile, Workspace& work, XyzImage& image) const;

 private:
  struct Tile {
    int major0, major1, minor0, minor1;
  };
  /// Of a ray's rows, for the value at one distance.
  struct RadialWeights {
    int first_row;
    std::array<float, WindowedSinc::kMostTaps> weights;
  };
  RadialWeights radial_weights(int place) const;
  void interpolate_line(int place, int first, int count, Workspace& work) const;
  void add_line(const Tile& tile, int place, Workspace& work) const;
  static constexpr int kLongestTile = 64;  ///< Along the major coordinate.

  static int row_length(const Tile& tile);
  void store_run(Image<float>& image, int x0, int y, std::span<const float> values) const;
  void store(const Tile& tile, Workspace& work, XyzImage& image) const;

  const RayXyz& rays_;
  RayBand band_;
  const SubPixels& sub_;
  PixelGrid grid_;
  bool odd_;  ///< Pixels opposite to the axis have the other sign.
  std::vector<Tile> tiles_;
};

}  // namespace glare
