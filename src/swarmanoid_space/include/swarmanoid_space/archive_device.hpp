/// Saves and loads the structs of devices, for snapshots of a run.
///
/// Phase    between ticks.
/// Spans    keep the memory of the object that loads them: the next `sense` fills them again.
/// Errors   StateNotDefined for a struct that cannot be copied as bytes, or an instance without a function `archive`.
#pragma once

#include <type_traits>

#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/state_archive.hpp"

namespace swarmanoid {

/// @param type of the device @param device a struct of that type @param size of the struct [byte]
void archiveDevice(StateArchive& state, const char* type, void* device, std::size_t size);

template <class Device>
void archiveDevice(StateArchive& state, Device& device) {
  // numbers, vectors of Eigen and views: a device has no other members that its fields could describe
  if constexpr (std::is_trivially_destructible_v<Device> && !std::is_polymorphic_v<Device>) {
    archiveDevice(state, Device::kType, &device, sizeof(Device));
  } else {
    StateArchive::refuse();
  }
}

/// Saves or loads the members that an instance of a device adds to those of `Basic`.
template <class Basic, class Instance>
void archiveOwnMembers(StateArchive& state, Instance& instance) {
  if constexpr (StateArchive::kIsDefinedBy<Instance>) {
    instance.archive(state);
  } else if constexpr (!std::is_same_v<Instance, Basic>) {
    StateArchive::refuse();
  }
}

}  // namespace swarmanoid
