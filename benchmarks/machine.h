// What the figures were measured with.
#pragma once

#include <string>

namespace glare::bench {

/// CPU, cores and how busy they are, instruction sets, compiler and FFTW, as a Markdown list.
std::string machine_text();

/// How many cores there are and how busy they have been.
std::string cores_text();

}  // namespace glare::bench
