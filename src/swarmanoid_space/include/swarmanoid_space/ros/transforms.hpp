/// The frames of a space, for tf: one batch a tick for what moves, one for what does not.
///
/// Every frame has one parent: `world` for an entity's base_link, the URDF's own parent for a robot's links. So where a
/// robot's odometry began, `odom`, is a child of base_link, which has the ground truth for its parent already: what
/// REP-105 has the other way round, tf inverts by itself. Its stamp is that of the state that was read, one tick before
/// that of the poses.
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

/// "none", "base" or "full"; "auto" is nothing. @throws ConfigError
std::optional<TransformLevel> parseTransformLevel(const std::string& text);

/// Whether robots with odometry have the frame `odom`.
enum class OdometryFrames { kHidden, kShown };

class Transforms {
 public:
  /// More robots than this are seen as a swarm: without their links in tf, as list markers in rviz.
  static constexpr std::size_t kFewRobots = 20;

  /// @param level nothing: full for up to kFewRobots robots, else base; decided at the first tick that is seen
  explicit Transforms(std::optional<TransformLevel> level = std::nullopt,
                      OdometryFrames odometry = OdometryFrames::kHidden)
      : level_(level), odometry_(odometry) {}

  /// Entities that may move, turning wheels and joints. Valid until the next call.
  const tf2_msgs::TFMessage& moving(const Space& space);
  /// Everything else.
  const tf2_msgs::TFMessage& fixed(const Space& space);

 private:
  enum class Wheel { kLeft, kRight };

  /// A link, its parent, and its place on that with all joints at zero.
  struct Link {
    std::string parent;
    std::string name;
    Mount place;
    std::optional<Wheel> wheel;
    int joint = -1;  ///< that turns it, in the entity's model; -1: none
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
