// Snapshots of a run, and their restoration.
#include <utility>

#include "../phases/phases.hpp"
#include "../snapshot/snapshot_data.hpp"
#include "swarmanoid_interface/process/user_code.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid {

std::shared_ptr<const Snapshot> Simulation::snapshot() const {
  std::unique_ptr<Snapshot::Data> data = takeSnapshot(*world_);
  data->rules_have_begun = rules_have_begun_;
  data->is_finish_asked = finish_asked_;
  data->is_finished = finished_;
  data->player_position = player_.position();
  return std::make_shared<Snapshot>(std::move(data));
}

void Simulation::restore(const Snapshot& snapshot) {
  World& world = *world_;
  const Snapshot::Data& data = snapshot.data();
  const Duration passed = world.space.time_before_reset + (world.space.time - kEpoch);
  restoreSnapshot(world, data);
  // one more tick, so that clocks that never go back use no stamp twice
  world.space.time_before_reset = passed + world.space.clocktick - (world.space.time - kEpoch);
  ++world.space.run;
  rules_have_begun_ = data.rules_have_begun;
  has_sensed_ = false;
  finish_asked_ = data.is_finish_asked;
  finished_ = data.is_finished;
  player_.goTo(data.player_position);
  logged_overflows_ = world.space.overflows.size();
  for (ObserverInstance& observer : world.assembly.observers) {
    observer.is_finished = false;
    callPlugin("reset", observer.part, UserCode::kNoTick, [&] { observer->reset(); });
  }
  phases::index(world.space, IndexAccess(world.space), world.assembly.workers);
  finish_asked_ = phases::show(world.space, world.assembly.observers) || finish_asked_;
}

}  // namespace swarmanoid
