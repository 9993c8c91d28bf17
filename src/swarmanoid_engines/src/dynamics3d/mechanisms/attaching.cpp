// Phase `connect`: suction, magnets and ropes attach and detach; the space's attachments record their state.
#include "common/grips.hpp"
#include "dynamics3d/dynamics3d.hpp"
#include "dynamics3d/mechanisms/rope.hpp"
#include "swarmanoid_space/rays/solid_ray.hpp"

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Vector3d;
using HolderKind = EntityModel::Holder::Kind;

constexpr double kCupReach = 0.01;   // m, from cups, or from a magnet, to the surface
constexpr double kCupDepth = 0.01;   // m, depth to which cups may be pressed into the surface
constexpr double kRopeSpeed = 10.0;  // m/s, of a rope that is shot

Vector3d inBody(const Body& body, const Vector3d& point) {
  return body.pose.orientation.conjugate() * (point - body.pose.position);
}

std::string brokenText(const EntityModel::Holder& holder, double strength) {
  return holder.name + ": " + tornText(strength);
}

}  // namespace

double Dynamics3d::strengthOf(HolderKind kind) const {
  switch (kind) {
    case HolderKind::kGripper:
      return settings_.grip_strength;
    case HolderKind::kSuction:
      return settings_.suction_strength;
    case HolderKind::kMagnet:
      return settings_.magnet_strength;
    case HolderKind::kRope:
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

void Dynamics3d::connectAttachments(const Space& space, const ConnectAccess& access, Body& robot) {
  const Span<const HolderCommand> commands = space.holder_commands[robot.row];
  for (std::size_t holder = 0; holder < commands.size(); ++holder) {
    const HolderKind kind = robot.holder(holder).kind;
    if (!commands[holder].is_commanded || kind == HolderKind::kGripper) {
      continue;
    }
    if (kind == HolderKind::kRope) {
      connectRope(space, access, robot, holder, toSeconds(space.clocktick));
    } else {
      connectHold(space, access, robot, holder);
    }
  }
  reportForces(access, robot);
}

void Dynamics3d::connectHold(const Space& space, const ConnectAccess& access, Body& robot, std::size_t holder) {
  const EntityModel::Holder& description = robot.holder(holder);
  Grip& hold = robot.holding->grips[holder];
  if (hold.is_broken) {
    detach(space, access, robot, holder, brokenText(description, strengthOf(description.kind)));
    hold.must_open = true;
  }
  if (!space.holder_commands[robot.row][holder].holds) {
    hold.must_open = false;
    if (hold.gripped != nullptr) {
      detach(space, access, robot, holder, description.name);
    }
    return;
  }
  if (hold.gripped != nullptr || hold.must_open) {
    return;
  }
  const Mount mount = placeOf(*robot.model, space.joints[robot.row], description.mount);
  const Vector3d at = robot.pose.toWorld(mount.position);
  const Vector3d out = robot.pose.orientation * (mount.orientation * Vector3d::UnitX());
  const bool is_magnetic = description.kind == HolderKind::kMagnet;
  const Surface surface = findSurface(robot, {at - kCupDepth * out, at + kCupReach * out}, is_magnetic);
  if (surface.can_be_held) {
    attach(space, access, robot, holder, surface, 0.0);
  }
}

void Dynamics3d::connectRope(const Space& space, const ConnectAccess& access, Body& robot, std::size_t holder,
                             double dt) {
  const EntityModel::Holder& description = robot.holder(holder);
  Rope& rope = robot.holding->ropes[holder];
  if (rope.is_broken) {
    detach(space, access, robot, holder, brokenText(description, strengthOf(HolderKind::kRope)));
    rope.must_rewind = true;
  }
  if (!space.holder_commands[robot.row][holder].holds) {
    if (rope.held != nullptr) {
      detach(space, access, robot, holder, description.name);
    }
    rope = Rope{};
    return;
  }
  if (rope.held != nullptr || rope.must_rewind) {
    return;
  }
  const double before = rope.flown;
  rope.flown = std::min(before + kRopeSpeed * dt, description.rope_length);
  const Vector3d launcher = launcherOf(robot, holder);
  const Vector3d up = robot.pose.orientation * (robot.model->mount(description.mount).orientation * Vector3d::UnitX());
  const Surface surface = findSurface(robot, {launcher, launcher + rope.flown * up}, true);
  if (surface.can_be_held) {
    attach(space, access, robot, holder, surface, (surface.point - launcher).norm());
  } else if (surface.body != nullptr || rope.flown >= description.rope_length) {
    rope = Rope{};
    rope.must_rewind = true;
    const std::string& name = space.entities.name[robot.row];
    if (surface.body == nullptr) {
      access.events.push_back({Event::Kind::kReleased, name, "", description.name + ": it met nothing"});
    } else {
      reportGrip(space, access, Event::Kind::kReleased, robot.row, surface.body->row,
                 description.name + ": what it met is not ferromagnetic");
    }
  }
}

void Dynamics3d::attach(const Space& space, const ConnectAccess& access, Body& robot, std::size_t holder,
                        const Surface& surface, double length) {
  const Attachment attachment{surface.body->row, inBody(*surface.body, surface.point), length, 0.0};
  access.attachments.attach(robot.row, holder, attachment);
  hold(robot, holder, *surface.body, attachment);
  reportGrip(space, access, Event::Kind::kAttached, robot.row, surface.body->row, robot.holder(holder).name);
}

void Dynamics3d::hold(Body& robot, std::size_t holder, Body& object, const Attachment& attachment) {
  if (robot.holding == nullptr) {
    robot.holding = std::make_unique<Holding>(*robot.model);
  }
  if (robot.holder(holder).kind == HolderKind::kRope) {
    Rope& rope = robot.holding->ropes[holder];
    rope = Rope{};
    rope.held = &object;
    rope.anchor = attachment.anchor;
    rope.length = attachment.length;
    rope.tension = attachment.force;
    return;
  }
  Grip& grip = robot.holding->grips[holder];
  grip = Grip{};
  robot.flight = Flight{};  // after detaching, a flying robot flies on from its pose at that time
  const int joint = robot.model->mount(robot.holder(holder).mount).joint;
  const bool is_on_link = joint >= 0 && !robot.links.empty();
  grip.holder = is_on_link ? robot.links[static_cast<std::size_t>(joint)].rigid : robot.rigid;
  join(grip, object);
}

void Dynamics3d::detach(const Space& space, const ConnectAccess& access, Body& robot, std::size_t holder,
                        const std::string& why) {
  reportGrip(space, access, Event::Kind::kReleased, robot.row, space.attachments.of(robot.row, holder).held, why);
  access.attachments.detach(robot.row, holder);
  if (robot.holder(holder).kind == HolderKind::kRope) {
    robot.holding->ropes[holder] = Rope{};
  } else {
    letGo(robot.holding->grips[holder]);
  }
}

void Dynamics3d::takeOverAttachments(const Space& space, Body& body) {
  if (space.attachments.isEmpty()) {
    return;
  }
  const auto takeOver = [&](Body& robot) {
    space.attachments.visit(robot.row, [&](std::size_t holder, const Attachment& attachment) {
      Body* object = find(attachment.held);
      const Body* held = nullptr;
      if (robot.holding != nullptr) {
        const bool is_rope = robot.holder(holder).kind == HolderKind::kRope;
        held = is_rope ? robot.holding->ropes[holder].held : robot.holding->grips[holder].gripped;
      }
      if (robot.is_dynamic && object != nullptr && held == nullptr &&
          (object->is_dynamic || object->rigid == nullptr)) {
        hold(robot, holder, *object, attachment);
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

void Dynamics3d::reportForces(const ConnectAccess& access, const Body& robot) {
  for (std::size_t holder = 0; holder < robot.model->holders.size(); ++holder) {
    const Rope& rope = robot.holding->ropes[holder];
    const Grip& grip = robot.holding->grips[holder];
    if (rope.held != nullptr) {
      access.attachments.update(robot.row, holder, rope.length, rope.tension);
    } else if (grip.gripped != nullptr) {
      access.attachments.update(robot.row, holder, 0.0, grip.force.norm());
    }
  }
}

std::string Dynamics3d::unsupportedStateReason(const Space& space, Row row) const {
  std::string reason;
  space.attachments.visit(row, [&](std::size_t holder, const Attachment& attachment) {
    if (reason.empty() && !space.entities.model[attachment.held]->is_movable && find(attachment.held) == nullptr) {
      reason = "its " + space.entities.model[row]->holders[holder].name + " holds on to '" +
               space.entities.name[attachment.held] + "', which is not in this engine";
    }
  });
  return reason;
}

}  // namespace swarmanoid::dynamics3d
