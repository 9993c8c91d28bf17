/// Names of frames in messages and tf: never a leading slash, and the same for one robot and for many.
#pragma once

#include <string>

namespace swarmanoid {

/// The fixed frame of all robots, z up.
constexpr const char* kWorldFrame = "world";

/// Returns `<name>/<link>`, the frame of an entity's link; kWorldFrame belongs to no entity, and is returned unchanged.
inline std::string frameOf(const std::string& entity, const std::string& link = "base_link") {
  return link == kWorldFrame ? link : entity + "/" + link;
}

}  // namespace swarmanoid
