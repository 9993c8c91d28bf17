#include "dynamics3d/contacts.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "dynamics3d/boxes.hpp"
#include "dynamics3d/convex_overlap.hpp"
#include "dynamics3d/cylinders.hpp"
#include "dynamics3d/ground_contacts.hpp"
#include "dynamics3d/treels.hpp"
#include "swarmanoid_interface/expects.hpp"

namespace swarmanoid::dynamics3d {
namespace {

constexpr int kMostFound = 16;         // contacts between two solids
constexpr int kMostUsed = 4;           // of them, and of those with rough ground: three hold a surface on another
constexpr double kBounceSpeed = 0.02;  // m/s: what comes slower does not bounce

// A mirror gives way to nothing. What it crushes against a wall must not be held with more than some hundred newtons:
// in forces without a limit a contact that is found a little beside the right place spins a body like a top.
constexpr double kMirrorSoftness = 1e-3;  // m/s per N

bool isMirror(const Body* body) { return body != nullptr && body->rigid != nullptr && !body->is_dynamic; }

/// Of what was put upon each other, solids find ways out that contradict each other, or that lead into the ground. It
/// goes apart along the line between the two, on the level. @param into_a the contact's normal
Eigen::Vector3d wayOut(const Body& a, const Body& b, double depth, const Eigen::Vector3d& into_a) {
  constexpr double kDeep = 5e-3;  // m: no motion leads there
  constexpr double kSame = 1e-6;  // m
  Eigen::Vector3d way = toVector(dBodyGetPosition(a.rigid)) - toVector(dBodyGetPosition(b.rigid));
  way.z() = 0.0;
  return depth < kDeep || way.norm() < kSame ? into_a : way.normalized();
}

Eigen::AlignedBox3d boxAround(dGeomID geom) {
  dReal box[6];
  dGeomGetAABB(geom, box);
  return {Eigen::Vector3d(box[0], box[2], box[4]), Eigen::Vector3d(box[1], box[3], box[5])};
}

bool areApart(dGeomID a, dGeomID b) {
  dReal box_a[6];
  dReal box_b[6];
  dGeomGetAABB(a, box_a);
  dGeomGetAABB(b, box_b);
  return box_a[0] > box_b[1] || box_b[0] > box_a[1] || box_a[2] > box_b[3] || box_b[2] > box_a[3] ||
         box_a[4] > box_b[5] || box_b[4] > box_a[5];
}

/// Contacts of two solids of bodies. Boxes, and cylinders on flat faces or side by side, have tests of their own.
/// @param found room for kMostFound @return their number
int findContacts(dGeomID a, dGeomID b, dContactGeom* found) {
  if (dGeomGetClass(a) == dBoxClass && dGeomGetClass(b) == dBoxClass) {
    return collideBoxes(a, b, found);
  }
  int count = collideSides(a, b, found);
  if (count == 0) {
    count = collideFaces(a, b, found);
  }
  if (count == 0) {
    count = dCollide(a, b, kMostFound, found, sizeof(dContactGeom));
  }
  // of poses of a box and a cylinder that overlap ODE misses 1.5 %
  const int kind_a = dGeomGetClass(a);
  const int kind_b = dGeomGetClass(b);
  const bool may_be_missed =
      (kind_a == dBoxClass && kind_b == dCylinderClass) || (kind_a == dCylinderClass && kind_b == dBoxClass);
  return count == 0 && may_be_missed ? collideConvex(a, b, found) : count;
}

/// Whether a hand or a magnet of `robot`, of which `solid` is part, holds the object.
bool isHeldWith(const Body& robot, const Solid& solid, const Body& object) {
  const auto holds = [&](const Grip& grip) { return grip.holds(object) && grip.holder == dGeomGetBody(solid.geom); };
  return robot.holding != nullptr && std::any_of(robot.holding->grips.begin(), robot.holding->grips.end(), holds);
}

}  // namespace

void Contacts::configure(dWorldID world, const Settings& settings, const GroundSurface& ground) {
  SWARMANOID_EXPECTS(OdeLock::isHeld());
  settings_ = settings;
  ground_ = ground;
  world_ = world;
  joints_ = dJointGroupCreate(0);
  if (settings.has_ground) {
    level_ground_.geom = dCreatePlane(nullptr, 0.0, 0.0, 1.0, settings.ground_height + kMargin / 2.0);
  }
}

void Contacts::release() {
  SWARMANOID_EXPECTS(OdeLock::isHeld());
  if (joints_ != nullptr) {
    dJointGroupDestroy(joints_);
    joints_ = nullptr;
  }
  if (level_ground_.geom != nullptr) {
    dGeomDestroy(level_ground_.geom);
    level_ground_.geom = nullptr;
  }
  near_.clear();
  points_ = {};
  friction_.forget();
}

Eigen::AlignedBox3d Contacts::boundsNow(Body& body) {
  Eigen::AlignedBox3d bounds;
  for (Solid& solid : body.solids) {
    solid.box = boxAround(solid.geom);
    bounds.extend(solid.box);
  }
  return bounds;
}

void Contacts::make(const std::vector<Body*>& bodies, double step, int attempt, bool is_iterative) {
  step_ = step;
  attempt_ = attempt;
  friction_.startStep(step, settings_.gravity, attempt == 0 && !is_iterative);
  collideAll(bodies);
}

void Contacts::makeAgain(const std::vector<Body*>& bodies) {
  friction_.startAgain();
  collideAll(bodies);
}

void Contacts::collideAll(const std::vector<Body*>& bodies) {
  joints_made_ = 0;
  points_.clear();
  for (Body* body : bodies) {
    if (body->isInOde()) {
      collideGround(*body);
    }
  }
  for (const auto& [first, second] : pairs_) {
    collidePair(*bodies[static_cast<std::size_t>(first)], *bodies[static_cast<std::size_t>(second)]);
  }
}

double Contacts::depthAmongBodies(const Body& body, const Solid& solid) const {
  SWARMANOID_EXPECTS(OdeLock::isHeld());
  double deepest = 0.0;
  const auto collide = [&](const Body* other, const Eigen::AlignedBox3d&) {
    for (const Solid& other_solid : other->solids) {
      std::array<dContactGeom, kMostFound> found;
      if (other == &body || areJoined(body, *other) || areApart(solid.geom, other_solid.geom)) {
        continue;
      }
      const int count = findContacts(solid.geom, other_solid.geom, found.data());
      for (int i = 0; i < count; ++i) {
        deepest = std::max(deepest, found[static_cast<std::size_t>(i)].depth - kMargin);
      }
    }
    return true;
  };
  near_.visitNear(boxAround(solid.geom), collide);
  return deepest;
}

void Contacts::collideGround(Body& body) {
  const double reach = settings_.ground_height + kMargin / 2.0;
  for (const Solid& solid : body.solids) {
    if (ground_.isRoughAt(solid.box)) {
      collideRoughGround(body, solid);
    } else if (level_ground_.geom != nullptr && solid.box.min().z() <= reach) {
      collideSolids(body, solid, nullptr, level_ground_);
    }
  }
}

void Contacts::collideRoughGround(Body& body, const Solid& solid) {
  body.steadiness.time = 0.0;
  SurfaceContacts contacts = dynamics3d::collideGround(ground_, PlacedSolid(solid.geom), kMargin / 2.0);
  contacts.keepSpread(kMostUsed);
  for (const SurfaceContact& contact : contacts) {
    makeJoint(body, solid, nullptr, level_ground_, geometryOf(contact, solid.geom, nullptr));
  }
}

void Contacts::collidePair(Body& a, Body& b) {
  for (const Solid& solid_a : a.solids) {
    for (const Solid& solid_b : b.solids) {
      const bool are_both_balls = solid_a.kind != Solid::Kind::kPlain && solid_b.kind != Solid::Kind::kPlain;
      if (are_both_balls || !solid_a.box.intersects(solid_b.box) || isHeldWith(a, solid_a, b) ||
          isHeldWith(b, solid_b, a)) {
        continue;
      }
      // a body that drives, and one with a rigid body, comes first: ODE takes surface motion as that of its first body
      const bool swaps = solid_b.kind != Solid::Kind::kPlain || (solid_a.kind == Solid::Kind::kPlain && !a.is_dynamic);
      if (swaps) {
        collideSolids(b, solid_b, &a, solid_a);
      } else {
        collideSolids(a, solid_a, &b, solid_b);
      }
    }
  }
}

void Contacts::collideSolids(Body& a, const Solid& solid_a, Body* b, const Solid& solid_b) {
  std::array<dContactGeom, kMostFound> found;
  int count = b == nullptr ? collidePlane(solid_a.geom, solid_b.geom, found.data())
                           : findContacts(solid_a.geom, solid_b.geom, found.data());
  if (count == 0 && b == nullptr) {
    count = dCollide(solid_a.geom, solid_b.geom, kMostFound, found.data(), sizeof(dContactGeom));
  }
  // of many, as around a cylinder's face, those that are spread evenly
  const int used = std::min(count, kMostUsed);
  for (int i = 0; i < used; ++i) {
    makeJoint(a, solid_a, b, solid_b, found[static_cast<std::size_t>(i * count / used)]);
  }
}

void Contacts::makeJoint(const Body& a, const Solid& solid_a, const Body* b, const Solid& solid_b,
                         dContactGeom geometry) {
  if (b != nullptr && b->rigid != nullptr && a.island != b->island) {
    return;  // they met while one of them was moved already: the next step looks at them
  }
  const dBodyID rigid_a = dGeomGetBody(solid_a.geom);
  const dBodyID rigid_b = b == nullptr ? nullptr : dGeomGetBody(solid_b.geom);
  geometry.depth -= kMargin;  // below 0: a gap
  dContact contact = {};
  contact.geom = geometry;
  contact.surface.mode = dContactApprox1;
  contact.surface.mu = settings_.friction;
  if (b != nullptr && (isMirror(&a) || isMirror(b))) {
    Eigen::Map<Eigen::Vector3d>(contact.geom.normal) = wayOut(a, *b, geometry.depth, toVector(geometry.normal));
    contact.surface.mode |= dContactSoftCFM;
    contact.surface.soft_cfm = kMirrorSoftness;
  }
  const Eigen::Vector3d normal = toVector(contact.geom.normal);
  if (settings_.restitution > 0.0) {
    const Eigen::Vector3d point = toVector(geometry.pos);
    const double approach = -normal.dot(velocityAt(rigid_a, point) - velocityAt(rigid_b, point));
    if (approach > kBounceSpeed) {
      if (geometry.depth < 0.0) {
        return;  // slowed down to the gap it would not bounce as high
      }
      contact.surface.mode |= dContactBounce;
      contact.surface.bounce = settings_.restitution;
      contact.surface.bounce_vel = kBounceSpeed;
    }
  }
  contact.surface.mode |= dContactMotionN;
  contact.surface.motionN = std::min(geometry.depth, 0.0) / step_;
  if (solid_a.kind != Solid::Kind::kPlain) {
    driveContact(a, solid_a, settings_, step_, contact);
  }
  friction_.lay(a, rigid_a, b, rigid_b, contact);
  breakTies(contact.surface);
  points_.push_back({toVector(geometry.pos), normal});
  const dJointID joint = dJointCreateContact(world_, joints_, &contact);
  dJointAttach(joint, rigid_a, rigid_b);
  friction_.watch(joint);
}

void Contacts::breakTies(dSurfaceParameters& surface) {
  // The exact solver gives up where contacts tie, as those of a symmetric robot at rest do. These speeds are all
  // different, and far too small to be seen.
  constexpr double kMost = 1e-9;          // m/s
  constexpr double kMostFriction = 1e-6;  // of the coefficient
  constexpr double kGoldenRatio = 0.618033988749895;
  constexpr int kOtherNumbers = 997;
  const double number = std::fmod((++joints_made_ + kOtherNumbers * attempt_) * kGoldenRatio, 1.0);
  surface.motionN -= (1 + attempt_) * kMost * number;
  if (attempt_ > 0) {
    surface.mu *= 1.0 - kMostFriction * number;
  }
}

}  // namespace swarmanoid::dynamics3d
