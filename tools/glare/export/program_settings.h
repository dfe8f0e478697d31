// What to set in the programs that a kernel's picture is made for.
#pragma once

#include <string>

#include "glare/glare.h"

namespace glare::tool {

struct ExportedKernel {
  std::string file;      ///< As given.
  KernelImage image;     ///< Without its pixels' need: sizes, centre and sum are told.
  double pixel_deg = 0;  ///< Of the picture it is for, across.
  int picture_width = 0;
  std::string field_of_view;  ///< Across the picture, in words.
  std::string color_space;    ///< As given.

  int width() const { return image.picture.width(); }
  int height() const { return image.picture.height(); }
  /// The kernel's width as a share of the picture's.
  double share_of_width() const { return static_cast<double>(width()) / picture_width; }
};

/// Three lines, each with its end. docs/kernels.md has where it comes from.
std::string settings_for(const std::string& program, const ExportedKernel& kernel);

/// What of the kernel the program can't take as it is; empty where there is nothing.
std::string limit_of(const std::string& program, const ExportedKernel& kernel);

}  // namespace glare::tool
