#include <string>
#include <utility>
#include <vector>

#include "glare/c/c_errors.h"
#include "glare/c/c_handles.h"
#include "glare/spectrum/lamps.h"

using namespace glare::c;

namespace {

/// More samples than any table has, and few enough to be sorted.
constexpr std::size_t kMostSamples = 10'000'000;

}  // namespace

glare_status glare_lamp_find(const char* name_or_file, glare_lamp** lamp, glare_error* error) {
  return guarded(error, [&] {
    require_place(lamp, "lamp");
    require(name_or_file, "name_or_file");
    *lamp = new glare_lamp{glare::lamp_from(name_or_file)};
  });
}

glare_status glare_lamp_make(const double* wavelengths_nm, const double* power, size_t count,
                             const char* name, glare_lamp** lamp, glare_error* error) {
  return guarded(error, [&] {
    require_place(lamp, "lamp");
    require(wavelengths_nm, "wavelengths_nm");
    require(power, "power");
    if (count > kMostSamples) throw glare::OptionError("a lamp of more than 10000000 samples");
    glare::Spectrum spectrum({wavelengths_nm, wavelengths_nm + count}, {power, power + count});
    *lamp = new glare_lamp{{text_or_empty(name), {}, std::move(spectrum)}};
  });
}

void glare_lamp_free(glare_lamp* lamp) { delete lamp; }

int32_t glare_built_in_lamp_count(void) {
  try {
    return static_cast<int32_t>(glare::built_in_lamps().size());
  } catch (...) {  // No memory for the list.
    return 0;
  }
}

glare_status glare_built_in_lamp_text(int32_t index, int32_t which, char* buffer, size_t size,
                                      size_t* needed, glare_error* error) {
  return guarded(error, [&] {
    const std::vector<glare::BuiltInLamp> lamps = glare::built_in_lamps();
    if (index < 0 || static_cast<std::size_t>(index) >= lamps.size())
      throw glare::OptionError("lamp " + std::to_string(index) + ": there are " +
                               std::to_string(lamps.size()));
    const glare::BuiltInLamp& lamp = lamps[static_cast<std::size_t>(index)];
    const std::string* const texts[] = {&lamp.name, &lamp.alias, &lamp.description};
    give_text(*choice(texts, which, "which"), buffer, size, needed);
  });
}
