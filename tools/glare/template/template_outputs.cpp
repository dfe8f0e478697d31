#include "template/template_outputs.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <system_error>

#include "file_names.h"
#include "glare/base/error.h"
#include "glare/io/atomic_file.h"
#include "glare/spectrum/lamps.h"

namespace glare::tool {

namespace {

namespace fs = std::filesystem;

const std::string kPlaceholder = "{lamp}";

bool has_placeholder(const std::string& pattern) {
  return pattern.find(kPlaceholder) != std::string::npos;
}

/// The pattern with every "{lamp}" replaced.
std::string filled(const std::string& pattern, const std::string& word) {
  std::string result;
  std::size_t begin = 0;
  for (std::size_t place; (place = pattern.find(kPlaceholder, begin)) != std::string::npos;
       begin = place + kPlaceholder.size())
    result.append(pattern, begin, place - begin).append(word);
  return result.append(pattern, begin);
}

/// What a lamp is called in a file's name.
std::string word_of(const std::string& lamp) {
  std::string word = find_lamp(lamp) ? lamp : fs::path(lamp).stem().string();
  const std::string reserved = "/\\:*?\"<>|\x7f";
  for (char& c : word)
    if (static_cast<unsigned char>(c) < ' ' || reserved.find(c) != std::string::npos) c = '-';
  return word;
}

void require_placeholder(const std::string& option, const std::string& pattern) {
  if (!pattern.empty() && !has_placeholder(pattern))
    throw OptionError(option + " " + pattern +
                      ": expected {lamp} in the name, such as glare_{lamp}" +
                      fs::path(pattern).extension().string() +
                      ", since --lamp is given several "
                      "times");
}

/// A file of one kind isn't given the ending of another.
void require_no_other_ending(const std::string& path, const std::string& ending,
                             const std::string& option) {
  const std::string extension = ending_of(path);
  if (path.empty() || extension == ending) return;
  for (const char* other :
       {".exr", ".png", ".jpg", ".jpeg", ".tif", ".tiff", ".hdr", ".bmp", ".csv"})
    if (extension == other)
      throw OptionError(option + " " + path + ": expected a name that ends in " + ending);
}

std::set<fs::path> inputs_of(const TemplateArguments& a) {
  std::set<fs::path> inputs;
  for (const std::string& input : {a.pupil, a.eyelashes, a.ocio})
    if (!input.empty()) inputs.insert(canonical(input));
  for (const std::string& lamp : a.lamps)
    if (!find_lamp(lamp)) inputs.insert(canonical(lamp));
  return inputs;
}

void require_different_files(const std::vector<TemplateOutput>& outputs,
                             const TemplateArguments& arguments) {
  const std::set<fs::path> inputs = inputs_of(arguments);
  std::set<fs::path> taken;
  const auto take = [&](const std::string& file, const std::string& what_else) {
    const fs::path path = canonical(file);
    if (inputs.contains(path)) throw OptionError("the output " + file + " is an input too");
    if (!taken.insert(path).second) throw OptionError(what_else + " the same file, " + file);
  };
  for (const TemplateOutput& output : outputs) take(output.file, "two lamps' outputs are");
  for (const TemplateOutput& output : outputs)
    if (!output.preview.empty()) take(output.preview, "--output and --preview name");
}

/// The words for all lamps; throws where two are the same.
std::vector<std::string> words_of(const std::vector<std::string>& lamps) {
  std::vector<std::string> words;
  std::map<std::string, std::string> lamp_of_word;
  for (const std::string& lamp : lamps) {
    words.push_back(word_of(lamp));
    const auto [other, is_new] = lamp_of_word.emplace(in_small_letters(words.back()), lamp);
    if (!is_new)
      throw OptionError("--lamp " + other->second + " and --lamp " + lamp +
                        " would give files of the same name, with {lamp} as " + words.back());
  }
  return words;
}

}  // namespace

std::vector<TemplateOutput> template_outputs(const TemplateArguments& arguments) {
  if (arguments.lamps.size() > 1) {
    require_placeholder("--output", arguments.output);
    require_placeholder("--preview", arguments.preview);
  }
  std::vector<TemplateOutput> outputs;
  for (const std::string& word : words_of(arguments.lamps))
    outputs.push_back({filled(arguments.output, word), filled(arguments.preview, word)});
  require_different_files(outputs, arguments);
  for (const TemplateOutput& output : outputs) {
    require_no_other_ending(output.file, ".exr", "--output");
    require_no_other_ending(output.preview, ".png", "--preview");
    require_writable(output.file);
    if (!output.preview.empty()) require_writable(output.preview);
  }
  return outputs;
}

}  // namespace glare::tool
