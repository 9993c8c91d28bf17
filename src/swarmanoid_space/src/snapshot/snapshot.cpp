#include "swarmanoid_space/snapshot/snapshot.hpp"

#include <utility>

#include "snapshot_data.hpp"

namespace swarmanoid {

Snapshot::Snapshot(std::unique_ptr<const Data> data) : data_(std::move(data)) {}

Snapshot::~Snapshot() = default;

std::uint64_t Snapshot::tick() const { return data_->tick; }
std::uint64_t Snapshot::seed() const { return data_->seed; }
std::size_t Snapshot::size() const { return data_->bytes.size(); }

}  // namespace swarmanoid
