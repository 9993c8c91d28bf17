#include "swarmanoid_recording/messages/world_state.hpp"

#include <algorithm>
#include <stdexcept>
#include <variant>

#include "swarmanoid_experiment_files/interventions/intervention_file.hpp"
#include "swarmanoid_hosts/ros/device_messages.hpp"
#include "swarmanoid_space/intervention.hpp"

namespace swarmanoid {
namespace {

geometry_msgs::Vector3 toVector(const Eigen::Vector3d& v) {
  geometry_msgs::Vector3 message;
  message.x = v.x();
  message.y = v.y();
  message.z = v.z();
  return message;
}

/// Returns the mean colour of the lit LEDs of a robot, or the surface colour of any other entity.
std_msgs::ColorRGBA colorOf(const Space& space, Row row) {
  const EntityModel& model = *space.entities.model[row];
  if (!model.is_robot) {
    return toMessage(space.ownColor(row));
  }
  std_msgs::ColorRGBA sum;
  float lit = 0.0F;
  for (std::size_t led = 0; led < model.led_positions.size(); ++led) {
    const Color color = space.leds[row][led];
    if (color.isLit()) {
      const std_msgs::ColorRGBA one = toMessage(color);
      sum.r += one.r;
      sum.g += one.g;
      sum.b += one.b;
      lit += 1.0F;
    }
  }
  if (lit > 0.0F) {
    sum.r /= lit;
    sum.g /= lit;
    sum.b /= lit;
    sum.a = 1.0F;
  }
  return sum;
}

/// Returns whether the intervention changes visible colours.
bool changesLooks(const TakenIntervention& taken) {
  const auto* change = std::get_if<SetProperty>(&taken.what);
  return change != nullptr && (change->property == kColorProperty || change->property == kIntensity);
}

}  // namespace

ros::Time stampOf(const Space& space) { return toRosTime(space.time + space.time_before_reset); }

std::optional<ros::Time> sensedAt(const Space& space, Row row) {
  if (space.placed[row] >= space.tick) {
    return std::nullopt;
  }
  return toRosTime(space.time + space.time_before_reset - space.clocktick);
}

std_msgs::Header headerOf(const Space& space) {
  std_msgs::Header header;
  header.stamp = stampOf(space);
  header.frame_id = kWorldFrame;
  return header;
}

geometry_msgs::Point toMessage(const Eigen::Vector3d& point) {
  geometry_msgs::Point message;
  message.x = point.x();
  message.y = point.y();
  message.z = point.z();
  return message;
}

geometry_msgs::Pose toMessage(const Pose& pose) {
  geometry_msgs::Pose message;
  message.position = toMessage(pose.position);
  message.orientation.x = pose.orientation.x();
  message.orientation.y = pose.orientation.y();
  message.orientation.z = pose.orientation.z();
  message.orientation.w = pose.orientation.w();
  return message;
}

geometry_msgs::Twist toMessage(const Twist& twist) {
  geometry_msgs::Twist message;
  message.linear = toVector(twist.linear);
  message.angular = toVector(twist.angular);
  return message;
}

Pose fromMessage(const std_msgs::Header& header, const geometry_msgs::Pose& pose) {
  if (!header.frame_id.empty() && header.frame_id != kWorldFrame) {
    throw std::runtime_error("found a pose in the frame '" + header.frame_id + "', allowed: '" + kWorldFrame + "'");
  }
  const auto& q = pose.orientation;
  Pose result;
  result.position = {pose.position.x, pose.position.y, pose.position.z};
  result.orientation = Eigen::Quaterniond(q.w, q.x, q.y, q.z);
  const bool is_unset = q.x == 0.0 && q.y == 0.0 && q.z == 0.0 && q.w == 0.0;
  if (is_unset) {
    result.orientation.setIdentity();
  }
  if (!result.position.allFinite() || !result.orientation.coeffs().allFinite() || result.orientation.norm() < 1e-6) {
    throw std::runtime_error("found a pose that is not finite");
  }
  result.orientation.normalize();
  return result;
}

rosgraph_msgs::Clock clockMessage(const Space& space) {
  rosgraph_msgs::Clock clock;
  clock.clock = stampOf(space);
  return clock;
}

void toMessage(const Space& space, swarmanoid_msgs::WorldState& message) {
  const Entities& entities = space.entities;
  const std::size_t count = entities.order.size();
  message.header = headerOf(space);
  message.tick = space.tick;
  message.run = space.run;
  message.state_hash = stateHash(space);
  message.numbers.resize(count);
  message.names.resize(count);
  message.types.resize(count);
  message.poses.resize(count);
  message.twists.resize(count);
  message.engines.resize(count);
  message.gripped.resize(count);
  message.colors.resize(count);
  for (std::size_t k = 0; k < count; ++k) {
    const Row row = entities.order[k];
    message.numbers[k] = static_cast<std::uint64_t>(entities.number[row]);
    message.names[k] = entities.name[row];
    message.types[k] = entities.model[row]->type;
    message.poses[k] = toMessage(entities.pose[row]);
    message.twists[k] = toMessage(entities.twist[row]);
    message.engines[k] = space.mover[row] == nullptr ? "" : space.mover[row]->id();
    const Row gripped = space.structure.grippedBy(row);
    message.gripped[k] = gripped == kNoRow ? "" : entities.name[gripped];
    message.colors[k] = colorOf(space, row);
  }
}

void toMessage(const Space& space, const Event& event, swarmanoid_msgs::Event& message) {
  using Message = swarmanoid_msgs::Event;
  // the message's constants are the values of the enumerators
  static_assert(static_cast<int>(Event::Kind::kAttached) == Message::ATTACHED);
  static_assert(static_cast<int>(Event::Kind::kReleased) == Message::RELEASED);
  static_assert(static_cast<int>(Event::Kind::kControllerFailed) == Message::CONTROLLER_FAILED);
  static_assert(static_cast<int>(Event::Kind::kLeftArena) == Message::LEFT_ARENA);
  static_assert(static_cast<int>(Event::Kind::kOverflow) == Message::OVERFLOW);
  static_assert(static_cast<int>(Event::Kind::kSpawned) == Message::SPAWNED);
  static_assert(static_cast<int>(Event::Kind::kDeleted) == Message::DELETED);
  static_assert(static_cast<int>(Event::Kind::kMoved) == Message::MOVED);
  static_assert(static_cast<int>(Event::Kind::kIntervention) == Message::INTERVENTION);
  static_assert(static_cast<int>(Event::Kind::kFinished) == Message::FINISHED);
  static_assert(static_cast<int>(Event::Kind::kHandedOver) == Message::HANDED_OVER);
  static_assert(static_cast<int>(Event::Kind::kHandoverRefused) == Message::HANDOVER_REFUSED);
  static_assert(static_cast<int>(Event::Kind::kAnswerRefused) == Message::ANSWER_REFUSED);
  static_assert(static_cast<int>(Event::Kind::kInterventionRefused) == Message::INTERVENTION_REFUSED);
  static_assert(static_cast<int>(Event::Kind::kFellIntoHole) == Message::FELL_INTO_HOLE);
  message.header = headerOf(space);
  message.tick = space.tick;
  message.run = space.run;
  message.kind = static_cast<std::uint8_t>(event.kind);
  message.entity = event.entity;
  message.other = event.other;
  message.text = event.text;
}

void toMessage(const Space& space, const TakenIntervention& taken, swarmanoid_msgs::Intervention& message) {
  message.header = headerOf(space);
  message.tick = taken.tick;
  message.run = space.run;
  message.by = taken.asked_by;
  message.kind = kindOf(taken.what);
  message.text = toXml(taken);
}

bool OutsideChanges::look(const Space& space) {
  const std::vector<Row>& order = space.entities.order;
  const EntityNumber last = order.empty() ? kNoEntity : space.entities.number[order.back()];
  bool is_change = !has_looked_ || space.run != run_ || order.size() != count_ || last != last_;
  for (const Event& event : space.events) {
    is_change = is_change || event.kind == Event::Kind::kMoved || event.kind == Event::Kind::kSpawned ||
                event.kind == Event::Kind::kDeleted;
  }
  is_change = is_change || std::any_of(space.interventions.begin(), space.interventions.end(), changesLooks);
  has_looked_ = true;
  run_ = space.run;
  count_ = order.size();
  last_ = last;
  return is_change;
}

}  // namespace swarmanoid
