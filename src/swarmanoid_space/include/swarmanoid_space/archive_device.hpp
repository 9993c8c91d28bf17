/// Saves and loads the structs of devices, for snapshots of a run.
///
/// Phase    between ticks.
/// Spans    archiveDevice leaves them as they are; archiveSpan saves and loads their elements.
/// Errors   StateNotDefined for a struct that cannot be copied as bytes, or an instance without a function `archive`.
#pragma once

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/state_archive.hpp"
#include "swarmanoid_space/error_models/error_model_description.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid {

/// @param type of the device @param device a struct of that type @param size of the struct [byte]
void archiveDevice(StateArchive& state, const char* type, void* device, std::size_t size);
/// The span of a device that has one. @pre the type is registered
const DeviceNumber& onlySpanOf(const char* type);

/// Saves the elements of the only span of a device, or loads them into a buffer, to which the span then points.
template <class Device, class Element>
void archiveSpan(StateArchive& state, Device& device, std::vector<Element>& buffer) {
  const DeviceNumber& span = onlySpanOf(Device::kType);
  void* const place = reinterpret_cast<std::byte*>(&device) + span.offset;
  const Span<const std::byte> elements = span.span.bytes(place);
  std::size_t size = elements.size();
  state(size);
  if (!state.isLoading()) {
    state.bytes(const_cast<std::byte*>(elements.data()), size);  // an archive that saves only reads
    return;
  }
  buffer.resize(std::max(buffer.size(), size / sizeof(Element)));
  state.bytes(buffer.data(), size);
  span.span.set(place, buffer.data(), size / sizeof(Element));
}

template <class Device>
void archiveDevice(StateArchive& state, Device& device) {
  // numbers, vectors of Eigen and views: a device has no other members that its fields could describe
  if constexpr (std::is_trivially_destructible_v<Device> && !std::is_polymorphic_v<Device>) {
    archiveDevice(state, Device::kType, &device, sizeof(Device));
  } else {
    StateArchive::refuse();
  }
}

/// Saves the faults of an instance, or gives it the saved ones; their state is saved apart.
template <class Plugin, class Instance>
void archiveFaults(const Space& space, Plugin& plugin, Instance& instance, StateArchive& state) {
  bool has_fault = instance.fault != nullptr;
  const bool had_fault = has_fault;
  state(has_fault);
  std::vector<ErrorModelDescription> errors;
  if (has_fault) {
    if (!state.isLoading()) {
      errors = plugin.faults(instance.row);
    }
    state(errors);
  }
  if (state.isLoading() && (has_fault || had_fault)) {
    plugin.setFaults(space, instance.row, errors);
  }
}

/// Saves or loads the members that an instance of a device adds to those of `Basic`. The struct declares its function
/// `archive` itself: an inherited one would leave out the members that it adds.
template <class Basic, class Instance>
void archiveOwnMembers(StateArchive& state, Instance& instance) {
  if constexpr (StateArchive::kIsDeclaredBy<Instance>) {
    instance.archive(state);
  } else if constexpr (!std::is_same_v<Instance, Basic>) {
    StateArchive::refuse();
  }
}

}  // namespace swarmanoid
