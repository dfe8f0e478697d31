#include "apply/apply_frames.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <mutex>
#include <optional>
#include <set>
#include <span>
#include <system_error>
#include <utility>

#include "apply/frame_numbers.h"
#include "apply/picture_scale.h"
#include "file_names.h"
#include "frame_record.h"
#include "glare/base/error.h"
#include "glare/base/parallel.h"
#include "glare/io/atomic_file.h"
#include "glare/io/sha256.h"
#include "interruption.h"

namespace glare::tool {

namespace {

namespace fs = std::filesystem;

bool keep_going() { return !interrupted(); }

FrameRecord record_of(const ApplyArguments& a) {
  return FrameRecord(FrameName("--output", a.output).with_placeholder());
}

/// The memory that a picture takes while it is worked on, beside the convolution's: its file, its
/// pixels, those that are changed, and for points their light and what they add.
std::uint64_t picture_bytes(const ApplyFrame& frame, const PictureDocument& document,
                            const ApplyArguments& a) {
  const std::uint64_t bytes_per_pixel = a.sources.empty() ? 28 : 52;
  std::error_code error;
  const std::uintmax_t file_bytes = fs::file_size(frame.input, error);
  return (error ? 0 : file_bytes) + bytes_per_pixel *
                                        static_cast<std::uint64_t>(document.picture().width()) *
                                        static_cast<std::uint64_t>(document.picture().height());
}

/// What is left of the memory for a convolution: not more for fewer frames at once, so that blocks,
/// and with them rounding, don't depend on it.
std::uint64_t convolution_bytes(const ApplyFrame& frame, const PictureDocument& document,
                                const GlareInputs& inputs, const ApplyArguments& a) {
  const std::uint64_t taken = picture_bytes(frame, document, a) +
                              std::uint64_t{12} *
                                  static_cast<std::uint64_t>(inputs.glare_template.width()) *
                                  static_cast<std::uint64_t>(inputs.glare_template.height());
  if (taken >= a.memory_bytes()) throw MemoryError(taken, a.memory_bytes());
  return a.memory_bytes() - taken;
}

/// What a convolution of the whole picture at once takes, rather too much: the spectra of the light
/// and of the kernel, both of the size at which nothing wraps around, and the kernel.
double whole_convolution_bytes(const PictureDocument& document, const GlareTemplate& t,
                               const PixelScale& scale) {
  const double width = document.picture().width(), height = document.picture().height();
  const double ratio = t.pixel_pitch_rad / scale.pitch_rad;
  const double across = std::min(t.width() * ratio, 2 * width);
  const double down = std::min(t.height() * ratio * scale.pixel_aspect, 2 * height);
  constexpr double kPlanes = 40, kKernel = 24, kThreads = 64 << 20;
  return kPlanes * (width + across / 2) * (height + down / 2) + kKernel * across * down + kThreads;
}

/// How the machine is shared between frames.
struct Share {
  int frames_at_once = 1;
  int threads_each = 1;
};

Share share_of(const std::vector<ApplyFrame>& frames, const PictureDocument& first,
               const GlareInputs& inputs, const ApplyArguments& a) {
  const ApplyFrame& frame = frames.front();
  const double convolution = std::min(
      whole_convolution_bytes(first, inputs.glare_template, scale_of(first, frame.input, a).scale),
      static_cast<double>(convolution_bytes(frame, first, inputs, a)));
  const double fit = static_cast<double>(a.memory_bytes()) /
                     (convolution + static_cast<double>(picture_bytes(frame, first, a)));
  const int threads = threads_used(a.threads);
  const int at_once = std::clamp(static_cast<int>(std::min(fit, 1024.0)), 1,
                                 std::min(threads, static_cast<int>(frames.size())));
  return {at_once, std::max(1, threads / at_once)};
}

/// What is told of all frames together, at the end.
class Tally {
 public:
  void add(const ApplyFrame& frame, const PictureDocument& document, const GlareOutcome& outcome,
           std::uint64_t limited_pixels) {
    const std::scoped_lock lock(mutex_);
    for (const std::string& warning : document.warnings())
      if (warnings_.insert(warning).second) lines_.push_back(frame.input + ": " + warning);
    unusable_.nan += outcome.unusable.nan;
    unusable_.infinite += outcome.unusable.infinite;
    unusable_.negative += outcome.unusable.negative;
    if (outcome.unusable.total() > 0) ++unusable_frames_;
    limited_ += limited_pixels;
    if (limited_pixels > 0) ++limited_frames_;
    if (outcome.points) ++frames_of_points_;
    points_ += outcome.points.value_or(0);
    ++frames_;
  }

  void tell(const ApplyArguments& a, const Console& console) const {
    for (const std::string& line : lines_) console.warn(line);
    if (unusable_.total() > 0)
      console.warn(a.input + ": pixels that are NaN: " + std::to_string(unusable_.nan) +
                   ", infinite: " + std::to_string(unusable_.infinite) +
                   ", with a negative channel: " + std::to_string(unusable_.negative) +
                   in_frames(unusable_frames_) +
                   "; these, or their negative channels, give no glare and stay as they are");
    if (limited_ > 0)
      console.warn(a.output + ": pixels limited to the values that the file's type holds: " +
                   std::to_string(limited_) + in_frames(limited_frames_));
    if (a.sources.empty() || frames_ == 0) return;
    if (frames_of_points_ > 0)
      console.tell("points whose glare it is: " + std::to_string(points_) +
                   in_frames(frames_of_points_));
    if (frames_of_points_ < frames_)
      console.tell(
          "--sources auto: few points don't hold all the light but 0.05 %, so the whole "
          "picture was convolved" +
          in_frames(frames_ - frames_of_points_));
  }

 private:
  std::string in_frames(int count) const {
    return frames_ > 1 ? " (in frames: " + std::to_string(count) + ")" : "";
  }

  std::mutex mutex_;
  std::set<std::string> warnings_;
  std::vector<std::string> lines_;
  UnusablePixels unusable_;
  std::uint64_t limited_ = 0, points_ = 0;
  int frames_ = 0, unusable_frames_ = 0, limited_frames_ = 0, frames_of_points_ = 0;
};

/// Writes single frames.
class FrameWriter {
 public:
  FrameWriter(const PictureDocument& first, const GlareInputs& inputs, const ApplyArguments& a)
      : inputs_(inputs), arguments_(a), glare_(a, inputs), first_(first) {}

  /// `is_first`: the content is that of the first frame, which was read.
  void write(const ApplyFrame& frame, bool is_first, int threads,
             const ProgressCallback& progress) {
    const PictureDocument document =
        is_first && first_ ? *std::exchange(first_, {}) : read_document(frame, arguments_);
    GlareWork work;
    work.scale = scale_of(document, frame.input, arguments_).scale;
    work.is_gray = document.is_gray();
    work.memory_bytes = convolution_bytes(frame, document, inputs_, arguments_);
    work.threads = threads;
    work.progress = progress;
    Picture picture = document.picture();
    const GlareOutcome outcome = apply(picture, work);
    const std::uint64_t limited = document.write(frame.output, picture, {threads, keep_going});
    tally_.add(frame, document, outcome, limited);
  }

  const Tally& tally() const { return tally_; }

 private:
  GlareOutcome apply(Picture& picture, const GlareWork& work) const {
    try {
      return glare_.apply(picture, work);
    } catch (const MemoryError& error) {  // Of all memory, not of what the convolution may take.
      const std::uint64_t all = arguments_.memory_bytes();
      throw MemoryError(error.required_bytes() + (all - error.allowed_bytes()), all);
    }
  }

  const GlareInputs& inputs_;
  const ApplyArguments& arguments_;
  PictureGlare glare_;
  std::optional<PictureDocument> first_;  ///< Until it is written.
  Tally tally_;
};

std::string frame_key(const GlareInputs& inputs, const ApplyFrame& frame) {
  const std::string all = inputs.key + "\n" + sha256_of_file(frame.input);
  return sha256_of(std::as_bytes(std::span(all.data(), all.size())));
}

/// Frames are numbered from 1 in the record, as they are there, so that its index is one less.
int record_index(const ApplyFrame& frame) { return frame.number - 1; }

FrameRecord& begin(FrameRecord& record, const std::vector<ApplyFrame>& frames,
                   const ApplyArguments& a) {
  if (a.resume) {
    std::set<std::string> names;
    for (const ApplyFrame& frame : frames) names.insert(fs::path(frame.output).filename().string());
    remove_leftovers(std::move(names), fs::path(frames.front().output).parent_path(), record);
  }
  record.begin(a.resume, frames.back().number);
  return record;
}

void write_sequence(const std::vector<ApplyFrame>& frames, const PictureDocument& first,
                    FrameWriter& writer, const GlareInputs& inputs, const ApplyArguments& a,
                    const Console& console) {
  const int count = static_cast<int>(frames.size());
  const Share share = share_of(frames, first, inputs, a);
  FrameRecord record = record_of(a);
  begin(record, frames, a);
  std::atomic<int> next{0}, kept{0};
  const auto start = std::chrono::steady_clock::now();
  const auto make_next = [&](int) {  // In order, whichever thread is free.
    const int i = next++;
    const ApplyFrame& frame = frames[static_cast<std::size_t>(i)];
    const std::string key = frame_key(inputs, frame);
    if (record.is_finished(record_index(frame), key, frame.output)) {
      ++kept;
      return;
    }
    writer.write(frame, i == 0, share.threads_each, [](double) { return keep_going(); });
    record.add(record_index(frame), key, sha256_of_file(frame.output));
  };
  parallel_for(count, share.frames_at_once, make_next, console.progress("glare apply"));
  record.finish();
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  char text[160];
  std::snprintf(text, sizeof text,
                "made %d of %d frames, %d at a time, in %.3g s; %d were finished", count - kept,
                count, share.frames_at_once, time.count(), kept.load());
  console.tell(text);
}

}  // namespace

std::vector<ApplyFrame> apply_frames_of(const ApplyArguments& a) {
  if (a.frames.empty()) return {{0, a.input, a.output}};
  const FrameName input("the picture", a.input), output("--output", a.output);
  std::vector<ApplyFrame> frames;
  for (const int number : frame_numbers_from(a.frames))
    frames.push_back({number, input(number), output(number)});
  return frames;
}

void require_files(const std::vector<ApplyFrame>& frames, const ApplyArguments& a) {
  std::set<fs::path> read, written;
  for (const std::string& file : {a.glare_template, a.ocio, a.has_sources_file() ? a.sources : ""})
    if (!file.empty()) read.insert(canonical(file));
  for (const ApplyFrame& frame : frames) read.insert(canonical(frame.input));
  const auto take = [&](const std::string& file) {
    if (read.contains(canonical(file)))
      throw OptionError("the output " + file + " is an input too");
    if (!written.insert(canonical(file)).second)
      throw OptionError("two outputs are the same file, " + file);
  };
  for (const ApplyFrame& frame : frames) take(frame.output);
  for (const ApplyFrame& frame : frames) {
    std::error_code error;
    if (!a.frames.empty() && !fs::exists(frame.input, error))
      throw InputError(frame.input, "frame " + std::to_string(frame.number) + " isn't there");
  }
  for (const ApplyFrame& frame : frames) require_writable(frame.output);
  if (a.frames.empty()) return;
  const FrameRecord record = record_of(a);
  take(record.file().string());
  record.require_writable();
}

PictureDocument read_document(const ApplyFrame& frame, const ApplyArguments& a) {
  return PictureDocument::read(frame.input, {a.part, a.layer, a.memory_bytes()});
}

void write_frames_with_glare(const std::vector<ApplyFrame>& frames, const PictureDocument& first,
                             const GlareInputs& inputs, const ApplyArguments& a,
                             const Console& console) {
  FrameWriter writer(first, inputs, a);
  if (a.frames.empty())
    writer.write(frames.front(), true, a.threads, console.progress("glare apply"));
  else
    write_sequence(frames, first, writer, inputs, a, console);
  writer.tally().tell(a, console);
}

}  // namespace glare::tool
