#include "swarmanoid_space/engine.hpp"

#include "swarmanoid_space/space.hpp"

namespace swarmanoid {

std::string Engine::unsupportedStateReason(const Space& space, Row row) const {
  std::string reason;
  space.attachments.visit(row, [&](Attachment::Kind kind, const Attachment&) {
    if (reason.empty()) {
      reason = std::string("holds on to something by its ") + toString(kind) + ", which this engine cannot hold";
    }
  });
  return reason;
}

}  // namespace swarmanoid
