/// The process that started this one.
#pragma once

namespace swarmanoid::program {

/// Makes this process end when its parent ends, for any reason.
void endWithParent();

}  // namespace swarmanoid::program
