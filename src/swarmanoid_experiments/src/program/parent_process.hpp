/// The process that has started this one.
#pragma once

namespace swarmanoid::program {

/// From here on this process ends when its parent ends, for any reason.
void endWithParent();

}  // namespace swarmanoid::program
