/// The state of a space as messages. No roscpp here: the space nodelet publishes them, the bag recorder writes them.
///
/// Frames  the fixed frame is `world`, that of an entity `<name>/base_link`; never a leading slash; the same in
///         messages about one entity and about many.
/// Stamps  simulated time, increasing even over resets; equal for all data of one state.
#pragma once

#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Twist.h>
#include <ros/time.h>
#include <rosgraph_msgs/Clock.h>
#include <std_msgs/Header.h>
#include <swarmanoid_msgs/Event.h>
#include <swarmanoid_msgs/Intervention.h>
#include <swarmanoid_msgs/WorldState.h>

#include <optional>
#include <string>

#include "swarmanoid_hosts/ros/tf_frames.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid {

/// Stamp of the current state: the end of the last tick.
ros::Time stampOf(const Space& space);
/// Stamp of the state that an entity's readings describe, one tick before stampOf. tf at this stamp is the pose at
/// which the entity sensed. @return nothing if the entity has not sensed since it was placed
std::optional<ros::Time> sensedAt(const Space& space, Row row);
/// Header in kWorldFrame, with stampOf.
std_msgs::Header headerOf(const Space& space);

geometry_msgs::Point toMessage(const Eigen::Vector3d& point);
geometry_msgs::Pose toMessage(const Pose& pose);
geometry_msgs::Twist toMessage(const Twist& twist);
/// @throws std::runtime_error if the header has another frame than kWorldFrame
Pose fromMessage(const std_msgs::Header& header, const geometry_msgs::Pose& pose);

rosgraph_msgs::Clock clockMessage(const Space& space);
/// Reuses the memory of `message`.
void toMessage(const Space& space, swarmanoid_msgs::WorldState& message);
void toMessage(const Space& space, const Event& event, swarmanoid_msgs::Event& message);
void toMessage(const Space& space, const TakenIntervention& taken, swarmanoid_msgs::Intervention& message);

/// Detects changes from outside. `look` returns true if entities were added, removed, moved or recoloured from outside
/// since the last call, and at the first call. Messages that are sent only on such occasions (fixed frames, static
/// markers) are then due.
class OutsideChanges {
 public:
  bool look(const Space& space);

 private:
  bool has_looked_ = false;
  std::uint64_t run_ = 0;
  std::size_t count_ = 0;
  EntityNumber last_ = kNoEntity;
};

}  // namespace swarmanoid
