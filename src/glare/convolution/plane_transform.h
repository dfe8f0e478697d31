// Two-dimensional transforms of real values for convolution, in slices that stay in cache.
// Internal.
//
// Sixteen columns of values are eight complex signals side by side: each line of memory holds a row
// of them, and `BlockTransform` needs nothing moved. Their spectra are then taken apart (a real
// column's spectrum S has S(-k) = conj S(k)) and stored by groups of eight frequencies, as [group]
// [column][frequency in the group], so that a group is again a block of eight signals.
#pragma once

#include <complex>
#include <cstddef>
#include <span>

#include "glare/base/aligned_buffer.h"
#include "glare/integration/block_transform.h"

namespace glare {

class PlaneTransform {
 public:
  using Complex = std::complex<float>;
  static constexpr int kColumns = 16;  ///< Side by side.
  static constexpr int kLine = 8;      ///< Complex values of a line of memory.

  /// Both lengths are products of 2, 3 and 5, even.
  PlaneTransform(int columns, int rows) : across_(columns), down_(rows) {}

  int columns() const { return across_.length(); }
  int rows() const { return down_.length(); }
  /// Of vertical frequencies 0 to rows / 2.
  int groups() const { return rows() / 2 / kLine + 1; }
  /// Where a group begins in the spectra of so many columns (a multiple of kColumns).
  std::size_t group_start(int group, int columns) const {
    return static_cast<std::size_t>(group) * static_cast<std::size_t>(columns) * kLine;
  }
  /// Complex values that they take.
  std::size_t spectra_size(int columns) const { return group_start(groups(), columns); }

  struct Workspace {
    BlockTransform::Buffer input, a, b;
  };
  /// Bytes of one, at most.
  static std::size_t workspace_bytes(int columns, int rows);

  /// Where to put sixteen columns' values, `rows` lines of kColumns; all must be set.
  std::span<float> column_input(Workspace& workspace) const;
  /// Their spectra (times 2), stored as columns `first` (a multiple of kColumns) and on of those
  /// of `columns` columns.
  void forward_columns(Workspace& workspace, int first, int columns, Complex* spectra) const;

  /// A group of one plane's column spectra, transformed across in its place; `columns` of them.
  void forward_group(Workspace& workspace, Complex* group) const;
  /// A group's columns 0 to `given` - 1, with zeros behind, transformed across, multiplied by a
  /// kernel's transformed group and transformed back: of the result, columns `first` to
  /// `first + count` - 1 are stored as 0 to `count` - 1,
  /// and zeros to a multiple of kColumns.
  void convolve_group(Workspace& workspace, Complex* group, int given, const Complex* kernel,
                      int first, int count) const;

  /// The opposite of `forward_columns`, times rows; lines of kColumns.
  std::span<const float> backward_columns(Workspace& workspace, int first, int columns,
                                          const Complex* spectra) const;

 private:
  std::span<Complex> backward_from(const BlockTransform& transform, std::span<Complex> values,
                                   Workspace& workspace) const;
  BlockTransform across_, down_;
};

}  // namespace glare
