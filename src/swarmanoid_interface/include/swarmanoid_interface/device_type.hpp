/// Describes devices by name for hosts, lockstep, recordings and checks, which do not include the struct of the device.
/// The description is derived from the device's descriptor, which is defined next to its struct:
///
///     /// Sensor: the distance of the nearest obstacle ahead.
///     struct Sonar {
///       static constexpr const char* kType = "sonar";
///       double range = 3.0;  ///< [m]
///     };
///
///     template <class Visitor>
///     void fields(Visitor& visit, Sonar& sonar) {
///       visit(sonar.range, {"range", "m", "of the nearest obstacle ahead", {0.0, 3.0}});
///     }
///     REGISTER_DEVICE(Sonar, kSensor, "The distance of the nearest obstacle ahead.")
///
/// device_field.hpp lists the possible types of fields. The initial values of the members are the readings or commands
/// of the device at rest, and the safe stop of an actuator. An actuator with another safe stop (safe_stop.hpp) defines,
/// above REGISTER_DEVICE,
///
///     inline bool stopSafely(MyDevice& command, const SafeStopMoment& moment) { ...; return true; }
///
/// A device that only robots of one type have names that type: `static constexpr const char* kRobot = "footbot";`.
/// Other devices are available to every robot.
///
/// The bytes of a device are those of its fields in order, each in its own precision and little-endian, without
/// padding; a span is stored as its length (4 bytes) and its elements. A controller in another process therefore reads
/// the same bits.
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
  std::string layout;  ///< of the bytes: "f8 f8"; two processes can exchange the device if their layouts are equal
  void (*write)(const void* device, ByteWriter& out) = nullptr;
  /// @throws ByteError; the device is then partly read
  void (*read)(ByteReader& in, void* device, VariableParts& parts) = nullptr;
  std::shared_ptr<void> (*make)() = nullptr;        ///< makes a device at rest
  bool (*is_finite)(const void* device) = nullptr;  ///< returns isFinite of the device
  /// The safe stop of actuators, see safe_stop.hpp; null for sensors. @return whether the stop is over
  bool (*stop)(void* command, const SafeStopMoment& moment) = nullptr;
  std::string robot{};        ///< Device::kRobot: only robots of this type have the device; "": any
  bool has_own_stop = false;  ///< `stopSafely` is defined for the struct; else the safe stop is the command at rest
  std::string name{};         ///< name of the struct
  std::string header{};       ///< header of the struct, as it is included
};

/// @return null if no device of that type is registered
const DeviceType* findDeviceType(const std::string& type);
/// Returns all types, sorted by type.
std::vector<const DeviceType*> deviceTypes();

/// Returns the robot types that devices name (kRobot), sorted. Types that have only devices for any robot are not
/// included.
std::vector<std::string> robotTypesOfDevices();

/// Registers a type while a library loads; the first registration of a type stays.
void registerDeviceType(DeviceType type);

/// Returns the names of the numbers in the order of the bytes, "left right"; the name of a span is followed by those of
/// its elements: "blobs(color.red distance) overflowed".
std::string fieldNames(const DeviceType& device);

/// Returns the path by which a header is included, "my_package/sonar.hpp": the part of `file` after its last folder
/// `include`, or the file name if there is no such folder.
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

/// True if the function `fields` is defined for the device.
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

/// For use below the device's struct and its `fields`, in the same header and namespace: every library that includes
/// the header registers the device. @param kind kSensor or kActuator @param summary one sentence
#define REGISTER_DEVICE(Device, kind, summary)                                           \
  inline const ::swarmanoid::DeviceRegistration<Device> device_registration_of_##Device{ \
      ::swarmanoid::DeviceKind::kind, summary, #Device, __FILE__};

/// The same for the headers of swarmanoid_interface/devices/. Only the library of the interface, which every process
/// loads, registers these devices; other code that includes a device does not compile its description.
#ifdef INCLUDES_ALL_OF_SWARMANOID_INTERFACE_DEVICES  // defined by the source that the build writes
#define REGISTER_DEVICE_OF_SUITE(Device, kind, summary) REGISTER_DEVICE(Device, kind, summary)
#else
#define REGISTER_DEVICE_OF_SUITE(Device, kind, summary) static_assert(::swarmanoid::kHasFields<Device>);
#endif
