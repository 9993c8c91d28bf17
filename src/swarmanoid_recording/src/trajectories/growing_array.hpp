/// A dataset of an HDF5 file that grows by rows, such as one per tick.
///
/// Shape   (rows, row shape). The first size of a row may grow too; the new elements of older rows have the blank value
///         (hdf5.hpp).
/// Buffer  rows are kept in memory until a chunk of the file is full, and written by `write`. A steady tick allocates
///         nothing here.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "hdf5.hpp"

namespace swarmanoid::trajectories {

/// Element type: its identifier in the library, and a blank value, whose size is that of an element.
struct ElementType {
  hid_t id = -1;
  std::vector<std::byte> blank;
};
ElementType elementType(NumberType type);

/// Sizes of an array, or a position in it.
struct Sizes {
  std::array<hsize_t, 8> values{};
  std::size_t rank = 0;

  Sizes() = default;
  /// @pre at most 7 sizes of a row
  Sizes(hsize_t rows, const std::vector<hsize_t>& row_shape);
  int dimensions() const { return static_cast<int>(rank); }
  const hsize_t* data() const { return values.data(); }
};

class GrowingArray {
 public:
  /// @param name with its groups, "readings/light/value", which are created
  /// @param row_shape shape of a row; empty: a row is one element @param widens whether the first size of a row may
  /// grow
  GrowingArray(hid_t file, const std::string& name, ElementType type, std::vector<hsize_t> row_shape,
               bool widens = false);

  /// Returns the memory of the next row, filled with blanks.
  std::byte* next();
  /// Appends the row that next() returned.
  void append();
  /// Sets the first size of rows from now on. Allocates. @pre not less than before
  void widen(hsize_t size);
  /// Sets elements of rows that are already appended. @param index in the rows' first size
  /// @param value of all elements at that index
  void fillBack(hsize_t first_row, hsize_t index, const std::byte* value);
  /// Passes all buffered rows to the library.
  void write();

  hsize_t rows() const { return first_ + count_; }
  hsize_t width() const { return row_shape_.empty() ? 1 : row_shape_.front(); }
  /// For attributes.
  hid_t id() const { return dataset_.get(); }

 private:
  void chooseChunk();
  void makeBuffer();
  void writeBlock(const Sizes& start, const Sizes& count, const std::byte* data);

  ElementType type_;
  std::vector<hsize_t> row_shape_;
  Sizes chunk_;  // of the file
  Hdf5Id dataset_;
  std::size_t row_bytes_ = 0;
  std::vector<std::byte> blank_row_;
  std::vector<std::byte> buffer_;  // as many rows as a chunk
  hsize_t first_ = 0;              // number of the buffer's first row
  hsize_t count_ = 0;              // number of rows in the buffer
  hsize_t written_ = 0;            // how many of these are written
};

}  // namespace swarmanoid::trajectories
