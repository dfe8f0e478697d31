// How far a lamp's glare spills beyond a car's outline: of the picture outside it, the share to
// which more than a luminance is added.
//   spill OUTLINE.exr WITHOUT.exr CD_PER_M2 WITH.exr
#include <glare/glare.h>
#include <glare/glare_io.h>

#include <cstdio>
#include <cstdlib>

namespace {

glare::Picture picture_in(const char* path) {
  return glare::read_picture(path, glare::default_memory_limit_bytes()).picture;
}

double luminance(const glare::Picture& picture, int x, int y) {
  return 0.2126 * picture.channels[0](x, y) + 0.7152 * picture.channels[1](x, y) +
         0.0722 * picture.channels[2](x, y);
}

double spilled_share(const glare::Picture& outline, const glare::Picture& without,
                     const glare::Picture& with, double least) {
  long outside = 0, spilled = 0;
  for (int y = 0; y < outline.height(); ++y)
    for (int x = 0; x < outline.width(); ++x) {
      if (outline.channels[0](x, y) > 0) continue;
      ++outside;
      if (luminance(with, x, y) - luminance(without, x, y) > least) ++spilled;
    }
  return outside > 0 ? static_cast<double>(spilled) / static_cast<double>(outside) : 0;
}

void require_same_size(const glare::Picture& a, const glare::Picture& b, const char* path) {
  if (a.width() != b.width() || a.height() != b.height())
    throw glare::InputError(path, "has another size than the outline");
}

}  // namespace

int main(int argument_count, char** arguments) {
  if (argument_count != 5) {
    std::fprintf(stderr, "usage: spill OUTLINE.exr WITHOUT.exr CD_PER_M2 WITH.exr\n");
    return 2;
  }
  try {
    const glare::Picture outline = picture_in(arguments[1]), without = picture_in(arguments[2]),
                         with = picture_in(arguments[4]);
    require_same_size(outline, without, arguments[2]);
    require_same_size(outline, with, arguments[4]);
    std::printf("%.4f\n", spilled_share(outline, without, with, std::atof(arguments[3])));
  } catch (const glare::Error& error) {
    std::fprintf(stderr, "spill: %s\n", error.what());
    return 1;
  }
}
