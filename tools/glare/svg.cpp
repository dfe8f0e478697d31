#include "svg.h"

#include <algorithm>
#include <charconv>

#include "file_names.h"
#include "glare/base/error.h"
#include "glare/io/atomic_file.h"

namespace glare::tool {

namespace {

/// How many bytes the valid UTF-8 character at `at` has, of those that XML allows; 0 for none.
std::size_t utf8_length(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t k) {
    return at + k < text.size() ? static_cast<unsigned char>(text[at + k]) : 0u;
  };
  const unsigned lead = byte(0);
  if (lead < 0x80) return lead >= ' ' && lead != 0x7F ? 1 : 0;
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : lead >= 0xC2 ? 2 : 0;
  unsigned code = lead & (0x7Fu >> length);
  for (std::size_t k = 1; k < length; ++k) {
    if ((byte(k) & 0xC0) != 0x80) return 0;
    code = code << 6 | (byte(k) & 0x3F);
  }
  constexpr unsigned kFirstOfLength[] = {0, 0, 0xA0, 0x800, 0x10000};
  const bool surrogate = code >= 0xD800 && code < 0xE000, no_character = (code & 0xFFFE) == 0xFFFE;
  if (code < kFirstOfLength[length] || code > 0x10FFFF || surrogate || no_character) return 0;
  return length;
}

}  // namespace

std::string svg_start(double width, double height, const std::string& title) {
  const std::string size = svg_number(width) + "\" height=\"" + svg_number(height);
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         "<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" width=\"" +
         size + "\" viewBox=\"0 0 " + svg_number(width) + " " + svg_number(height) +
         "\" font-family=\"sans-serif\" font-size=\"13\" fill=\"#202020\">\n<title>" +
         escaped(title) + "</title>\n<rect width=\"" + size + "\" fill=\"white\"/>\n";
}

std::string svg_number(double number) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, number, std::chars_format::fixed, 2).ptr;
  return {text, end};
}

std::string escaped(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length(text, i);
    const auto c = static_cast<unsigned char>(text[i]);
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '"')
      result += "&quot;";
    else if (length == 0)
      result += '?';
    else
      result.append(text, i, length);
    i += std::max<std::size_t>(length, 1);
  }
  return result;
}

std::string shortened(const std::string& text, std::size_t most) {
  if (text.size() <= most) return text;
  std::size_t end = most;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  return text.substr(0, end) + "...";
}

std::string svg_text(double x, double y, const std::string& attributes,
                     const std::string& content) {
  return "<text x=\"" + svg_number(x) + "\" y=\"" + svg_number(y) + "\" " + attributes + ">" +
         content + "</text>\n";
}

std::string svg_label(double x, double y, const std::string& attributes, const std::string& color,
                      const std::string& content) {
  const std::string edge = " stroke=\"white\" stroke-width=\"4\" fill=\"white\"";
  return svg_text(x, y, attributes + edge, content) +
         svg_text(x, y, attributes + " fill=\"" + color + "\"", content);
}

std::string svg_line(double x1, double y1, double x2, double y2, const std::string& attributes) {
  return "<line x1=\"" + svg_number(x1) + "\" y1=\"" + svg_number(y1) + "\" x2=\"" +
         svg_number(x2) + "\" y2=\"" + svg_number(y2) + "\" " + attributes + "/>\n";
}

void require_plot_writable(const std::string& plot, const std::string& input) {
  if (same_file(plot, input)) throw OptionError("the output " + plot + " is an input too");
  if (ending_of(plot) != ".svg")
    throw OptionError("--plot " + plot + ": expected a name that ends in .svg");
  require_writable(plot);
}

}  // namespace glare::tool
