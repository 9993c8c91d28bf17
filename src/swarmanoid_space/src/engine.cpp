#include "swarmanoid_space/engine.hpp"

#include "swarmanoid_interface/expects.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid {

std::string EngineLimits::unsupportedStateReason(const Space& space, Row row) const {
  if (space.structure.grippedBy(row) != kNoRow) {
    return "grips, and this engine holds no grips";
  }
  return unsupportedAttachmentReason(space, row);
}

std::string EngineLimits::unsupportedAttachmentReason(const Space& space, Row row) {
  std::string reason;
  space.attachments.visit(row, [&](std::size_t holder, const Attachment&) {
    if (reason.empty()) {
      reason = "holds on to something by its " + space.entities.model[row]->holders[holder].name +
               ", which this engine cannot hold";
    }
  });
  return reason;
}

void RayTarget::findObstacles(const RayBundle& rays, Obstacles& found) const {
  if (mayHit(rays)) {
    found.addAnywhere();
  }
}

void RayTarget::castRayAt(const Obstacles::Solid& /*solid*/, const Segment& /*segment*/, RayHit& /*hit*/) const {
  SWARMANOID_EXPECTS(false);  // engines that report outlines override this
}

bool RayTarget::blocks(Row /*row*/, const RayBundle& ray) const {
  RayHit hit;
  raycast(ray, Span<RayHit>(&hit, 1));
  return hit.isHit();
}

}  // namespace swarmanoid
