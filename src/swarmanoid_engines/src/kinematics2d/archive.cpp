// State of the engine, for snapshots: poses and grips; lists of neighbours are searched anew.
#include "kinematics2d/kinematics2d.hpp"

namespace swarmanoid::kinematics2d {

void Kinematics2d::archive(const Space& /*space*/, StateArchive& state) {
  bodies_.archive(state);
  for (const BodyIndex index : bodies_.order()) {
    Motion& record = motion(index);
    state(record.place_of_gripped, clearance(index));
    bodies_.archiveIndex(state, record.gripped);
    bodies_.archiveIndex(state, record.gripped_by);
    bodies_.archiveIndex(state, record.next_gripper);
    if (state.isLoading()) {
      neighbours(index) = Neighbours{};
    }
  }
  state(mirrors_moved_, travelled_, is_somebody_new_);
  are_lists_old_ = are_lists_old_ || state.isLoading();
}

}  // namespace swarmanoid::kinematics2d
