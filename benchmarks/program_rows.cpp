// Rows about the glare program, started as a user starts it.
#include <string>
#include <vector>

#include "process.h"
#include "rows.h"

namespace glare::bench {

namespace {

constexpr int kStarts = 5;

std::vector<std::string> template_arguments(const ScratchFolder& folder) {
  return {"template", "--size", "512", "--fov-deg", "5", "-o", folder.path() / "eye.exr"};
}

}  // namespace

void add_program_rows(Rows& rows) {
  rows.add({"`glare template`, built-in eye, 512², 5°: the whole process, empty cache folder", "s",
            1, 0.4},
           {"program/template/cold", kStarts, false, false, [](Measurement& m) {
              const ScratchFolder folder;  // Nothing is kept of the last run.
              m.add(glare_process_s(template_arguments(folder), folder.path()));
              m.set_remark("program and libraries in the page cache");
            }});
  rows.add({"the same, cache folder of an earlier run", "s", {}, {}},
           {"program/template/again", kStarts, false, true, [](Measurement& m) {
              static const ScratchFolder folder;
              m.add(glare_process_s(template_arguments(folder), folder.path()));
            }});
  rows.add({"`glare --help`", "s", 0.1, {}},
           {"program/help", 2 * kStarts, false, false, [](Measurement& m) {
              static const ScratchFolder folder;
              m.add(glare_process_s({"--help"}, folder.path()));
            }});
}

}  // namespace glare::bench
