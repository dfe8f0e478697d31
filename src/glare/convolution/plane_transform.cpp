#include "glare/convolution/plane_transform.h"

#include <algorithm>

#include "glare/convolution/spectrum_loops.h"

namespace glare {

namespace {

using Complex = PlaneTransform::Complex;
constexpr std::size_t kLine = PlaneTransform::kLine;

std::span<float> as_floats(std::span<Complex> values) {
  return {reinterpret_cast<float*>(values.data()), 2 * values.size()};  // [complex.numbers]
}

}  // namespace

std::size_t PlaneTransform::workspace_bytes(int columns, int rows) {
  return 3 * static_cast<std::size_t>(std::max(columns, rows)) * kLine * sizeof(Complex);
}

std::span<float> PlaneTransform::column_input(Workspace& workspace) const {
  return as_floats(workspace.input.values(static_cast<std::size_t>(rows()) * kLine));
}

void PlaneTransform::forward_columns(Workspace& workspace, int first, int columns,
                                     Complex* spectra) const {
  const auto length = static_cast<std::size_t>(rows());
  const std::span<Complex> input = workspace.input.values(length * kLine);
  const std::span<Complex> z = down_.forward(input.data(), kLine, workspace.a, workspace.b);
  take_columns_apart(z.data(), length, group_start(1, columns),
                     spectra + static_cast<std::size_t>(first) * kLine);
}

std::span<Complex> PlaneTransform::backward_from(const BlockTransform& transform,
                                                 std::span<Complex> values,
                                                 Workspace& workspace) const {
  BlockTransform::Buffer &a = workspace.a, &b = workspace.b;
  const bool in_a = values.data() == a.values(values.size()).data();
  return transform.backward(values.data(), kLine, in_a ? b : a, in_a ? a : b);
}

void PlaneTransform::forward_group(Workspace& workspace, Complex* group) const {
  std::ranges::copy(across_.forward(group, kLine, workspace.a, workspace.b), group);
}

void PlaneTransform::convolve_group(Workspace& workspace, Complex* group, int given,
                                    const Complex* kernel, int first, int count) const {
  const std::size_t size = static_cast<std::size_t>(columns()) * kLine;
  const std::span<Complex> input = workspace.input.values(size);
  std::copy_n(group, static_cast<std::size_t>(given) * kLine, input.begin());
  std::fill(input.begin() + given * static_cast<std::ptrdiff_t>(kLine), input.end(), Complex());
  const std::span<Complex> z = across_.forward(input.data(), kLine, workspace.a, workspace.b);
  multiply(z.data(), kernel, size);
  const std::span<Complex> result = backward_from(across_, z, workspace);
  const auto kept = static_cast<std::size_t>(count) * kLine;
  std::copy_n(result.begin() + first * static_cast<std::ptrdiff_t>(kLine), kept, group);
  // Columns are transformed in pairs: what is left in others must not drown a pair's small half.
  constexpr std::size_t kWhole = kColumns * kLine;
  std::fill(group + kept, group + (kept + kWhole - 1) / kWhole * kWhole, Complex());
}

std::span<const float> PlaneTransform::backward_columns(Workspace& workspace, int first,
                                                        int columns, const Complex* spectra) const {
  const auto length = static_cast<std::size_t>(rows());
  const std::span<Complex> z = workspace.input.values(length * kLine);
  put_columns_together(spectra + static_cast<std::size_t>(first) * kLine, group_start(1, columns),
                       length, z.data());
  return as_floats(down_.backward(z.data(), kLine, workspace.a, workspace.b));
}

}  // namespace glare
