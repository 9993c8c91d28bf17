#include "dynamics3d/contacts/touches.hpp"

#include <algorithm>
#include <array>

#include "dynamics3d/collision/boxes.hpp"
#include "dynamics3d/collision/convex_overlap.hpp"
#include "dynamics3d/collision/cylinders.hpp"
#include "dynamics3d/contacts/ground_contacts.hpp"
#include "swarmanoid_interface/expects.hpp"

namespace swarmanoid::dynamics3d {
namespace {

constexpr int kMostFound = 16;  // contacts between two solids
constexpr int kMostUsed = 4;    // of them, and of those with rough ground: three suffice to hold a surface

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
/// @param found array of kMostFound @return number of contacts
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
  // ODE misses 1.5 % of the poses in which a box and a cylinder overlap
  const int kind_a = dGeomGetClass(a);
  const int kind_b = dGeomGetClass(b);
  const bool may_be_missed =
      (kind_a == dBoxClass && kind_b == dCylinderClass) || (kind_a == dCylinderClass && kind_b == dBoxClass);
  return count == 0 && may_be_missed ? collideConvex(a, b, found) : count;
}

/// Whether a hand or a magnet of `robot` holds the object, and `solid` is on the same rigid body as that holder.
bool isHeldWith(const Body& robot, const Solid& solid, const Body& object) {
  const auto holds = [&](const Grip& grip) { return grip.holds(object) && grip.holder == dGeomGetBody(solid.geom); };
  return robot.holding != nullptr && std::any_of(robot.holding->grips.begin(), robot.holding->grips.end(), holds);
}

}  // namespace

void Touches::configure(const Settings& settings, const GroundSurface& ground) {
  SWARMANOID_EXPECTS(OdeLock::isHeld());
  ground_ = ground;
  level_ = settings.ground_height;
  if (settings.has_ground) {
    level_ground_.geom = dCreatePlane(nullptr, 0.0, 0.0, 1.0, level_ + kMargin / 2.0);
  }
}

void Touches::release() {
  SWARMANOID_EXPECTS(OdeLock::isHeld());
  if (level_ground_.geom != nullptr) {
    dGeomDestroy(level_ground_.geom);
    level_ground_.geom = nullptr;
  }
  near_.clear();
  touches_ = {};
}

Eigen::AlignedBox3d Touches::boundsNow(Body& body) {
  Eigen::AlignedBox3d bounds;
  for (Solid& solid : body.solids) {
    solid.box = boxAround(solid.geom);
    bounds.extend(solid.box);
  }
  return bounds;
}

void Touches::find(const std::vector<Body*>& bodies) {
  touches_.clear();
  for (Body* body : bodies) {
    if (body->isInOde()) {
      collideGround(*body);
    }
  }
  for (const auto& [first, second] : pairs_) {
    collidePair(*bodies[static_cast<std::size_t>(first)], *bodies[static_cast<std::size_t>(second)]);
  }
}

double Touches::depthAmongBodies(const Body& body, const Solid& solid) const {
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

void Touches::collideGround(Body& body) {
  const double reach = level_ + kMargin / 2.0;
  for (const Solid& solid : body.solids) {
    if (ground_.isRoughAt(solid.box)) {
      collideRoughGround(body, solid);
    } else if (level_ground_.geom != nullptr && solid.box.min().z() <= reach) {
      collideSolids(body, solid, nullptr, level_ground_);
    }
  }
}

void Touches::collideRoughGround(Body& body, const Solid& solid) {
  body.steadiness.time = 0.0;
  SurfaceContacts contacts = dynamics3d::collideGround(ground_, PlacedSolid(solid.geom), kMargin / 2.0);
  contacts.keepSpread(kMostUsed);
  for (const SurfaceContact& contact : contacts) {
    touches_.push_back({&body, &solid, nullptr, &level_ground_, geometryOf(contact, solid.geom, nullptr)});
  }
}

void Touches::collidePair(Body& a, Body& b) {
  for (const Solid& solid_a : a.solids) {
    for (const Solid& solid_b : b.solids) {
      const bool are_both_balls = solid_a.kind != Solid::Kind::kPlain && solid_b.kind != Solid::Kind::kPlain;
      if (are_both_balls || !solid_a.box.intersects(solid_b.box) || isHeldWith(a, solid_a, b) ||
          isHeldWith(b, solid_b, a)) {
        continue;
      }
      // bodies that drive, or have a rigid body, come first: ODE takes surface motion as that of its first body
      const bool swaps = solid_b.kind != Solid::Kind::kPlain || (solid_a.kind == Solid::Kind::kPlain && !a.is_dynamic);
      if (swaps) {
        collideSolids(b, solid_b, &a, solid_a);
      } else {
        collideSolids(a, solid_a, &b, solid_b);
      }
    }
  }
}

void Touches::collideSolids(Body& a, const Solid& solid_a, Body* b, const Solid& solid_b) {
  std::array<dContactGeom, kMostFound> found;
  int count = b == nullptr ? collidePlane(solid_a.geom, solid_b.geom, found.data())
                           : findContacts(solid_a.geom, solid_b.geom, found.data());
  if (count == 0 && b == nullptr) {
    count = dCollide(solid_a.geom, solid_b.geom, kMostFound, found.data(), sizeof(dContactGeom));
  }
  // of many contacts, as around a cylinder's face, evenly spread ones
  const int used = std::min(count, kMostUsed);
  for (int i = 0; i < used; ++i) {
    touches_.push_back({&a, &solid_a, b, &solid_b, found[static_cast<std::size_t>(i * count / used)]});
  }
}

}  // namespace swarmanoid::dynamics3d
