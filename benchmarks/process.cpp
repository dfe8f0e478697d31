#include "process.h"

#include <fcntl.h>
#include <spawn.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <stdexcept>
#include <system_error>

#include "rows.h"

namespace glare::bench {

namespace {

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> out;
  for (std::string& text : texts) out.push_back(text.data());
  out.push_back(nullptr);
  return out;
}

/// The environment with XDG_CACHE_HOME replaced.
std::vector<std::string> environment_with_cache(const std::filesystem::path& cache_folder) {
  const std::string name = "XDG_CACHE_HOME=";
  std::vector<std::string> out = {name + cache_folder.string()};
  for (char** variable = environ; *variable; ++variable)
    if (!std::string(*variable).starts_with(name)) out.emplace_back(*variable);
  return out;
}

/// The exit status; -1 where it couldn't be started or was killed.
int run(std::vector<std::string> command, std::vector<std::string> environment) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  for (const int output : {STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&actions, output, "/dev/null", O_WRONLY, 0);
  pid_t process = 0;
  const int failed = posix_spawn(&process, command[0].c_str(), &actions, nullptr,
                                 pointers(command).data(), pointers(environment).data());
  posix_spawn_file_actions_destroy(&actions);
  int status = 0;
  if (failed || waitpid(process, &status, 0) != process || !WIFEXITED(status)) return -1;
  return WEXITSTATUS(status);
}

}  // namespace

ScratchFolder::ScratchFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "glare_benchmark_XXXXXX").string();
  if (!mkdtemp(name.data())) throw std::runtime_error("no temporary folder can be made");
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

double glare_process_s(const std::vector<std::string>& arguments,
                       const std::filesystem::path& cache_folder) {
  std::vector<std::string> command = {GLARE_PROGRAM};
  command.insert(command.end(), arguments.begin(), arguments.end());
  const auto environment = environment_with_cache(cache_folder);
  int status = 0;
  const double time_s = seconds([&] { status = run(command, environment); });
  if (status != 0) throw std::runtime_error("glare " + arguments.at(0) + " failed");
  return time_s;
}

}  // namespace glare::bench
