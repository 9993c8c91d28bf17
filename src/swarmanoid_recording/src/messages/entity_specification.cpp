#include "swarmanoid_recording/messages/entity_specification.hpp"

#include "swarmanoid_hosts/ros/device_messages.hpp"
#include "swarmanoid_recording/messages/world_state.hpp"
#include "swarmanoid_space/interventions/spawned_entity.hpp"

namespace swarmanoid {

EntityDescription toDescription(const swarmanoid_msgs::EntitySpecification& specification) {
  AskedEntity asked;
  asked.type = specification.type;
  asked.name = specification.name;
  asked.controller = specification.controller;
  asked.pose = fromMessage(specification.pose.header, specification.pose.pose);
  for (const auto& given : specification.parameters) {
    asked.values.emplace_back(given.name, given.value);
  }
  if (specification.color.a > 0.0F) {
    asked.color = fromMessage(specification.color);
  }
  return describeEntity(asked);
}

}  // namespace swarmanoid
