/// The columns of the space: one value, or one list of values, per entity.
///
/// A column is declared once, as a member of its part of the space, with the phases that write it, its name, its
/// visitors and its default. Its constructor adds it to the list of columns, and all operations on columns iterate over
/// that list: a new entity gets the default of each column, data of deleted entities are removed, hashes and recordings
/// visit the columns in the order of declaration. To add a column, add this one line.
///
/// Threads  columns are made, and rows added and removed, only at a tick boundary; values of different entities may be
///          written concurrently, by the phase that writes the column.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "swarmanoid_interface/span.hpp"
#include "swarmanoid_interface/state_archive.hpp"
#include "swarmanoid_space/state/row.hpp"
#include "swarmanoid_space/state/state_visitor.hpp"

namespace swarmanoid {

/// The phases of a tick that write the values of a column; between ticks, all columns may be written. It is part of the
/// column's type, so code that takes a column for another phase does not compile (writable, access.hpp).
enum class WrittenIn : unsigned {
  kNoPhase = 0,  ///< only between ticks
  kControl = 1U << 0U,
  kActuate = 1U << 1U,
  kMove = 1U << 2U,
  kConnect = 1U << 3U,
  kIndex = 1U << 4U,
  kPower = 1U << 5U
};

constexpr WrittenIn operator|(WrittenIn a, WrittenIn b) {
  return static_cast<WrittenIn>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}
constexpr bool includes(WrittenIn phases, WrittenIn phase) {
  return (static_cast<unsigned>(phases) & static_cast<unsigned>(phase)) != 0;
}

/// The visitors of a column's values.
enum class Visits {
  kNone,        ///< none: the values are not state, or have no name outside the process
  kRecordings,  ///< recordings, to compare runs: the values follow from other state, or have no effect on it
  kHash         ///< recordings and the hash of the state
};

struct ColumnInfo {
  const char* name;  ///< of the field, or of the group of fields, in recordings
  Visits visits = Visits::kNone;
};

class Columns;

class ColumnBase {
 public:
  ColumnBase(const ColumnBase&) = delete;
  ColumnBase& operator=(const ColumnBase&) = delete;

  const ColumnInfo& info() const { return info_; }
  virtual void resize(std::size_t row_count) = 0;
  /// Resets a row to its default. @param model of its entity; null: the row has no entity any more
  virtual void reset(Row row, const EntityModel* model) = 0;
  virtual void visit(StateVisitor& visitor, const CellOwner& owner) const = 0;
  /// Saves or loads the values of all rows, for snapshots (IsKeptApart).
  virtual void archive(StateArchive& state) = 0;

 protected:
  ColumnBase(Columns& columns, const ColumnInfo& info);
  virtual ~ColumnBase();

 private:
  Columns& columns_;
  ColumnInfo info_;
};

/// The list of the columns of one space, in the order of their construction.
class Columns {
 public:
  /// Sets the number of rows in all columns.
  void resize(std::size_t row_count);
  std::size_t rowCount() const { return row_count_; }
  void reset(Row row, const EntityModel* model);
  /// Visits the values of an entity: those in the hash, and all others if the visitor wants detail.
  void visit(StateVisitor& visitor, const CellOwner& owner) const;
  /// Saves or loads all columns. @pre the number of rows is that of the saved columns
  void archive(StateArchive& state);
  std::vector<const ColumnBase*> all() const { return {columns_.begin(), columns_.end()}; }

 private:
  friend class ColumnBase;

  std::vector<ColumnBase*> columns_;
  std::size_t row_count_ = 0;
};

/// True for values that a snapshot does not keep as bytes of their column, but by entity (src/snapshot/): names,
/// pointers, and what contains them.
template <class Value>
struct IsKeptApart : std::is_pointer<Value> {};
template <>
struct IsKeptApart<std::string> : std::true_type {};
template <class Object>
struct IsKeptApart<std::unique_ptr<Object>> : std::true_type {};
template <class Object>
struct IsKeptApart<std::shared_ptr<Object>> : std::true_type {};

namespace detail {

template <class Value, class = void>
struct HasVisitCell : std::false_type {};
template <class Value>
struct HasVisitCell<Value,
                    std::void_t<decltype(visitCell(std::declval<StateVisitor&>(), "", std::declval<const CellOwner&>(),
                                                   std::declval<const Value&>()))>> : std::true_type {};

/// @pre a function `visitCell` for values of the type is declared before the column, unless it has Visits::kNone
template <class Value>
void visitIfNamed(StateVisitor& visitor, const ColumnInfo& info, const CellOwner& owner, const Value& value) {
  if constexpr (HasVisitCell<Value>::value) {
    visitCell(visitor, info.name, owner, value);
  } else {
    SWARMANOID_EXPECTS(info.visits == Visits::kNone);
  }
}

}  // namespace detail

/// One value per entity.
template <class Value, WrittenIn kPhases = WrittenIn::kNoPhase>
class Column final : public ColumnBase, public ByRow<Value> {
 public:
  Column(Columns& columns, const ColumnInfo& info, Value initial = Value{})
      : ColumnBase(columns, info), initial_(std::move(initial)) {
    Column::resize(columns.rowCount());
  }

  void resize(std::size_t row_count) override {
    if constexpr (std::is_copy_constructible_v<Value>) {
      this->values_.resize(row_count, initial_);
    } else {
      this->values_.resize(row_count);
    }
  }
  void reset(Row row, const EntityModel* /*model*/) override {
    if constexpr (std::is_copy_assignable_v<Value>) {
      (*this)[row] = initial_;
    } else {
      (*this)[row] = Value{};
    }
  }
  void visit(StateVisitor& visitor, const CellOwner& owner) const override {
    detail::visitIfNamed(visitor, info(), owner, (*this)[owner.row]);
  }
  void archive(StateArchive& state) override {
    if constexpr (!IsKeptApart<Value>::value) {
      for (Value& value : this->values_) {
        state(value);
      }
    }
  }

 private:
  Value initial_;
};

/// A list of values for each row.
template <class Value>
class ListByRow {
 public:
  /// @pre the row exists. Valid until an entity is added.
  Span<Value> operator[](Row row) { return {values_.data() + places_[row].first, places_[row].count}; }
  Span<const Value> operator[](Row row) const { return {values_.data() + places_[row].first, places_[row].count}; }

 protected:
  struct Place {
    std::size_t first = 0;
    std::size_t count = 0;
  };

  // not for plugins, which have references to columns: they cannot replace a column as a whole
  ListByRow() = default;
  ListByRow(const ListByRow&) = default;
  ListByRow(ListByRow&&) noexcept = default;
  ListByRow& operator=(const ListByRow&) = default;
  ListByRow& operator=(ListByRow&&) noexcept = default;
  ~ListByRow() = default;

  RowMap<Place> places_;
  std::vector<Value> values_;  // of all entities
};

/// A list of values per entity, of the length that its model requires.
template <class Value, WrittenIn kPhases = WrittenIn::kNoPhase>
class ListColumn final : public ColumnBase, public ListByRow<Value> {
  using Place = typename ListByRow<Value>::Place;
  using ListByRow<Value>::places_;
  using ListByRow<Value>::values_;

 public:
  using CountOf = std::size_t (*)(const EntityModel& model);
  using InitialOf = Value (*)(const EntityModel& model, std::size_t index);

  /// @param initial_of values of a new entity; null: Value{}
  ListColumn(Columns& columns, const ColumnInfo& info, CountOf count_of, InitialOf initial_of = nullptr)
      : ColumnBase(columns, info), count_of_(count_of), initial_of_(initial_of) {
    places_.resize(columns.rowCount());
  }

  void resize(std::size_t row_count) override {
    places_.resize(row_count);
    if (row_count == 0) {
      values_.clear();
      holes_.clear();
    }
  }
  void reset(Row row, const EntityModel* model) override {
    Place& place = places_[row];
    if (place.count > 0) {
      holes_[place.count].push_back(place.first);
    }
    place = findPlace(model == nullptr ? 0 : count_of_(*model));
    for (std::size_t i = 0; i < place.count; ++i) {
      values_[place.first + i] = initial_of_ == nullptr ? Value{} : initial_of_(*model, i);
    }
  }
  void visit(StateVisitor& visitor, const CellOwner& owner) const override {
    detail::visitIfNamed(visitor, info(), owner, (*this)[owner.row]);
  }
  void archive(StateArchive& state) override {
    for (Place& place : places_) {
      state(place);
    }
    state(values_, holes_);
  }

 private:
  Place findPlace(std::size_t count) {
    Place place{0, count};
    if (count == 0) {
      return place;
    }
    std::vector<std::size_t>& holes = holes_[count];
    if (holes.empty()) {
      place.first = values_.size();
      values_.resize(values_.size() + count);
    } else {
      place.first = holes.back();
      holes.pop_back();
    }
    return place;
  }

  CountOf count_of_;
  InitialOf initial_of_;
  std::map<std::size_t, std::vector<std::size_t>> holes_;  // first values of free places, by size
};

/// The column, for code of one phase. Does not compile for a column that the phase does not write.
template <WrittenIn kPhase, class Value, WrittenIn kPhases>
ByRow<Value>& writable(Column<Value, kPhases>& column) {
  static_assert(includes(kPhases, kPhase), "this phase does not write this column");
  return column;
}
template <WrittenIn kPhase, class Value, WrittenIn kPhases>
ListByRow<Value>& writable(ListColumn<Value, kPhases>& column) {
  static_assert(includes(kPhases, kPhase), "this phase does not write this column");
  return column;
}

}  // namespace swarmanoid
