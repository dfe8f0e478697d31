#include "glare/aperture/open_part.h"

#include <algorithm>

namespace glare {

OpenPart open_part(const Aperture& aperture) {
  const Image<float>& t = aperture.transmittance;
  int x0 = t.width(), x1 = 0, y0 = t.height(), y1 = 0;
  const auto is_open = [](float value) { return value != 0; };
  for (int y = 0; y < t.height(); ++y) {
    const auto row = t.row(y);
    const auto first = std::find_if(row.begin(), row.end(), is_open);
    if (first == row.end()) continue;
    const auto last = std::find_if(row.rbegin(), row.rend(), is_open);
    x0 = std::min(x0, static_cast<int>(first - row.begin()));
    x1 = std::max(x1, static_cast<int>(row.rend() - last));
    y0 = std::min(y0, y);
    y1 = y + 1;
  }
  return {x0, y0, std::max(0, x1 - x0), std::max(0, y1 - y0)};
}

}  // namespace glare
