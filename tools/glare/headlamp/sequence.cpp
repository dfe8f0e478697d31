#include "headlamp/sequence.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <set>
#include <span>

#include "aperture/eye_arguments.h"
#include "frames.h"
#include "glare/base/error.h"
#include "glare/base/parallel.h"
#include "glare/io/atomic_file.h"
#include "glare/io/memory.h"
#include "glare/io/sha256.h"

namespace glare::tool {

namespace {

namespace fs = std::filesystem;

/// How the machine is shared between frames.
struct Share {
  int frames_at_once;
  int threads_each;
};

/// Frames side by side leave no core idle while a file is written; memory may allow fewer.
Share share_of(const Camera& camera, int frames, const HeadlampArguments& arguments) {
  constexpr double kBytesPerPixel = 64;  // The linear picture, the display's, and their files.
  const double frame_bytes = kBytesPerPixel * camera.width * camera.height;
  const std::uint64_t limit =
      arguments.memory_limit_bytes ? arguments.memory_limit_bytes : default_memory_limit_bytes();
  const double fit = static_cast<double>(limit) / frame_bytes;
  if (fit < 1) throw MemoryError(static_cast<std::uint64_t>(frame_bytes), limit);
  const int threads = threads_used(arguments.threads);
  const int at_once = std::min({threads, frames, static_cast<int>(std::min(fit, 1024.0))});
  return {at_once, std::max(1, threads / at_once)};
}

std::string key_of(const std::string& fingerprint, const SceneFrame& frame,
                   const std::string& background) {
  std::string all = fingerprint + "\n" + background + "\n" + text_of(frame.turn_deg);
  for (const double metres : frame.eye_m) all.append(" ").append(text_of(metres));
  return sha256_of(std::as_bytes(std::span(all.data(), all.size())));
}

std::set<std::string> file_names(const std::vector<SceneFrame>& frames,
                                 const std::string& pattern) {
  std::set<std::string> names;
  for (const SceneFrame& frame : frames)
    names.insert(fs::path(with_frame(pattern, frame.index)).filename().string());
  return names;
}

}  // namespace

void require_outputs(const std::vector<SceneFrame>& frames, const Camera& camera,
                     const HeadlampArguments& arguments) {
  if (arguments.output.empty()) return;
  share_of(camera, static_cast<int>(frames.size()), arguments);
  for (const SceneFrame& frame : frames)
    require_writable(with_frame(arguments.output, frame.index));
  if (frames.size() > 1) FrameRecord(arguments.output).require_writable();
}

void write_frames(const FrameMaker& maker, const SceneParts& parts,
                  const std::vector<SceneFrame>& frames, const std::string& fingerprint,
                  const HeadlampArguments& arguments, const Console& console) {
  const int count = static_cast<int>(frames.size());
  const Share share = share_of(parts.backgrounds.camera(), count, arguments);
  std::optional<FrameRecord> record;
  if (count > 1) {
    record.emplace(arguments.output);
    if (arguments.resume)
      remove_leftovers(file_names(frames, arguments.output),
                       fs::path(with_frame(arguments.output, 0)).parent_path(), *record);
    record->begin(arguments.resume, count);
  }
  std::atomic<int> next{0}, kept{0};
  const auto start = std::chrono::steady_clock::now();
  const auto make_next = [&](int) {  // In order, whichever thread is free.
    const SceneFrame& frame = frames[static_cast<std::size_t>(next++)];
    const std::string file = with_frame(arguments.output, frame.index);
    const std::string key = key_of(fingerprint, frame, parts.backgrounds.sha256(frame.index));
    if (record && record->is_finished(frame.index, key, file)) {
      ++kept;
      return;
    }
    const std::string sha256 = maker.write(frame, file, arguments, share.threads_each);
    if (record) record->add(frame.index, key, sha256);
  };
  parallel_for(count, share.frames_at_once, make_next, console.progress("glare headlamp"));
  if (record) record->finish();
  if (const int limited = maker.limited_frames(); limited > 0)
    console.warn("--half: pixels brighter than 65504 are limited to that (frames: " +
                 std::to_string(limited) + ")");
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  char text[160];
  std::snprintf(text, sizeof text,
                "made %d of %d frames, %d at a time, in %.3g s; %d were finished", count - kept,
                count, share.frames_at_once, time.count(), kept.load());
  console.tell(text);
}

}  // namespace glare::tool
