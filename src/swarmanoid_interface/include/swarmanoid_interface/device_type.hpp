/// Describes devices by name for hosts, lockstep, recordings and checks, which do not include the struct of the device.
/// The description follows from the device's descriptor, which stands beside its struct:
///
///     /// Sensor: the distance of what is ahead.
///     struct Sonar {
///       static constexpr const char* kType = "sonar";
///       double range = 3.0;  ///< [m]
///     };
///
///     template <class Visitor>
///     void fields(Visitor& visit, Sonar& sonar) {
///       visit(sonar.range, {"range", "m", "of what is ahead", {0.0, 3.0}});
///     }
///     REGISTER_DEVICE(Sonar, kSensor, "The distance of what is ahead.")
///
/// device_field.hpp says what a field may be. The values that members are given in the struct are what the device says
/// or does at rest. An actuator whose safe stop is another one than that (safe_stop.hpp) has, above REGISTER_DEVICE,
///
///     inline bool stopSafely(MyDevice& command, const SafeStopMoment& moment) { ...; return true; }
///
/// A device that is built into robots of one type only names it, `static constexpr const char* kRobot = "footbot";`.
/// Every robot may have the others.
///
/// As bytes a device is its fields one after the other, each in its own precision and little-endian, without padding; a
/// span is its length (4 bytes) and its elements. A controller in another process therefore reads the same bits.
///
/// Threads  devices register while a library loads (one thread); afterwards they are only read, from any thread.
#pragma once

#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "swarmanoid_interface/byte_stream.hpp"
#include "swarmanoid_interface/device_field.hpp"

namespace swarmanoid {

struct SafeStopMoment;

enum class DeviceKind { kSensor, kActuator };

struct DeviceType {
  std::string type;  ///< Device::kType
  DeviceKind kind = DeviceKind::kSensor;
  std::string summary;  ///< one sentence
  std::vector<FieldDescription> fields;
  std::vector<DeviceNumber> numbers;  ///< in the order of the bytes
  std::string layout;  ///< of the bytes: "f8 f8"; two processes can exchange the device if theirs are equal
  void (*write)(const void* device, ByteWriter& out) = nullptr;
  /// @throws ByteError; the device is then partly read
  void (*read)(ByteReader& in, void* device, VariableParts& parts) = nullptr;
  std::shared_ptr<void> (*make)() = nullptr;        ///< makes a device at rest
  bool (*is_finite)(const void* device) = nullptr;  ///< returns isFinite of the device
  /// The safe stop of actuators, see safe_stop.hpp; null for sensors. @return whether the stop is over
  bool (*stop)(void* command, const SafeStopMoment& moment) = nullptr;
  std::string robot{};        ///< Device::kRobot: only robots of this type have the device; "": any
  bool has_own_stop = false;  ///< `stopSafely` stands beside the struct; else the safe stop is what it does at rest
  std::string name{};         ///< of the struct
  std::string header{};       ///< that the struct is in, as it is included
};

/// @return null if no device of that type is registered
const DeviceType* findDeviceType(const std::string& type);
/// Returns all types, sorted by type.
std::vector<const DeviceType*> deviceTypes();

/// Returns the robot types that devices name, sorted. A robot that consists of devices for any robot is none of them.
std::vector<std::string> robotTypesOfDevices();

/// Registers a type while a library loads; the first registration of a type stays.
void registerDeviceType(DeviceType type);

/// Returns the names of the numbers in the order of the bytes, "left right"; behind that of a span stand those in its
/// elements: "blobs(color.red distance) overflowed".
std::string fieldNames(const DeviceType& device);

/// Returns how a header is included, "my_package/sonar.hpp": what follows the last folder `include` of its path, or its
/// name if there is no such folder.
std::string includedAs(const std::string& file);

/// Returns "sensor" or "actuator".
const char* toString(DeviceKind kind);

namespace detail {

template <class Device, class = void>
struct HasFields : std::false_type {};
template <class Device>
struct HasFields<Device, std::void_t<decltype(fields(std::declval<LayoutWriter&>(), std::declval<Device&>()))>>
    : std::true_type {};

template <class Device, class = void>
struct HasSafeStop : std::false_type {};
template <class Device>
struct HasSafeStop<Device,
                   std::void_t<decltype(stopSafely(std::declval<Device&>(), std::declval<const SafeStopMoment&>()))>>
    : std::true_type {};

template <class Device, class = void>
struct HasRobot : std::false_type {};
template <class Device>
struct HasRobot<Device, std::void_t<decltype(Device::kRobot)>> : std::true_type {};

/// @return the device's own robot; "" if every robot may have it
template <class Device>
std::string robotOf() {
  if constexpr (HasRobot<Device>::value) {
    return Device::kRobot;
  } else {
    return "";
  }
}

/// Applies the device's own safe stop, or its command at rest if it has none.
template <class Device>
bool stop(Device& command, const SafeStopMoment& moment) {
  if constexpr (HasSafeStop<Device>::value) {
    return stopSafely(command, moment);
  } else {
    command = Device{};
    return true;
  }
}

template <class Device>
DeviceType makeDeviceType(DeviceKind kind, const std::string& summary) {
  Device device;
  LayoutWriter layout;
  fields(layout, device);
  FieldLister lister(&device);
  fields(lister, device);
  DeviceType type{Device::kType, kind, summary, lister.takeFields(), lister.takeNumbers(), layout.text()};
  type.robot = robotOf<Device>();
  type.write = [](const void* source, ByteWriter& out) {
    // the same list of fields serves reading and writing; writing changes nothing
    fields(out, *const_cast<Device*>(static_cast<const Device*>(source)));
  };
  type.read = [](ByteReader& in, void* target, VariableParts& parts) {
    parts.clear();
    in.keepVariablePartsIn(parts);
    fields(in, *static_cast<Device*>(target));
  };
  type.make = []() -> std::shared_ptr<void> { return std::make_shared<Device>(); };
  type.is_finite = [](const void* source) { return isFinite(*static_cast<const Device*>(source)); };
  if (kind == DeviceKind::kActuator) {
    type.stop = [](void* command, const SafeStopMoment& moment) {
      return stop(*static_cast<Device*>(command), moment);
    };
    type.has_own_stop = HasSafeStop<Device>::value;
  }
  return type;
}

}  // namespace detail

/// Whether the function `fields` is defined beside the device.
template <class Device>
constexpr bool kHasFields = detail::HasFields<Device>::value;

template <class Device>
struct DeviceRegistration {
  DeviceRegistration(DeviceKind kind, const char* summary, const char* name, const char* file) {
    DeviceType type = detail::makeDeviceType<Device>(kind, summary);
    type.name = name;
    type.header = includedAs(file);
    registerDeviceType(std::move(type));
  }
};

}  // namespace swarmanoid

/// Stands below the device's struct and its fields, in the same header and namespace: every library that includes the
/// header registers the device. @param kind kSensor or kActuator @param summary one sentence
#define REGISTER_DEVICE(Device, kind, summary)                                           \
  inline const ::swarmanoid::DeviceRegistration<Device> device_registration_of_##Device{ \
      ::swarmanoid::DeviceKind::kind, summary, #Device, __FILE__};

/// Does the same in the headers of swarmanoid_interface/devices/, in the library of the interface alone, which
/// everybody loads: what a description takes is not compiled by all who include a device.
#ifdef INCLUDES_ALL_OF_SWARMANOID_INTERFACE_DEVICES  // by the source that the build writes
#define REGISTER_DEVICE_OF_SUITE(Device, kind, summary) REGISTER_DEVICE(Device, kind, summary)
#else
#define REGISTER_DEVICE_OF_SUITE(Device, kind, summary) static_assert(::swarmanoid::kHasFields<Device>);
#endif
