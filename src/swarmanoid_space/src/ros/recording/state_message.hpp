/// All named state of a space as a message, to compare runs by. Fields, units and frames: state/state_visitor.hpp.
///
/// Threads  one at a time. Allocates each time: only for runs that ask for it.
#pragma once

#include <swarmanoid_msgs/NamedState.h>

#include <string>
#include <vector>

#include "swarmanoid_space/space.hpp"

namespace swarmanoid {

class StateMessage {
 public:
  /// The message holds names if they are others than at the last call.
  /// Valid until the next call.
  const swarmanoid_msgs::NamedState& write(const Space& space);

 private:
  swarmanoid_msgs::NamedState message_;
  std::vector<std::string> names_;  // of the last call
};

}  // namespace swarmanoid
