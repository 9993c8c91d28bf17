#include "swarmanoid_space/engine.hpp"

#include "swarmanoid_space/space.hpp"

namespace swarmanoid {

std::string Engine::stateRefusal(const Space& space, Row row) const {
  std::string refusal;
  space.attachments.visit(row, [&](Attachment::Kind kind, const Attachment&) {
    if (refusal.empty()) {
      refusal = std::string("holds on to something by its ") + toString(kind) + ", which this engine cannot hold";
    }
  });
  return refusal;
}

}  // namespace swarmanoid
