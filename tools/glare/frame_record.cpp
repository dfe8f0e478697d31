#include "frame_record.h"

#include <signal.h>

#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <span>
#include <sstream>
#include <system_error>
#include <vector>

#include "glare/base/error.h"
#include "glare/io/atomic_file.h"
#include "glare/io/sha256.h"

namespace glare::tool {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

const std::string kFirstLine = "{\"glare_frames\":1}\n";
constexpr std::uint64_t kMostBytes = std::uint64_t{64} << 20;

fs::path record_of(std::string pattern) {
  const std::string placeholder = "{frame}";
  for (std::size_t at; (at = pattern.find(placeholder)) != std::string::npos;)
    pattern.replace(at, placeholder.size(), "frames");
  return pattern + ".glare-frames";
}

std::string content_of(const fs::path& file) {
  const std::vector<std::byte> bytes = read_file(file, kMostBytes);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

FrameRecord::FrameRecord(const std::string& pattern) : file_(record_of(pattern)) {}

void FrameRecord::require_writable() const {
  glare::require_writable(file_);
  std::error_code error;
  if (!fs::exists(file_, error)) return;
  const std::string content = content_of(file_);
  if (!content.starts_with(kFirstLine) && !kFirstLine.starts_with(content))
    throw OutputError(file_.string(),
                      "is no record of frames, which would take its place; delete or rename it");
}

std::string FrameRecord::line_of(int frame, const Entry& entry) const {
  return Json{{"frame", frame + 1}, {"key", entry.key}, {"sha256", entry.sha256}}.dump() + "\n";
}

void FrameRecord::read(int frames) {
  std::error_code error;
  if (!fs::exists(file_, error)) return;
  std::istringstream lines(content_of(file_));
  for (std::string line; std::getline(lines, line);) {
    const Json entry = Json::parse(line, nullptr, false);
    if (!entry.is_object() || !entry.contains("frame") || !entry["frame"].is_number_integer())
      continue;
    const auto text = [&](const char* key) {
      return entry.contains(key) && entry[key].is_string() ? entry[key].get<std::string>() : "";
    };
    const auto frame = entry["frame"].get<std::int64_t>();
    if (frame < 0 || frame > frames) continue;
    entries_[static_cast<int>(frame - 1)] = {text("key"), text("sha256")};
  }
}

void FrameRecord::begin(bool resume, int frames) {
  if (resume) read(frames);
  finish();
}

bool FrameRecord::is_finished(int frame, const std::string& key, const fs::path& file) const {
  std::string sha256;
  {
    const std::scoped_lock lock(mutex_);
    const auto entry = entries_.find(frame);
    if (entry == entries_.end() || entry->second.key != key) return false;
    sha256 = entry->second.sha256;
  }
  try {
    return sha256_of_file(file) == sha256;
  } catch (const InputError&) {
    return false;
  }
}

void FrameRecord::add(int frame, const std::string& key, const std::string& sha256) {
  const std::scoped_lock lock(mutex_);
  const Entry& entry = entries_[frame] = {key, sha256};
  std::ofstream file(file_, std::ios::app | std::ios::binary);
  file << line_of(frame, entry) << std::flush;
  if (!file) throw OutputError(file_.string(), "can't be written");
}

void FrameRecord::finish() const {
  std::string content = kFirstLine;
  for (const auto& [frame, entry] : entries_) content += line_of(frame, entry);
  write_file_atomically(file_, std::as_bytes(std::span(content.data(), content.size())));
}

void remove_leftovers(std::set<std::string> names, const fs::path& folder,
                      const FrameRecord& record) {
  names.insert(record.file().filename().string());
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, error)) {
    const std::string name = entry.path().filename().string();
    const std::size_t tail = name.rfind(".glare-");
    if (name[0] != '.' || tail == std::string::npos || tail < 2) continue;
    const int process = std::atoi(name.c_str() + tail + 7);
    const bool is_gone = process > 0 && ::kill(process, 0) != 0 && errno == ESRCH;
    if (is_gone && names.contains(name.substr(1, tail - 1))) fs::remove(entry.path(), error);
  }
}

}  // namespace glare::tool
