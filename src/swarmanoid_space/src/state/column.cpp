#include "swarmanoid_space/state/column.hpp"

#include <algorithm>

namespace swarmanoid {

ColumnBase::ColumnBase(Columns& columns, const ColumnInfo& info) : columns_(columns), info_(info) {
  columns_.columns_.push_back(this);
}

ColumnBase::~ColumnBase() {
  auto& all = columns_.columns_;
  all.erase(std::find(all.begin(), all.end(), this));
}

void Columns::resize(std::size_t row_count) {
  row_count_ = row_count;
  for (ColumnBase* column : columns_) {
    column->resize(row_count);
  }
}

void Columns::reset(Row row, const EntityModel* model) {
  for (ColumnBase* column : columns_) {
    column->reset(row, model);
  }
}

void Columns::archive(StateArchive& state) {
  for (ColumnBase* column : columns_) {
    column->archive(state);
  }
}

void Columns::visit(StateVisitor& visitor, const CellOwner& owner) const {
  for (const ColumnBase* column : columns_) {
    const Visits visits = column->info().visits;
    if (visits == Visits::kHash || (visits == Visits::kRecordings && visitor.wantsDetail())) {
      column->visit(visitor, owner);
    }
  }
}

}  // namespace swarmanoid
