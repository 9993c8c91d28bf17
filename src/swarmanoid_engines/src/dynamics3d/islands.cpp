#include "dynamics3d/islands.hpp"

#include <algorithm>

namespace swarmanoid::dynamics3d {
namespace {

/// Whether ODE moves the body in the step under way, be it only as a mirror.
bool isStepped(const Body& body) { return body.rigid != nullptr && !body.steadiness.is_left_out; }

template <class Visit>
void visitStepped(const std::vector<Body*>& bodies, Visit visit) {
  for (Body* body : bodies) {
    if (isStepped(*body)) {
      visit(*body);
    }
  }
}

void setEnabled(Body& body, bool is_enabled) {
  const auto set = [is_enabled](dBodyID rigid) { is_enabled ? dBodyEnable(rigid) : dBodyDisable(rigid); };
  set(body.rigid);
  for (const Link& link : body.links) {
    set(link.rigid);
  }
}

}  // namespace

void Islands::find(const std::vector<Body*>& bodies) {
  largest_ = 0;
  island_.reserve(bodies.size());
  visitStepped(bodies, [](Body& body) {
    body.island = Body::Island::kNotFound;
    dBodySetData(body.rigid, &body);
    for (const Link& link : body.links) {
      dBodySetData(link.rigid, &body);
    }
  });
  visitStepped(bodies, [this](Body& body) {
    if (body.island != Body::Island::kNotFound) {
      return;
    }
    const Size size = measure(body);
    const bool is_large = isLarge(size);
    largest_ = is_large ? std::max(largest_, size.bodies) : largest_;
    for (Body* member : island_) {
      member->island = is_large ? Body::Island::kLarge : Body::Island::kSmall;
    }
  });
  largest_ever_ = std::max(largest_ever_, largest_);
}

bool Islands::isLarge(const Size& size) {
  constexpr int kMostJoints = 64;            // of bodies that are pressed together: some eight footbots
  constexpr int kMostJointsOfGripped = 256;  // forces on grips would be rough
  return size.joints > (size.has_grips ? kMostJointsOfGripped : kMostJoints);
}

Islands::Size Islands::measure(Body& first) {
  Size size;
  island_.clear();
  island_.push_back(&first);
  first.island = Body::Island::kSmall;
  for (std::size_t i = 0; i < island_.size(); ++i) {
    Body& body = *island_[i];
    ++size.bodies;
    visitJoints(body, body.rigid, size);
    for (const Link& link : body.links) {
      visitJoints(body, link.rigid, size);
    }
  }
  return size;
}

void Islands::visitJoints(Body& body, dBodyID rigid, Size& size) {
  const int count = dBodyGetNumJoints(rigid);
  for (int i = 0; i < count; ++i) {
    const dJointID joint = dBodyGetJoint(rigid, i);
    // each joint between two bodies is met twice
    size.joints += dJointGetBody(joint, 0) == rigid ? 1 : 0;
    for (int side = 0; side < 2; ++side) {
      const dBodyID other_rigid = dJointGetBody(joint, side);
      if (other_rigid == nullptr || other_rigid == rigid) {
        continue;
      }
      auto& other = *static_cast<Body*>(dBodyGetData(other_rigid));
      size.has_grips = size.has_grips || (&other != &body && dJointGetType(joint) != dJointTypeContact);
      if (other.island == Body::Island::kNotFound) {
        other.island = Body::Island::kSmall;
        island_.push_back(&other);
      }
    }
  }
}

void Islands::enableOnly(const std::vector<Body*>& bodies, bool is_large) {
  visitStepped(bodies, [is_large](Body& body) { setEnabled(body, (body.island == Body::Island::kLarge) == is_large); });
}

void Islands::enableAll(const std::vector<Body*>& bodies) {
  visitStepped(bodies, [](Body& body) {
    setEnabled(body, true);
    body.island = Body::Island::kNotFound;
  });
}

}  // namespace swarmanoid::dynamics3d
