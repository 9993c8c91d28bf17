/// Rows and numbers of entities; and containers of values by row.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "swarmanoid_interface/expects.hpp"

namespace swarmanoid {

/// Index of an entity in the columns. A row is reused after its entity is deleted, so it identifies an entity only
/// within a tick. A separate type, so that neither other indices nor entity numbers are accepted for it.
enum class Row : std::int32_t {};

/// Permanent number of an entity: numbers begin with 1 and are never reused.
enum class EntityNumber : std::uint64_t {};

constexpr Row kNoRow{-1};
constexpr EntityNumber kNoEntity{0};

/// @pre the row is not kNoRow
constexpr std::size_t toIndex(Row row) { return static_cast<std::size_t>(row); }
constexpr Row rowAt(std::size_t index) { return static_cast<Row>(index); }

/// One value per row. Derived classes decide which rows exist.
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

  // All values by row, including those of rows without an entity.
  auto begin() { return values_.begin(); }
  auto end() { return values_.end(); }
  auto begin() const { return values_.begin(); }
  auto end() const { return values_.end(); }

 protected:
  // only for derived classes: a reference to a column of the space must not replace it as a whole
  ByRow() = default;
  ByRow(const ByRow&) = default;
  ByRow(ByRow&&) noexcept = default;
  ByRow& operator=(const ByRow&) = default;
  ByRow& operator=(ByRow&&) noexcept = default;
  ~ByRow() = default;

  std::vector<Value> values_;
};

/// For private data by entity: rows beyond the last one written do not exist until `fit` makes them.
template <class Value>
class RowMap : public ByRow<Value> {
 public:
  /// Makes all rows up to this one exist; new rows get the value. @return the value of the row
  template <class... Initial>
  Value& fit(Row row, const Initial&... initial) {
    if (!this->has(row)) {
      this->values_.resize(toIndex(row) + 1, initial...);
    }
    return this->values_[toIndex(row)];
  }
  /// Makes exactly the rows below `count` exist.
  void resize(std::size_t count) { this->values_.resize(count); }
  void clear() { this->values_.clear(); }
};

}  // namespace swarmanoid
