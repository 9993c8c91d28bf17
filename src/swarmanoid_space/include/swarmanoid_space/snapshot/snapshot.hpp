/// The whole state of a run between two ticks: entities, devices with their errors and faults, controllers, engines,
/// rules, paint, random numbers and pending interventions. Made by Simulation::snapshot.
///
/// Restored in the same simulation, or in others of the same experiment, it goes on with the same bits: the state
/// hashes of the later ticks are those of the run that was not interrupted.
///
/// Threads  const; one snapshot may be restored on several threads at once, into different simulations.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

namespace swarmanoid {

class Snapshot {
 public:
  struct Data;  ///< src/snapshot/snapshot_data.hpp

  explicit Snapshot(std::unique_ptr<const Data> data);
  ~Snapshot();
  Snapshot(const Snapshot&) = delete;
  Snapshot& operator=(const Snapshot&) = delete;

  std::uint64_t tick() const;  ///< finished ticks
  std::uint64_t seed() const;
  std::size_t size() const;  ///< of the state that is kept as bytes [byte]
  const Data& data() const { return *data_; }

 private:
  std::unique_ptr<const Data> data_;
};

}  // namespace swarmanoid
