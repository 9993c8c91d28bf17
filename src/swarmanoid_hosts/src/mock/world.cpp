#include "world.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "swarmanoid_interface/angle.hpp"
#include "swarmanoid_interface/devices/ground.hpp"
#include "swarmanoid_interface/devices/holders.hpp"
#include "swarmanoid_interface/devices/joints.hpp"
#include "swarmanoid_interface/devices/proximity.hpp"
#include "swarmanoid_interface/devices/sound.hpp"

namespace swarmanoid::mock {
namespace {

Eigen::Vector3d turned(const Eigen::Vector3d& vector, double angle) {
  return {std::cos(angle) * vector.x() - std::sin(angle) * vector.y(),
          std::sin(angle) * vector.x() + std::cos(angle) * vector.y(), vector.z()};
}

/// @throws ConfigError
std::vector<std::uint8_t> readBytes(const Configuration& beacon) {
  std::vector<std::uint8_t> bytes;
  const Configuration* says = beacon.find("says");
  if (says == nullptr) {
    return bytes;
  }
  std::istringstream text(says->text() + ",");  // with the last comma, an empty item at the end is read too
  for (std::string byte; std::getline(text, byte, ',');) {
    bytes.push_back(static_cast<std::uint8_t>(parseInteger(byte, "says", says->location(), {0.0, 255.0})));
  }
  if (bytes.size() > Beacon::kMostBytes) {
    throw ConfigError(says->location(), "says: found " + std::to_string(bytes.size()) + " bytes, allowed: at most " +
                                            std::to_string(Beacon::kMostBytes));
  }
  return bytes;
}

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// @param values of `joints` or `holders` @param usual the default
std::size_t readCount(const Configuration& values, std::size_t usual, std::size_t most) {
  return static_cast<std::size_t>(
      values.integer("count", static_cast<std::int64_t>(usual), {1.0, static_cast<double>(most)}));
}

void readParts(const Configuration& values, World& world) {
  if (const Configuration* joints = values.find("joints")) {
    world.joints.count = readCount(*joints, world.joints.count, Joints::kMost);
    world.joints.fastest = joints->number("fastest", world.joints.fastest, {0.0, 100.0});
    joints->refuseUnread({"count", "fastest"});
  }
  if (const Configuration* holders = values.find("holders")) {
    world.holders.count = readCount(*holders, world.holders.count, Holders::kMost);
    world.holders.rope = holders->number("rope", world.holders.rope, {0.0, 100.0});
    holders->refuseUnread({"count", "rope"});
  }
  if (const Configuration* wheels = values.find("wheels")) {
    const Range allowed{0.001, 10.0};
    world.wheels.radius = wheels->number("radius", world.wheels.radius, allowed);
    world.wheels.separation = wheels->number("separation", world.wheels.separation, allowed);
    wheels->refuseUnread({"radius", "separation"});
  }
}

}  // namespace

Eigen::Vector3d Pose::toRobot(const Eigen::Vector3d& point) const { return turned(point - position, -yaw); }

Eigen::Vector3d Pose::toWorld(const Eigen::Vector3d& point) const { return turned(point, yaw) + position; }

double World::Ring::angle(std::size_t sensor) const {
  return wrapAngle(2.0 * M_PI * static_cast<double>(sensor) / static_cast<double>(sensors));
}

World readWorld(const Configuration& values) {
  World world;
  if (const Configuration* walls = values.find("walls")) {
    for (const Configuration& wall : walls->children()) {
      constexpr std::size_t kCoordinates = 4;
      const std::vector<double> at = parseNumbers(wall.text(), kCoordinates, wall.name(), wall.location());
      world.walls.push_back({{at[0], at[1]}, {at[2], at[3]}});
    }
  }
  if (const Configuration* beacons = values.find("beacons")) {
    for (const Configuration& beacon : beacons->children()) {
      const Beacon silent;
      world.beacons.push_back({beacon.name(), beacon.vector3("at"), beacon.color("color"),
                               beacon.boolean("can_be_gripped", false), readBytes(beacon),
                               beacon.number("sound_level", silent.sound_level, Sound::kLevels),
                               beacon.number("sound_frequency", silent.sound_frequency, Sound::kFrequencies),
                               beacon.boolean("answers", silent.answers)});
      beacon.refuseUnread({"at", "color", "can_be_gripped", "says", "answers", "sound_level", "sound_frequency"});
    }
  }
  if (const Configuration* discs = values.find("discs")) {
    for (const Configuration& disc : discs->children()) {
      world.discs.push_back({disc.vector2("at"), disc.number("radius", Range{0.0, 1000.0}), disc.color("color")});
      disc.refuseUnread({"at", "radius", "color"});
    }
  }
  if (const Configuration* tags = values.find("tags")) {
    constexpr Range kWord{0.0, static_cast<double>(std::numeric_limits<std::uint32_t>::max())};
    constexpr Range kId{1.0, kWord.maximum};
    for (const Configuration& tag : tags->children()) {
      world.tags.push_back({tag.vector2("at"), static_cast<std::uint32_t>(tag.integer("id", kId)),
                            static_cast<std::uint32_t>(tag.integer("data", 0, kWord))});
      tag.refuseUnread({"at", "id", "data"});
    }
  }
  if (const Configuration* hands = values.find("hands")) {
    world.is_something_left = hands->boolean("left", world.is_something_left);
    world.is_something_right = hands->boolean("right", world.is_something_right);
    hands->refuseUnread({"left", "right"});
  }
  if (const Configuration* ring = values.find("ring")) {
    const auto usual = static_cast<std::int64_t>(world.ring.sensors);
    const Range allowed{1.0, static_cast<double>(Proximity::kMostSensors)};
    world.ring.sensors = static_cast<std::size_t>(ring->integer("sensors", usual, allowed));
    world.ring.radius = ring->number("radius", world.ring.radius, {0.0, 10.0});
    ring->refuseUnread({"sensors", "radius"});
  }
  readParts(values, world);
  world.ceiling = values.number("ceiling", world.ceiling, {0.0, 100.0});
  return world;
}

double distanceToWall(const World& world, const Eigen::Vector2d& from, double direction) {
  const Eigen::Vector2d ray(std::cos(direction), std::sin(direction));
  double nearest = std::numeric_limits<double>::infinity();
  for (const Wall& wall : world.walls) {
    const Eigen::Vector2d along = wall.to - wall.from;
    const double parallel = cross(ray, along);
    if (parallel == 0.0) {
      continue;
    }
    const double distance = cross(wall.from - from, along) / parallel;
    const double on_wall = cross(wall.from - from, ray) / parallel;
    if (distance >= 0.0 && on_wall >= 0.0 && on_wall <= 1.0) {
      nearest = std::min(nearest, distance);
    }
  }
  return nearest;
}

double wayToWall(const World& world, const Pose& pose, double angle, double radius) {
  return distanceToWall(world, pose.position.head<2>(), pose.yaw + angle) - radius;
}

float closenessOfWall(const World& world, const Pose& pose, double angle, double radius) {
  const double distance = wayToWall(world, pose, angle, radius);
  return Proximity::response(std::clamp(distance / Proximity::kUsualRange, 0.0, 1.0));
}

Color floorColorUnder(const World& world, const Pose& pose, const Eigen::Vector2d& place) {
  if (pose.position.z() > Ground::kUsualRange) {
    return colors::kBlack;
  }
  const Eigen::Vector2d point = pose.toWorld({place.x(), place.y(), 0.0}).head<2>();
  const auto top = std::find_if(world.discs.rbegin(), world.discs.rend(),
                                [&](const Disc& disc) { return (point - disc.at).norm() <= disc.radius; });
  return top == world.discs.rend() ? colors::kWhite : top->color;
}

float reflectionUnder(const World& world, const Pose& pose, const Eigen::Vector2d& place) {
  return Ground::reflection(floorColorUnder(world, pose, place));
}

}  // namespace swarmanoid::mock
