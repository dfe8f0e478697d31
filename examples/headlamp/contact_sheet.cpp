// Pictures of one size side by side, row by row, made smaller in linear light.
//   contact_sheet SHEET.png COLUMNS SHRINK PICTURE...
// SHRINK pixels across and down become one; 2 pixels of black are between pictures.
#include <glare/glare.h>
#include <glare/glare_io.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

constexpr int kGap_px = 2;

using DisplayPicture = glare::Image<std::array<float, 3>>;

/// sRGB's transfer curve, rounded to what 8 bits hold so that no dither is added again.
float encoded(double linear) {
  const double value =
      linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
  return static_cast<float>(std::round(255 * std::min(value, 1.0)) / 255);
}

/// The mean of a square of the picture's pixels.
double mean(const glare::Image<float>& channel, int left, int top, int side) {
  double sum = 0;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) sum += channel(left + x, top + y);
  return sum / (side * side);
}

void place(const glare::Picture& picture, int shrink, int left, int top, DisplayPicture& sheet) {
  for (int y = 0; y < picture.height() / shrink; ++y)
    for (int x = 0; x < picture.width() / shrink; ++x)
      for (std::size_t k = 0; k < 3; ++k)
        sheet(left + x, top + y)[k] =
            encoded(mean(picture.channels[k], x * shrink, y * shrink, shrink));
}

void run(const std::string& output, int columns, int shrink,
         const std::vector<std::string>& names) {
  DisplayPicture sheet;
  int width = 0, height = 0;
  for (int i = 0; i < static_cast<int>(names.size()); ++i) {
    const std::string& name = names[static_cast<std::size_t>(i)];
    const glare::Picture picture =
        glare::read_picture(name, glare::default_memory_limit_bytes()).picture;
    if (i == 0) {
      width = picture.width();
      height = picture.height();
      const int rows = (static_cast<int>(names.size()) + columns - 1) / columns;
      sheet = DisplayPicture(columns * (width / shrink + kGap_px) - kGap_px,
                             rows * (height / shrink + kGap_px) - kGap_px);
    }
    if (picture.width() != width || picture.height() != height)
      throw glare::InputError(name, "has another size than " + names.front());
    place(picture, shrink, i % columns * (width / shrink + kGap_px),
          i / columns * (height / shrink + kGap_px), sheet);
  }
  glare::write_file_atomically(output, glare::encode_png_rgb8(sheet));
}

}  // namespace

int main(int argument_count, char** arguments) {
  const int columns = argument_count > 4 ? std::atoi(arguments[2]) : 0;
  const int shrink = argument_count > 4 ? std::atoi(arguments[3]) : 0;
  if (columns < 1 || columns > 100 || shrink < 1 || shrink > 64) {
    std::fprintf(stderr, "usage: contact_sheet SHEET.png COLUMNS SHRINK PICTURE...\n");
    return 2;
  }
  try {
    run(arguments[1], columns, shrink, {arguments + 4, arguments + argument_count});
  } catch (const glare::Error& error) {
    std::fprintf(stderr, "contact_sheet: %s\n", error.what());
    return 1;
  }
}
