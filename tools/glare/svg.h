// Drawings as SVG 1.1: what the plots share.
#pragma once

#include <cstddef>
#include <string>

namespace glare::tool {

/// The beginning of a document on white, in user units of a pixel; its title. "</svg>" ends it.
std::string svg_start(double width, double height, const std::string& title);

/// With two decimals.
std::string svg_number(double number);

std::string svg_text(double x, double y, const std::string& attributes, const std::string& content);

/// The text on a white edge, to be read on top of lines.
std::string svg_label(double x, double y, const std::string& attributes, const std::string& color,
                      const std::string& content);

std::string svg_line(double x1, double y1, double x2, double y2, const std::string& attributes);

/// For XML: markup escaped, and a question mark for each byte that is no character of it, so that
/// no text of a file's can break the drawing.
std::string escaped(const std::string& text);

/// A text cut to what the page has room for.
std::string shortened(const std::string& text, std::size_t most);

/// Throws `OptionError` where the plot's name doesn't end in .svg or is the input's, `OutputError`
/// where it can't be written.
void require_plot_writable(const std::string& plot, const std::string& input);

}  // namespace glare::tool
