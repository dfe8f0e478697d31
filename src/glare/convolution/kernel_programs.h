// The programs that a kernel's picture can be made for, and what each of them wants.
#pragma once

#include <span>
#include <string>

#include "glare/convolution/kernel_image.h"

namespace glare {

/// What a program wants of a kernel; docs/kernels.md has the sources.
struct KernelProgram {
  const char* name;            ///< As the command line has it.
  KernelImageOptions options;  ///< Size and roll-off are the user's.
};

/// unreal, blender, nuke, vray, sapphire, godot.
std::span<const KernelProgram> kernel_programs();

/// Throws `OptionError`, with the names that there are.
const KernelProgram& kernel_program(const std::string& name);

}  // namespace glare
