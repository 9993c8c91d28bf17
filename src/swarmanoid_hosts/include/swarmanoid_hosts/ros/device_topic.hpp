/// Describes devices as ROS topics: name, message and frame of each, for its publishers and subscribers. One table
/// serves all: the simulator's views of devices, its robots that are commanded over topics, controllers on robots, and
/// drivers.
///
/// Readings go from a robot to its subscribers, commands the other way. Topics are in the robot's namespace.
///
/// Two functions in the device's namespace, in a header of their own, convert a device to a message and back; a macro
/// below them registers the topic (devices/footbot_gripper.hpp is an example):
///
///     inline void toMessage(const MyDevice& device, my_msgs::MyDevice& message);
///     inline void fromMessage(const my_msgs::MyDevice& message, MyDevice& device);
///     REGISTER_DEVICE_TOPIC(MyDevice, my_msgs::MyDevice, kReading, "my_device", "base_link")
///
/// Fields that a message does not contain stay unchanged; the caller sets stamp and frame_id of the header.
/// `fromMessage` throws std::runtime_error, with the value found and the allowed values, for a message that is not
/// valid for the device; the struct may then be partly written. For a device with lists it takes VariableParts as well,
/// which store their elements.
///
/// The headers in devices/ define the suite's topics; a source of a library that is linked with swarmanoid_hosts_ros
/// includes the header of a further topic. A device may have more than one topic; the first is the main one.
///
/// Readings that stay for several ticks need a third function, `double ageOf(const MyDevice& device)`: their age [s].
/// The stamp of the message is the time when they were made, and the simulator publishes each reading once.
///
/// A device that registers no topic gets a generic one, of its fields by name (device_fields.hpp): a sensor `<type>`,
/// in frame base_link; an actuator `<type>/command`.
///
/// Threads  topics register while a library loads (one thread, without concurrent lookups); afterwards they may be
/// looked up from any thread.
#pragma once

#include <ros/node_handle.h>
#include <std_msgs/Header.h>

#include <functional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/registry.hpp"

namespace swarmanoid {

struct DeviceTopic {
  enum class Kind { kReading, kCommand };
  /// @param problem "", or the reason why a message was refused; the device is then unchanged
  using Receiver = std::function<void(const std::string& problem)>;

  std::string device;   ///< Device::kType
  std::string name;     ///< such as "gripper/state"
  std::string message;  ///< such as "swarmanoid_msgs/GripperState"
  std::string frame;    ///< for readings: a link of the robot, "base_link", or kWorldFrame (tf_frames.hpp)
  Kind kind = Kind::kReading;

  /// Advertises the topic in the namespace of `robot`.
  ros::Publisher (*advertise)(ros::NodeHandle& robot, const DeviceTopic& topic) = nullptr;
  /// Does the same, latched: later subscribers get the last message.
  ros::Publisher (*advertiseLatched)(ros::NodeHandle& robot, const DeviceTopic& topic) = nullptr;
  /// @param header stamp, and for readings the frame; ignored if the message has no header
  void (*publish)(const ros::Publisher& publisher, const DeviceTopic& topic, const void* device,
                  const std_msgs::Header& header) = nullptr;
  /// Returns the age of the readings [s]. Null if the device has no `ageOf`: the age is always 0.
  double (*age)(const void* device) = nullptr;
  /// Writes each received message to `device`, whose variable parts are stored in `parts`, and then calls `receive`, on
  /// the thread that serves the handle's queue. @pre device and parts live as long as the subscriber
  ros::Subscriber (*subscribe)(ros::NodeHandle& robot, const DeviceTopic& topic, void* device, VariableParts& parts,
                               Receiver receive) = nullptr;
};

/// Returns the time when readings were made, limited to [0, now], since error models may change their age.
/// @param now stamp of the tick
ros::Time madeAt(const DeviceTopic& topic, const void* readings, const ros::Time& now);

/// Returns the topics of a device in the order of registration. @return empty if there is no such device
std::vector<const DeviceTopic*> topicsOf(const std::string& device);
/// @return null if there is no such device
const DeviceTopic* mainTopicOf(const std::string& device);
/// Returns the topics of all devices, sorted by device, then in the order of registration.
std::vector<const DeviceTopic*> deviceTopics();
/// Registers a topic while a library loads; the first one of a device and name stays.
void registerDeviceTopic(DeviceTopic topic);

namespace detail {

template <class Device, class Message, class = void>
struct KeepsParts : std::false_type {};
template <class Device, class Message>
struct KeepsParts<Device, Message,
                  std::void_t<decltype(fromMessage(std::declval<const Message&>(), std::declval<Device&>(),
                                                   std::declval<VariableParts&>()))>> : std::true_type {};

/// @throws std::runtime_error
template <class Device>
void refuseUnlessFinite(const Device& device) {
  if (!isFinite(device)) {
    throw std::runtime_error("found a number that is not finite, allowed: finite numbers");
  }
}

/// @param parts storage of the device's lists
/// @throws std::runtime_error; the device and its lists are then unchanged
template <class Device, class Message>
void receive(const Message& message, Device& device, VariableParts& parts) {
  Device received = device;
  if constexpr (KeepsParts<Device, Message>::value) {
    VariableParts received_parts;
    fromMessage(message, received, received_parts);
    refuseUnlessFinite(received);
    std::swap(parts, received_parts);  // the elements stay where they are
  } else {
    fromMessage(message, received);
    refuseUnlessFinite(received);
  }
  device = received;
}

template <class Message, class = void>
struct HasChildFrame : std::false_type {};
template <class Message>
struct HasChildFrame<Message, std::void_t<decltype(std::declval<Message&>().child_frame_id)>> : std::true_type {};

template <class Device, class = void>
struct HasAge : std::false_type {};
template <class Device>
struct HasAge<Device, std::void_t<decltype(ageOf(std::declval<const Device&>()))>> : std::true_type {};

/// Sets the header. A message with a child frame, which moves in the header's frame, gets the robot's base_link as
/// child frame: fb_1/base_link for fb_1/odom.
template <class Message>
void setFrames(Message& message, const std_msgs::Header& header) {
  if (std_msgs::Header* message_header = ros::message_traits::header(message)) {
    *message_header = header;
  }
  if constexpr (HasChildFrame<Message>::value) {
    message.child_frame_id = header.frame_id.substr(0, header.frame_id.rfind('/') + 1) + "base_link";
  }
}

/// Makes a topic of that message, without the functions `publish` and `subscribe`.
template <class Message>
DeviceTopic makeTopicOfMessage(const std::string& device, DeviceTopic::Kind kind, const std::string& name,
                               const std::string& frame) {
  DeviceTopic topic{device, name, ros::message_traits::DataType<Message>::value(), frame, kind};
  topic.advertise = [](ros::NodeHandle& robot, const DeviceTopic& entry) {
    constexpr std::uint32_t kQueue = 10;
    return robot.advertise<Message>(entry.name, kQueue);
  };
  topic.advertiseLatched = [](ros::NodeHandle& robot, const DeviceTopic& entry) {
    constexpr bool kLatched = true;
    return robot.advertise<Message>(entry.name, 1, kLatched);
  };
  return topic;
}

/// @param take reads a message into the device, or throws
template <class Message, class Take>
ros::Subscriber subscribe(ros::NodeHandle& robot, const DeviceTopic& topic, Take take, DeviceTopic::Receiver receiver) {
  const boost::function<void(const boost::shared_ptr<const Message>&)> callback =
      [take = std::move(take), receiver = std::move(receiver)](const boost::shared_ptr<const Message>& message) {
        std::string problem;
        try {
          take(*message);
        } catch (const std::exception& error) {
          problem = error.what();
        }
        receiver(problem);
      };
  return robot.subscribe<Message>(topic.name, 1, callback, ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay());
}

}  // namespace detail

template <class Device, class Message>
DeviceTopic makeDeviceTopic(DeviceTopic::Kind kind, const std::string& name, const std::string& frame = "") {
  DeviceTopic topic = detail::makeTopicOfMessage<Message>(Device::kType, kind, name, frame);
  topic.publish = [](const ros::Publisher& publisher, const DeviceTopic&, const void* device,
                     const std_msgs::Header& header) {
    Message message;
    toMessage(*static_cast<const Device*>(device), message);
    detail::setFrames(message, header);
    publisher.publish(message);
  };
  if constexpr (detail::HasAge<Device>::value) {
    topic.age = [](const void* device) { return ageOf(*static_cast<const Device*>(device)); };
  }
  topic.subscribe = [](ros::NodeHandle& robot, const DeviceTopic& entry, void* device, VariableParts& parts,
                       DeviceTopic::Receiver receive) {
    return detail::subscribe<Message>(
        robot, entry,
        [device, &parts](const Message& message) { detail::receive(message, *static_cast<Device*>(device), parts); },
        std::move(receive));
  };
  return topic;
}

struct DeviceTopicRegistration {
  explicit DeviceTopicRegistration(DeviceTopic topic) { registerDeviceTopic(std::move(topic)); }
};

}  // namespace swarmanoid

/// @param kind kReading or kCommand @param ... name and, of readings, frame
#define REGISTER_DEVICE_TOPIC(Device, Message, kind, ...)                                                             \
  static const ::swarmanoid::DeviceTopicRegistration SWARMANOID_CONCATENATE(device_topic_registration_, __COUNTER__)( \
      ::swarmanoid::makeDeviceTopic<Device, Message>(::swarmanoid::DeviceTopic::Kind::kind, __VA_ARGS__));
