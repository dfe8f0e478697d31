#include "glare/convolution/kernel_programs.h"

#include <array>

#include "glare/base/error.h"

namespace glare {

namespace {

using Size = KernelImageOptions::Size;
using Alpha = KernelImageOptions::Alpha;

constexpr double kRollOff = 0.25;
constexpr bool kFloat = false, kHalf = true;

constexpr std::array<KernelProgram, 6> kPrograms = {{
    // name, {size, alpha, size_px, roll_off_share, half, turned}
    {"unreal", {Size::power_of_two, Alpha::none, 0, kRollOff, kHalf, false}},
    {"blender", {Size::odd, Alpha::impulse, 0, kRollOff, kFloat, true}},
    {"nuke", {Size::odd, Alpha::luminance, 0, kRollOff, kFloat, false}},
    {"vray", {Size::odd, Alpha::none, 0, kRollOff, kFloat, false}},
    {"sapphire", {Size::odd, Alpha::none, 0, kRollOff, kFloat, false}},
    {"godot", {Size::odd, Alpha::none, 0, kRollOff, kHalf, false}},
}};

}  // namespace

std::span<const KernelProgram> kernel_programs() { return kPrograms; }

const KernelProgram& kernel_program(const std::string& name) {
  std::string names;
  for (const KernelProgram& program : kPrograms) {
    if (name == program.name) return program;
    names += std::string(names.empty() ? "" : ", ") + program.name;
  }
  throw OptionError("no kernel is known for \"" + name + "\"; expected " + names);
}

}  // namespace glare
