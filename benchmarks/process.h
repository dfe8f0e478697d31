// Whole runs of the glare program.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace glare::bench {

/// A new empty folder, which is removed with all that is in it.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// How long the glare program takes from its start to its end, in seconds, with `cache_folder` as
/// the user's cache folder. What it prints is dropped. Throws `std::runtime_error` where it can't
/// be started or its exit status isn't 0.
double glare_process_s(const std::vector<std::string>& arguments,
                       const std::filesystem::path& cache_folder);

}  // namespace glare::bench
