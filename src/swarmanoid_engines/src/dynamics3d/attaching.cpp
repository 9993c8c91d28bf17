// Phase `connect`: hands, magnets and ropes take hold and let go; what they hold stands in the space's attachments.
#include "common/grips.hpp"
#include "dynamics3d/dynamics3d.hpp"
#include "dynamics3d/rope.hpp"
#include "swarmanoid_space/rays/solid_ray.hpp"

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Vector3d;
using Kind = Attachment::Kind;

constexpr double kCupReach = 0.01;   // m, from a hand's cups, or from a magnet, to the surface
constexpr double kCupDepth = 0.01;   // m, by which the cups may be pressed into it
constexpr double kRopeSpeed = 10.0;  // m/s, of a rope that is shot

const char* mountOf(Kind kind) {
  return kind == Kind::kLeftHand ? "left_suction" : kind == Kind::kRightHand ? "right_suction" : "magnet";
}

Vector3d inBody(const Body& body, const Vector3d& point) {
  return body.pose.orientation.conjugate() * (point - body.pose.position);
}

std::string brokenText(Kind kind, double strength) { return std::string(toString(kind)) + ": " + tornText(strength); }

}  // namespace

bool Dynamics3d::isToldToHold(const Holding& holding, Kind kind) {
  switch (kind) {
    case Kind::kLeftHand:
      return holding.hands != nullptr && holding.hands->left;
    case Kind::kRightHand:
      return holding.hands != nullptr && holding.hands->right;
    case Kind::kMagnet:
      return holding.magnet != nullptr && holding.magnet->on;
    case Kind::kRope:
      return holding.rope_command != nullptr && holding.rope_command->shot;
  }
  return false;
}

double Dynamics3d::strengthOf(Kind kind) const {
  switch (kind) {
    case Kind::kLeftHand:
    case Kind::kRightHand:
      return settings_.suction_strength;
    case Kind::kMagnet:
      return settings_.magnet_strength;
    case Kind::kRope:
      break;
  }
  return settings_.rope_strength;
}

Dynamics3d::Surface Dynamics3d::findSurface(const Body& robot, const Segment& segment, bool is_magnetic) const {
  Surface found;
  double nearest = 1.0;
  seen_.visitNear(
      {segment.from.cwiseMin(segment.to), segment.from.cwiseMax(segment.to)},
      [&](const Body* body, const Eigen::AlignedBox3d&) {
        if (body == &robot || body->is_seen_elsewhere) {
          return true;
        }
        const double fraction = closestHit(segment, body->seen(), body->pose);
        if (fraction < nearest || (found.body != nullptr && fraction == nearest && body->number < found.body->number)) {
          found.body = find(body->row);
          nearest = fraction;
        }
        return true;
      });
  if (found.body == nullptr) {
    return found;
  }
  found.point = segment.from + nearest * (segment.to - segment.from);
  found.can_be_held = !is_magnetic || found.body->model->is_ferromagnetic;
  return found;
}

void Dynamics3d::connectAttachments(Space& space, Body& robot) {
  if (robot.holding->hands != nullptr) {
    connectHold(space, robot, Kind::kLeftHand);
    connectHold(space, robot, Kind::kRightHand);
  }
  if (robot.holding->magnet != nullptr) {
    connectHold(space, robot, Kind::kMagnet);
  }
  if (robot.holding->rope_command != nullptr) {
    connectRope(space, robot, toSeconds(space.clocktick));
  }
  reportForces(space, robot);
}

void Dynamics3d::connectHold(Space& space, Body& robot, Kind kind) {
  Grip& hold = robot.holding->grip(kind);
  if (hold.is_broken) {
    detach(space, robot, kind, brokenText(kind, strengthOf(kind)));
    hold.must_open = true;
  }
  if (!isToldToHold(*robot.holding, kind)) {
    hold.must_open = false;
    if (hold.gripped != nullptr) {
      detach(space, robot, kind, toString(kind));
    }
    return;
  }
  if (hold.gripped != nullptr || hold.must_open) {
    return;
  }
  const Mount mount = placeOf(*robot.model, space.jointsOf(robot.row), mountOf(kind));
  const Vector3d at = robot.pose.toWorld(mount.position);
  const Vector3d out = robot.pose.orientation * (mount.orientation * Vector3d::UnitX());
  const Surface surface = findSurface(robot, {at - kCupDepth * out, at + kCupReach * out}, kind == Kind::kMagnet);
  if (surface.can_be_held) {
    attach(space, robot, kind, surface, 0.0);
  }
}

void Dynamics3d::connectRope(Space& space, Body& robot, double dt) {
  Rope& rope = robot.holding->rope;
  if (rope.is_broken) {
    detach(space, robot, Kind::kRope, brokenText(Kind::kRope, strengthOf(Kind::kRope)));
    rope.must_rewind = true;
  }
  if (!isToldToHold(*robot.holding, Kind::kRope)) {
    if (rope.held != nullptr) {
      detach(space, robot, Kind::kRope, toString(Kind::kRope));
    }
    rope = Rope{};
    return;
  }
  if (rope.held != nullptr || rope.must_rewind) {
    return;
  }
  const double before = rope.flown;
  rope.flown = std::min(before + kRopeSpeed * dt, kRopeLength);
  const Vector3d launcher = launcherOf(robot);
  const Vector3d up = robot.pose.orientation * (robot.model->mount("rope_launcher").orientation * Vector3d::UnitX());
  const Surface surface = findSurface(robot, {launcher, launcher + rope.flown * up}, true);
  if (surface.can_be_held) {
    attach(space, robot, Kind::kRope, surface, (surface.point - launcher).norm());
  } else if (surface.body != nullptr || rope.flown >= kRopeLength) {
    rope = Rope{};
    rope.must_rewind = true;
    const std::string& name = space.entities.name[static_cast<std::size_t>(robot.row)];
    if (surface.body == nullptr) {
      space.events.push_back({Event::Kind::kReleased, name, "", "rope: it met nothing"});
    } else {
      reportGrip(space, Event::Kind::kReleased, robot.row, surface.body->row, "rope: what it met is not ferromagnetic");
    }
  }
}

void Dynamics3d::attach(Space& space, Body& robot, Kind kind, const Surface& surface, double length) {
  const Attachment attachment{surface.body->row, inBody(*surface.body, surface.point), length, 0.0};
  space.attachments.attach(robot.row, kind, attachment);
  hold(robot, kind, *surface.body, attachment);
  reportGrip(space, Event::Kind::kAttached, robot.row, surface.body->row, toString(kind));
}

void Dynamics3d::hold(Body& robot, Kind kind, Body& object, const Attachment& attachment) {
  if (robot.holding == nullptr) {
    robot.holding = std::make_unique<Holding>();
  }
  if (kind == Kind::kRope) {
    robot.holding->rope = Rope{};
    robot.holding->rope.held = &object;
    robot.holding->rope.anchor = attachment.anchor;
    robot.holding->rope.length = attachment.length;
    robot.holding->rope.tension = attachment.force;
    return;
  }
  Grip& grip = robot.holding->grip(kind);
  grip = Grip{};
  robot.flight = Flight{};  // wherever it comes off again, an eyebot flies on from there
  const int joint = robot.model->mount(mountOf(kind)).joint;
  const bool is_on_link = joint >= 0 && !robot.links.empty();
  grip.holder = is_on_link ? robot.links[static_cast<std::size_t>(joint)].rigid : robot.rigid;
  join(grip, object);
}

void Dynamics3d::detach(Space& space, Body& robot, Kind kind, const std::string& why) {
  reportGrip(space, Event::Kind::kReleased, robot.row, space.attachments.of(robot.row, kind).held, why);
  space.attachments.detach(robot.row, kind);
  if (kind == Kind::kRope) {
    robot.holding->rope = Rope{};
  } else {
    letGo(robot.holding->grip(kind));
  }
}

void Dynamics3d::takeOverAttachments(const Space& space, Body& body) {
  if (space.attachments.isEmpty()) {
    return;
  }
  const auto takeOver = [&](Body& robot) {
    space.attachments.visit(robot.row, [&](Kind kind, const Attachment& attachment) {
      Body* object = find(attachment.held);
      const Body* held = robot.holding == nullptr ? nullptr
                         : kind == Kind::kRope    ? robot.holding->rope.held
                                                  : robot.holding->grip(kind).gripped;
      if (robot.is_dynamic && object != nullptr && held == nullptr &&
          (object->is_dynamic || object->rigid == nullptr)) {
        hold(robot, kind, *object, attachment);
      }
    });
  };
  takeOver(body);
  for (Body* robot : order_) {
    if (robot != &body) {
      takeOver(*robot);
    }
  }
}

void Dynamics3d::reportForces(Space& space, const Body& robot) {
  if (robot.holding->rope.held != nullptr) {
    space.attachments.update(robot.row, Kind::kRope, robot.holding->rope.length, robot.holding->rope.tension);
  }
  for (const Kind kind : {Kind::kLeftHand, Kind::kRightHand, Kind::kMagnet}) {
    const Grip& grip = robot.holding->grip(kind);
    if (grip.gripped != nullptr) {
      space.attachments.update(robot.row, kind, 0.0, grip.force.norm());
    }
  }
}

std::string Dynamics3d::unsupportedStateReason(const Space& space, Row row) const {
  std::string reason;
  space.attachments.visit(row, [&](Kind kind, const Attachment& attachment) {
    const auto i = static_cast<std::size_t>(attachment.held);
    if (reason.empty() && !space.entities.model[i]->is_movable && find(attachment.held) == nullptr) {
      reason = std::string("its ") + toString(kind) + " holds on to '" + space.entities.name[i] +
               "', which is not in this engine";
    }
  });
  return reason;
}

}  // namespace swarmanoid::dynamics3d
