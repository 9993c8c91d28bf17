/// Where entities stand in the columns of the space, and their numbers; and values kept by row.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "swarmanoid_interface/expects.hpp"

namespace swarmanoid {

/// Where an entity stands in the columns. A row is used again after its entity is deleted, so it names an entity only
/// within a tick. A type of its own: neither an index of anything else nor an entity number is taken for it.
enum class Row : std::int32_t {};

/// An entity for ever: numbers begin with 1 and are never used again.
enum class EntityNumber : std::uint64_t {};

constexpr Row kNoRow{-1};
constexpr EntityNumber kNoEntity{0};

/// @pre the row is not kNoRow
constexpr std::size_t toIndex(Row row) { return static_cast<std::size_t>(row); }
constexpr Row rowAt(std::size_t index) { return static_cast<Row>(index); }

/// One value a row. Which rows exist is decided by those who derive from it.
template <class Value>
class ByRow {
 public:
  /// @pre the row exists
  Value& operator[](Row row) {
    SWARMANOID_EXPECTS(has(row));
    return values_[toIndex(row)];
  }
  const Value& operator[](Row row) const {
    SWARMANOID_EXPECTS(has(row));
    return values_[toIndex(row)];
  }

  bool has(Row row) const { return row != kNoRow && toIndex(row) < values_.size(); }

  // All values by row, those of rows without an entity among them.
  auto begin() { return values_.begin(); }
  auto end() { return values_.end(); }
  auto begin() const { return values_.begin(); }
  auto end() const { return values_.end(); }

 protected:
  ByRow() = default;

  std::vector<Value> values_;
};

/// For whoever keeps something of their own by entity: rows beyond the last that was written to do not exist until
/// `fit` makes them.
template <class Value>
class RowMap : public ByRow<Value> {
 public:
  /// Makes rows up to this one exist; those that are new get the value. @return the value of the row
  template <class... Initial>
  Value& fit(Row row, const Initial&... initial) {
    if (!this->has(row)) {
      this->values_.resize(toIndex(row) + 1, initial...);
    }
    return this->values_[toIndex(row)];
  }
  /// Rows below `count` exist, and no others.
  void resize(std::size_t count) { this->values_.resize(count); }
  void clear() { this->values_.clear(); }
};

}  // namespace swarmanoid
