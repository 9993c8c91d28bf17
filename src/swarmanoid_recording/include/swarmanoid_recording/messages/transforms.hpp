/// The frames of a space, for tf: one batch a tick for moving frames, one for fixed frames.
///
/// Every frame has one parent: `world` for an entity's base_link, the URDF's own parent for a robot's links. Since
/// base_link has its ground truth, `world`, as its parent, the start of a robot's odometry, `odom`, is a child of
/// base_link. REP-105 has the two the other way round; tf inverts the transform. The stamp of `odom` is that of the
/// state that was read, one tick before that of the poses.
#pragma once

#include <tf2_msgs/TFMessage.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "swarmanoid_space/space.hpp"

namespace swarmanoid {

enum class TransformLevel {
  kNone,
  kBase,  ///< base_link of every entity
  kFull   ///< all links of robots too, wheels and joints turning
};

/// "none", "base" or "full"; returns nothing for "auto". @throws ConfigError
std::optional<TransformLevel> parseTransformLevel(const std::string& text);

/// Whether robots with odometry have the frame `odom`.
enum class OdometryFrames { kHidden, kShown };

class Transforms {
 public:
  /// More robots than this are treated as a swarm: without their links in tf, as list markers in rviz.
  static constexpr std::size_t kFewRobots = 20;

  /// @param level nothing: full for up to kFewRobots robots, else base; chosen at the first tick that is converted
  explicit Transforms(std::optional<TransformLevel> level = std::nullopt,
                      OdometryFrames odometry = OdometryFrames::kHidden)
      : level_(level), odometry_(odometry) {}

  /// Frames of entities that may move, and of turning wheels and joints. Valid until the next call.
  const tf2_msgs::TFMessage& moving(const Space& space);
  /// All other frames.
  const tf2_msgs::TFMessage& fixed(const Space& space);

 private:
  enum class Wheel { kLeft, kRight };

  /// A link, its parent, and its pose relative to the parent with all joints at zero.
  struct Link {
    std::string parent;
    std::string name;
    Mount place;
    std::optional<Wheel> wheel;
    int joint = -1;  ///< the joint of the entity's model that turns it; -1: none
    Eigen::Vector3d axis = Eigen::Vector3d::UnitY();
  };

  TransformLevel level(const Space& space);
  const std::vector<Link>& linksOf(const EntityModel& model);
  void addOdometry(const Space& space, Row row);

  std::optional<TransformLevel> level_;
  OdometryFrames odometry_;
  std::map<std::string, std::vector<Link>> links_;  // by robot type
  tf2_msgs::TFMessage moving_;
  tf2_msgs::TFMessage fixed_;
};

}  // namespace swarmanoid
