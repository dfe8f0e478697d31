#include "export/program_settings.h"

#include <cstdarg>
#include <cstdio>
#include <functional>
#include <map>

namespace glare::tool {

namespace {

std::string format(const char* pattern, ...) __attribute__((format(printf, 1, 2)));

std::string format(const char* pattern, ...) {
  char text[400];
  va_list arguments;
  va_start(arguments, pattern);
  std::vsnprintf(text, sizeof text, pattern, arguments);
  va_end(arguments);
  return text;
}

/// "513 x 513 pixels of 0.01 degrees, axis at column 256, row 256".
std::string size_of(const ExportedKernel& k) {
  return format("%d x %d pixels of %.6g degrees, axis at column %d, row %d", k.width(), k.height(),
                k.pixel_deg, k.image.center_px[0], k.image.center_px[1]);
}

std::string unreal(const ExportedKernel& k) {
  return "Texture: import " + k.file +
         " with compression HDR (RGB, no sRGB), sRGB off, no mipmaps, never stream; " + size_of(k) +
         "\n" +
         format(
             "Bloom: Method Convolution, this texture as Convolution Kernel, Convolution Scale "
             "%.6g (%d of the picture's %d pixels; %s), Convolution Center "
             "%.6f, %.6f\n",
             k.share_of_width(), k.width(), k.picture_width, k.field_of_view.c_str(),
             (k.image.center_px[0] + 0.5) / k.width(), (k.image.center_px[1] + 0.5) / k.height()) +
         format(
             "Bloom: Intensity 1, Scatter Dispersion 1, Convolution Boost Max 0 and Min 1 (off), "
             "Convolution Buffer %.6g or more\n",
             k.share_of_width());
}

std::string blender(const ExportedKernel& k) {
  const std::string space =
      k.color_space == "lin_rec709" ? "Linear Rec.709" : k.color_space + " (linear)";
  return "Image node: " + k.file + ", colour space " + space +
         ", which is the kernel's and to be the scene's, alpha Premultiplied; " + size_of(k) +
         ", turned by half a turn as Convolve wants it\n" +
         "Convolve node (Blender 5.0 and later): Kernel Data Type Color, Normalize Kernel on; the "
         "kernel's alpha leaves the picture's alpha as it is\n" +
         "Glare node: has no input for a kernel and its Bloom and Fog Glow are shapes of its own; "
         "don't use it beside this one\n";
}

std::string nuke(const ExportedKernel& k) {
  return "Read: " + k.file + ", raw data or a linear colour space; " + size_of(k) +
         ", connected to Convolve's filter\n" +
         "Convolve: use input channels on (off, filter channel rgba.alpha takes the kernel's alpha "
         "for every channel: it is that of luminance, without colour); filter bounds format\n" +
         "Convolve: normalize on (each channel sums to 1, so off is the same); channels rgb keeps "
         "the picture's alpha, all spreads it by luminance\n";
}

std::string vray(const ExportedKernel& k) {
  return "VRayLensEffects (render effect; legacy): Glare on, type From image, Bitmap " + k.file +
         "; " + size_of(k) + "\n" +
         format(
             "Glare: Size %.6g (per cent of the picture's width of %d pixels), Weight 1, Fill "
             "edges off, no masks\n",
             100 * k.share_of_width(), k.picture_width) +
         "V-Ray Frame Buffer: where Lens Effects has no glare image, save linear EXR and use glare "
         "apply or a compositor's Convolve instead\n";
}

std::string sapphire(const ExportedKernel& k) {
  return "Kernel input of S_Convolve: " + k.file + ", linear, no conversion; " + size_of(k) + "\n" +
         "S_Convolve: Kernel Size 1, Kernel Rel Width 1, Kernel Rel Height 1, AutoCenter off with "
         "Kernel Center on the middle pixel, Kernel Crop around all of it\n" +
         "S_Convolve: Use Gamma 1, Boost Highlights 0, Brightness 1 (each channel of the kernel "
         "sums to 1); S_Glare has shapes of its own and takes no kernel\n";
}

std::string godot(const ExportedKernel& k) {
  return "Import " + k.file +
         " as Texture2D: Compress Mode Lossless, no mipmaps, HDR as sRGB off, HDR Clamp Exposure "
         "off; " +
         size_of(k) + "\n" +
         "Environment's Glow has no kernel (its Map only multiplies the glow): use a "
         "CompositorEffect with a compute shader (Forward+ or Mobile)\n" +
         format(
             "Shader: sum over (x, y) of colour(p - (x - %d, y - %d)) * texelFetch(kernel, (x, "
             "y)) / %g; black outside the picture\n",
             k.image.center_px[0], k.image.center_px[1], k.image.sum);
}

const std::map<std::string, std::function<std::string(const ExportedKernel&)>> kSettings = {
    {"unreal", unreal}, {"blender", blender},   {"nuke", nuke},
    {"vray", vray},     {"sapphire", sapphire}, {"godot", godot}};

}  // namespace

std::string settings_for(const std::string& program, const ExportedKernel& kernel) {
  return kSettings.at(program)(kernel);
}

std::string limit_of(const std::string& program, const ExportedKernel& k) {
  if (program == "unreal" && k.width() > k.picture_width)
    return format(
        "Unreal limits the Convolution Scale to 1, and this kernel needs %.6g; a smaller "
        "--size would fit",
        k.share_of_width());
  if (program == "unreal" && !k.image.center_is_brightest)
    return "Unreal takes the brightest pixel for the centre, and this kernel's is another";
  return {};
}

}  // namespace glare::tool
