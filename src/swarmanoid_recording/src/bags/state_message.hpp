/// All named state of a space as a message, for comparing runs. Fields, units and frames: state/state_visitor.hpp.
///
/// Threads  one at a time. Allocates in each call, so only runs that request it write these messages.
#pragma once

#include <swarmanoid_msgs/NamedState.h>

#include <string>
#include <vector>

#include "swarmanoid_space/space.hpp"

namespace swarmanoid {

class StateMessage {
 public:
  /// Returns the state; with names only if they differ from the last call. Valid until the next call.
  const swarmanoid_msgs::NamedState& write(const Space& space);

 private:
  swarmanoid_msgs::NamedState message_;
  std::vector<std::string> names_;  // of the last call
};

}  // namespace swarmanoid
