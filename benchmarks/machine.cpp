#include "machine.h"

#include <fftw3.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <thread>

#include "glare/integration/vector_loops.h"

namespace glare::bench {

namespace {

std::string cpu_model() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name") && line.find(": ") != std::string::npos)
      return line.substr(line.find(": ") + 2);
  return "unknown";
}

/// Of the CPU.
std::string instruction_sets() {
#if defined(__x86_64__) && defined(__GNUC__)
  std::string out = "SSE2";
  if (__builtin_cpu_supports("sse4.2")) out += ", SSE4.2";
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) out += ", AVX2 with FMA";
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq")) out += ", AVX-512";
  return out;
#elif defined(__aarch64__)
  return "NEON";
#else
  return "unknown";
#endif
}

/// What the library chose of them.
std::string used_instruction_set() { return vector_target_name(); }

std::string compiler() {
#if defined(__clang__)
  return "Clang " __clang_version__;
#elif defined(__GNUC__)
  return "GCC " __VERSION__;
#else
  return "unknown";
#endif
}

}  // namespace

std::string cores_text() {
  double load = 0;
  char text[80];
  if (getloadavg(&load, 1) == 1)
    std::snprintf(text, sizeof text, "%u cores, load average %.1f",
                  std::thread::hardware_concurrency(), load);
  else
    std::snprintf(text, sizeof text, "%u cores", std::thread::hardware_concurrency());
  return text;
}

std::string machine_text() {
  return "- CPU: " + cpu_model() + "; " + cores_text() + " over the minute before\n" +
         "- instruction sets: " + instruction_sets() + "; the spectral stage uses " +
         used_instruction_set() + "\n- compiler: " + compiler() + ", " GLARE_BUILD_TYPE "\n" +
         "- transform: " + fftwf_version + "\n";
}

}  // namespace glare::bench
