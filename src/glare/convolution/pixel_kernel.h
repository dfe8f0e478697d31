// A template on the pixels of a picture: where the light of one pixel goes.
#pragma once

#include <array>

#include "glare/base/image.h"
#include "glare/color/color_space.h"
#include "glare/template/glare_template.h"

namespace glare {

/// How large a picture's pixels are.
struct PixelScale {
  /// The angle from pixel to pixel across, in radians of direction sine, at the picture's centre;
  /// above 0, at most 1.
  double pitch_rad = 0;
  double pixel_aspect = 1;  ///< A pixel's width over its height, 1/64 to 64.
};

/// The scale of a picture whose `width_px` pixels are `fov_deg` across: fov_deg / width_px degrees
/// of direction sine each, as `TemplateOptions::field_of_view_deg` means it. Throws `OptionError`
/// out of range (0 to 180).
PixelScale scale_of_field_of_view(double fov_deg, int width_px);

/// The scale in the middle of a perspective picture (as of a pinhole camera), where its pixels are
/// largest: 2 tan(fov_deg / 2) / width_px. Throws as above.
PixelScale scale_of_perspective(double fov_deg, int width_px);

struct PixelKernelOptions {
  /// What the lamp's own colour does.
  enum class LampColor {
    /// Each channel of the template is divided by the lamp's: white light stays white as a whole,
    /// and only where it goes depends on colour. For pictures, whose lights have their colours. (A
    /// lamp that is the picture's white to 0.1 % is taken for it.)
    divided_out,
    kept  ///< White light gets the lamp's colour.
  };
  LampColor lamp_color = LampColor::divided_out;
  /// All three channels get the kernel of luminance, for grey pictures.
  bool luminance_only = false;
  /// Pixels farther from the axis than this across or down aren't kept (their light still counts in
  /// `captured`): a picture's width and height less 1 are enough for it. 0: all.
  int reach_x_px = 0, reach_y_px = 0;
  /// Where the axis lies, from the centre of its pixel, right and down: -0.5 to 0.5.
  double shift_x_px = 0, shift_y_px = 0;
  int threads = 0;  ///< 0: as many as the machine has; the bytes are the same for any number.
};

/// What becomes of the light of one pixel, channel by channel: the share `channels(x, y)` of it
/// goes to the pixel that lies (x - width / 2, y - height / 2) from it, and the share `kept` stays
/// in it, because a template says nothing of where the light beyond its field goes. `captured` and
/// `kept` are 1 together (`LampColor::divided_out`), so that a picture of one value stays as it is;
/// with `LampColor::kept` they are the lamp's channels, for a luminance of 1.
struct PixelKernel {
  std::array<Image<float>, 3> channels;  ///< Odd sizes; shares, some may be negative.
  std::array<double, 3> captured{};      ///< Sum of a channel's shares, before `reach_x_px` cuts.
  std::array<double, 3> kept{};          ///< What is left of the light.
  RgbColorSpace color_space = lin_rec709_color_space();
  PixelScale scale;

  int width() const { return channels[0].width(); }
  int height() const { return channels[0].height(); }
};

/// The template on pixels of this scale, in the picture's colour space: each pixel is the
/// template's mean over its rectangle of directions times its solid angle, so that light is kept at
/// any ratio of the pitches, and at a ratio of 1 the values are the template's own times
/// `per_steradian` and the solid angle. Between them light goes smoothly from pixel to pixel of the
/// template, as `resampled` has it. Where a channel of the lamp's colour is under 5 % of its
/// luminance (sodium has no blue), the kernel of luminance takes the place of its own. Throws
/// `OptionError` for a scale or options out of range, or more than 131071 pixels a side,
/// `InputError` for a template without pixels, pitch or light, or with a pixel that isn't finite.
PixelKernel pixel_kernel(const GlareTemplate& glare_template, const PixelScale& scale,
                         const RgbColorSpace& picture_space,
                         const PixelKernelOptions& options = {});

}  // namespace glare
