// A glare template as Python sees it: its pixels in one block.
#pragma once

#include <pybind11/numpy.h>

#include "glare/template/glare_template.h"

namespace glare::python {

class TemplateObject {
 public:
  /// Takes the pixels over, channel by channel, so that hardly more than one copy of them is held.
  explicit TemplateObject(GlareTemplate made);

  /// All but the pixels: its channels are empty.
  const GlareTemplate& facts() const { return facts_; }
  int width() const { return static_cast<int>(planes_.shape(2)); }
  int height() const { return static_cast<int>(planes_.shape(1)); }

  /// (h, w, 3), a view that can't be written to.
  pybind11::array rgb() const;
  pybind11::array_t<float> luminance() const;

  /// With a copy of the pixels, for the library. Needs no GIL.
  GlareTemplate whole() const;

 private:
  GlareTemplate facts_;
  pybind11::array_t<float> planes_;  ///< (3, h, w)
};

}  // namespace glare::python
