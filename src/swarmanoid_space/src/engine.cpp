#include "swarmanoid_space/engine.hpp"

#include "swarmanoid_interface/expects.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid {

std::string Engine::unsupportedStateReason(const Space& space, Row row) const {
  std::string reason;
  space.attachments.visit(row, [&](std::size_t holder, const Attachment&) {
    if (reason.empty()) {
      reason = "holds on to something by its " + space.entities.model[row]->holders[holder].name +
               ", which this engine cannot hold";
    }
  });
  return reason;
}

void Engine::findObstacles(const RayBundle& rays, Obstacles& found) const {
  if (mayHit(rays)) {
    found.addAnywhere();
  }
}

void Engine::castRayAt(const Obstacles::Solid& /*solid*/, const Segment& /*segment*/, RayHit& /*hit*/) const {
  SWARMANOID_EXPECTS(false);  // engines that report outlines override this
}

bool Engine::blocks(Row /*row*/, const RayBundle& ray) const {
  RayHit hit;
  raycast(ray, Span<RayHit>(&hit, 1));
  return hit.isHit();
}

}  // namespace swarmanoid
