// What the handles of glare_c.h are. Internal.
#pragma once

#include <string>

#include "glare/color/color_space.h"
#include "glare/convolution/glare_filter.h"
#include "glare/glare_c.h"
#include "glare/io/lamp_file.h"
#include "glare/template/glare_template.h"

struct glare_lamp {
  glare::NamedLamp lamp;
};

struct glare_template {
  glare::GlareTemplate value;
};

struct glare_filter {
  glare::GlareFilter filter;
  bool grey = false;
};

namespace glare::c {

/// A colour space by its name; null: the default. Throws as `find_color_space`.
RgbColorSpace color_space_of(const char* name, const char* ocio_config);

}  // namespace glare::c
