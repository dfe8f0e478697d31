// Which channels of an OpenEXR file are the colours of one of its layers. Internal.
#pragma once

#include <OpenEXR/ImfChannelList.h>

#include <string>
#include <vector>

namespace glare::openexr_io {

struct ColorChannels {
  std::vector<std::string> names;  ///< Red, green, blue (X, Y, Z); of a grey picture only one.
  bool is_xyz = false;

  bool is_gray() const { return names.size() == 1; }
};

/// The colours of the layer: LAYER.R, LAYER.G, LAYER.B (or r, g, b; or red, green, blue), else X,
/// Y, Z, else Y or the only channel that there is beside an alpha. A layer may also be a channel's
/// whole name. The empty layer's channels have no dots in their names; of a picture with several
/// views (the attribute multiView) they are the default view's. Throws `image_io::BadImage`, with
/// the layers that there are, where there are no such channels; where they are subsampled or whole
/// numbers.
ColorChannels color_channels(const Imf::ChannelList& channels, const std::string& layer);

}  // namespace glare::openexr_io
