/// All named state of a space, field by field. Its hash and what is recorded of it follow from this one list.
///
/// Units and frames  those of the space: SI, rad; poses and twists in W, anchors in the body frame of the held entity;
///                   colours 0 to 255.
/// Phase             at the end of a tick, or before the first. Reads only, so from any thread that may read the space.
#pragma once

#include <string_view>

#include "swarmanoid_space/space.hpp"

namespace swarmanoid {

/// What a field is called: "joint/turret_joint/angle", "led/3". Parts that are empty, and an index below 0, are left
/// out.
struct FieldName {
  std::string_view group;
  std::string_view member = {};
  std::string_view quantity = {};
  int index = -1;
};

/// Calls, in the order of entity numbers:
///     visitor.beginEntity(row)                     what follows is the entity's
///     visitor.beginWorld()                         what follows belongs to no entity
///     visitor.number(name, double)
///     visitor.vector(name, Eigen::Vector3d)
///     visitor.quaternion(name, Eigen::Quaterniond)
///     visitor.colors(name, first, count)           `first` is a row of kMaxLeds colours, of which `count` are in use
///     visitor.entity(name, EntityNumber)           another entity; kNoEntity: none
///     visitor.ordinal(number)                      which of a kind the next fields are of; their names say it too
///     visitor.text(name, std::string)
/// and those of `visitor.detail()`, for what follows from the rest or does nothing to it, if that is not null.
/// Nothing is copied: names live as long as the call.
template <class Visitor>
class StateVisit {
 public:
  StateVisit(const Space& space, Visitor& visitor) : space_(space), visitor_(visitor) {}

  void run() {
    for (const Row row : space_.entities.order) {
      visitor_.beginEntity(row);
      visitBody(row);
      visitJoints(row);
      visitAttachments(row);
      visitMover(row);
    }
    visitor_.beginWorld();
    visitLaserSpots();
  }

 private:
  static std::size_t at(Row row) { return static_cast<std::size_t>(row); }
  EntityNumber numberOf(Row row) const { return row == kNoRow ? kNoEntity : space_.entities.number[at(row)]; }

  void visitBody(Row row) {
    const Entities& entities = space_.entities;
    visitor_.vector({"pose", "position"}, entities.pose[at(row)].position);
    visitor_.quaternion({"pose", "orientation"}, entities.pose[at(row)].orientation);
    visitor_.vector({"twist", "linear"}, entities.twist[at(row)].linear);
    visitor_.vector({"twist", "angular"}, entities.twist[at(row)].angular);
    visitor_.colors({"led"}, space_.ledsOf(row), entities.model[at(row)]->led_positions.size());
    visitor_.entity({"gripped"}, numberOf(space_.structure.grippedBy(row)));
    if (Visitor* const detail = visitor_.detail()) {
      detail->colors({"color"}, &entities.color[at(row)], 1);
      detail->number({"outside"}, space_.outside[at(row)]);
    }
  }

  void visitJoints(Row row) {
    const auto& joints = space_.entities.model[at(row)]->joints;
    for (std::size_t joint = 0; joint < joints.size(); ++joint) {
      const JointState& state = space_.jointsOf(row)[joint];
      visitor_.number({"joint", joints[joint].name, "angle"}, state.angle);
      visitor_.number({"joint", joints[joint].name, "speed"}, state.speed);
      if (Visitor* const detail = visitor_.detail()) {
        detail->number({"joint", joints[joint].name, "effort"}, state.effort);
      }
    }
  }

  void visitAttachments(Row row) {
    space_.attachments.visit(row, [&](Attachment::Kind kind, const Attachment& attachment) {
      const std::string_view name = toString(kind);
      visitor_.ordinal(static_cast<std::uint64_t>(kind));
      visitor_.entity({"attachment", name, "held"}, numberOf(attachment.held));
      visitor_.vector({"attachment", name, "anchor"}, attachment.anchor);
      visitor_.number({"attachment", name, "length"}, attachment.length);
      if (Visitor* const detail = visitor_.detail()) {
        detail->number({"attachment", name, "force"}, attachment.force);
      }
    });
  }

  // Two runs that differ only in who moves an entity go apart later: the hash differs in the tick in which they begin
  // to. Walls may be in several engines, and none of them moves them.
  void visitMover(Row row) {
    if (space_.entities.model[at(row)]->is_movable) {
      const Engine* mover = space_.mover[at(row)];
      visitor_.text({"engine"}, mover == nullptr ? std::string() : mover->id());
    }
  }

  void visitLaserSpots() {
    for (std::size_t i = 0; i < space_.laser_spots.size(); ++i) {
      const LaserSpot& spot = space_.laser_spots[i];
      const int index = static_cast<int>(i);
      visitor_.entity({"laser_spot", {}, "owner", index}, spot.owner);
      visitor_.vector({"laser_spot", {}, "position", index}, spot.position);
    }
  }

  const Space& space_;
  Visitor& visitor_;
};

}  // namespace swarmanoid
