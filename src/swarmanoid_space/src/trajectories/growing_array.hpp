/// A dataset of an HDF5 file that grows by rows, such as one a tick.
///
/// Shape   (rows, row shape). The first size of a row may grow too: where rows from before have nothing, there is the
///         blank (hdf5.hpp).
/// Buffer  rows are kept in memory until a chunk of the file is full, and written at `write`. In a steady tick nothing
///         is allocated here.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "hdf5.hpp"

namespace swarmanoid::trajectories {

/// The type of the elements: one of the library, the size of an element, and the blank of that size.
struct ElementType {
  hid_t id = -1;
  std::vector<std::byte> blank;
};
ElementType elementType(NumberType type);

/// The sizes of an array, or a place in it.
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
  /// @param name with the groups it is in, "readings/light/value"; those are made
  /// @param row_shape of a row; empty: a row is one element @param widens whether its first size may grow
  GrowingArray(hid_t file, const std::string& name, ElementType type, std::vector<hsize_t> row_shape,
               bool widens = false);

  /// The memory of the next row, which is blank.
  std::byte* next();
  /// That row is complete.
  void append();
  /// Rows have this first size from now on. Allocates. @pre not less than before
  void widen(hsize_t size);
  /// Gives elements of rows that are appended already a value. @param index in the rows' first size
  /// @param value of all that is behind that index
  void fillBack(hsize_t first_row, hsize_t index, const std::byte* value);
  /// All rows go to the library.
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
  std::vector<std::byte> buffer_;  // of as many rows as a chunk has
  hsize_t first_ = 0;              // row of the buffer's first
  hsize_t count_ = 0;              // of rows in the buffer
  hsize_t written_ = 0;            // of these
};

}  // namespace swarmanoid::trajectories
