/// Devices as bytes, for controllers that run in another process: one entry for each device type, here beside the
/// devices, so that a robot's computer has it too.
///
/// A device becomes its fields one after the other, each in its own precision and little-endian, without padding; a
/// variable part is its length (4 bytes) and its elements. So a controller elsewhere sees the same bits.
///
/// To let a device of your own travel, write its fields down beside it and register it, in namespace swarmanoid or the
/// device's own:
///
///     template <class Stream>
///     void fields(Stream& stream, MyDevice& device) { all(stream, device.count, device.range); }
///     REGISTER_DEVICE(MyDevice)
#pragma once

#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "swarmanoid_interface/byte_stream.hpp"

namespace swarmanoid {

struct DeviceType {
  std::string type;    ///< Device::kType
  std::string layout;  ///< its fields: "f8 f8"; two processes understand each other if theirs are equal
  void (*write)(const void* device, ByteWriter& out) = nullptr;
  /// @throws ByteError; the device is then partly read
  void (*read)(ByteReader& in, void* device, VariableParts& parts) = nullptr;
  std::shared_ptr<void> (*make)() = nullptr;        ///< a device with its initial value
  bool (*is_finite)(const void* device) = nullptr;  ///< null: it has no isFinite()
};

/// @return null if no device of that type is registered
const DeviceType* findDeviceType(const std::string& type);
/// Sorted by type.
std::vector<const DeviceType*> deviceTypes();

/// While libraries load; the first of a type stays.
void registerDeviceType(DeviceType type);

namespace detail {

template <class Device, class = void>
struct CanBeFinite : std::false_type {};
template <class Device>
struct CanBeFinite<Device, std::void_t<decltype(std::declval<const Device&>().isFinite())>> : std::true_type {};

template <class Device>
constexpr auto finiteness() -> bool (*)(const void*) {
  if constexpr (CanBeFinite<Device>::value) {
    return [](const void* device) { return static_cast<const Device*>(device)->isFinite(); };
  } else {
    return nullptr;
  }
}

}  // namespace detail

template <class Device>
struct DeviceTypeRegistration {
  DeviceTypeRegistration() {
    Device device;
    LayoutWriter layout;
    fields(layout, device);
    registerDeviceType({Device::kType, layout.text(),
                        [](const void* source, ByteWriter& out) {
                          // one list of fields serves both ways; writing changes nothing
                          fields(out, *const_cast<Device*>(static_cast<const Device*>(source)));
                        },
                        [](ByteReader& in, void* target, VariableParts& parts) {
                          parts.clear();
                          in.keepVariablePartsIn(parts);
                          fields(in, *static_cast<Device*>(target));
                        },
                        []() -> std::shared_ptr<void> { return std::make_shared<Device>(); },
                        detail::finiteness<Device>()});
  }
};

}  // namespace swarmanoid

/// In one source file of the library that has the device.
#define REGISTER_DEVICE(Device) \
  static const ::swarmanoid::DeviceTypeRegistration<Device> SWARMANOID_CONCATENATE(device_registration_, __COUNTER__);
