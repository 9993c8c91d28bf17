/// The process that has started this one.
#pragma once

namespace swarmanoid::program {

/// From here on this process ends when that does, however that ends.
void endWithParent();

}  // namespace swarmanoid::program
