// The plans of Fourier transforms, kept in a file from one run of a program to the next.
#pragma once

#include <filesystem>

namespace glare {

/// `glare/transforms` in the user's cache folder, which is $XDG_CACHE_HOME or else ~/.cache. Empty
/// where neither is known.
std::filesystem::path transform_plans_path();

/// What a long-lived program calls once, before its first transform, to have the plans that
/// `measure_transforms` made in earlier runs: those are then taken at once. True where there are
/// some. A file that is not there, can't be read, is damaged, or comes from another version or
/// another processor is left alone and nothing is changed. The program `glare` does not call this:
/// the same command is to give the same bytes, whatever ran before.
bool load_transform_plans(const std::filesystem::path& path = transform_plans_path());

/// Puts this process' plans in the place of the file, all or nothing; makes its folder, for the
/// user alone, where there is none. False where it can't be written, which does no harm.
bool store_transform_plans(const std::filesystem::path& path = transform_plans_path());

}  // namespace glare
