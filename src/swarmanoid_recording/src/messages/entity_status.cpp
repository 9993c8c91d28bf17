#include "swarmanoid_recording/messages/entity_status.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "swarmanoid_hosts/ros/device_fields.hpp"
#include "swarmanoid_recording/messages/world_state.hpp"

namespace swarmanoid {
namespace {

/// Adds the devices that have a descriptor; the numbers of others have no names.
void addDevices(const Banks& banks, Row row, std::vector<swarmanoid_msgs::DeviceStatus>& devices) {
  banks.visit(row, [&](const std::string& type, const void* device) {
    if (const DeviceType* described = findDeviceType(type)) {
      devices.push_back(statusOf(*described, device));
    }
  });
}

/// Returns the last failure under this name. Earlier entries may be of former robots with the same name.
std::string lastFailureOf(const Simulation& simulation, const std::string& robot) {
  const auto& failures = simulation.failures();
  const auto found = std::find_if(failures.rbegin(), failures.rend(),
                                  [&](const ControllerFailure& failure) { return failure.robot == robot; });
  return found == failures.rend() ? "" : found->reason;
}

void addRobot(const Simulation& simulation, Row row, swarmanoid_msgs::Inspect::Response& answer) {
  const Space& space = simulation.space();
  if (const auto status = simulation.controllerStatus(row)) {
    answer.controller = space.controllers[row].description->id;
    answer.command_source = toString(status->source);
    if (status->has_failed) {
      answer.failure = lastFailureOf(simulation, space.entities.name[row]);
    }
  }
  addDevices(space.readings, row, answer.devices);
  addDevices(space.commands, row, answer.devices);
}

/// @return the entity whose origin is nearest, the first of several; kNoRow if none is within the distance
Row nearest(const Entities& entities, const geometry_msgs::Point& near, double within) {
  const Eigen::Vector3d point(near.x, near.y, near.z);
  if (!point.allFinite() || !(within > 0.0)) {
    throw std::runtime_error("near, within: found numbers that are not finite, or a negative distance");
  }
  Row found = kNoRow;
  for (const Row row : entities.order) {
    const double distance = (entities.pose[row].position - point).norm();
    if (distance < within || (found == kNoRow && distance == within)) {
      within = distance;
      found = row;
    }
  }
  return found;
}

void addEntity(const Simulation& simulation, Row row, swarmanoid_msgs::Inspect::Response& answer) {
  const Space& space = simulation.space();
  answer.name = space.entities.name[row];
  answer.type = space.entities.model[row]->type;
  answer.engine = space.mover[row] == nullptr ? "" : space.mover[row]->id();
  answer.pose = toMessage(space.entities.pose[row]);
  answer.twist = toMessage(space.entities.twist[row]);
  const Row gripped = space.structure.grippedBy(row);
  answer.gripped = gripped == kNoRow ? "" : space.entities.name[gripped];
  addRobot(simulation, row, answer);
}

}  // namespace

void inspect(const Simulation& simulation, const swarmanoid_msgs::Inspect::Request& request,
             swarmanoid_msgs::Inspect::Response& answer) {
  const Space& space = simulation.space();
  answer.tick = space.tick;
  answer.run = space.run;
  answer.stamp = stampOf(space);
  Row row = kNoRow;
  if (!request.name.empty()) {
    row = space.entities.require(request.name);
  } else if (request.within != 0.0) {
    row = nearest(space.entities, request.near, request.within);
  }
  if (row != kNoRow) {
    addEntity(simulation, row, answer);
  }
}

}  // namespace swarmanoid
