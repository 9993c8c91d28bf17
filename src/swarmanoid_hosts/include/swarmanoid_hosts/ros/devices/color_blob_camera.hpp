/// Defines the topics of devices/color_blob_camera.hpp, and converts its devices to messages and back.
#pragma once

#include <swarmanoid_msgs/ColorBlobs.h>

#include "swarmanoid_hosts/ros/device_messages.hpp"
#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_interface/devices/color_blob_camera.hpp"

namespace swarmanoid {

inline void toMessage(const ColorBlobs& readings, swarmanoid_msgs::ColorBlobs& message) {
  message.blobs.resize(readings.blobs.size());
  for (std::size_t i = 0; i < readings.blobs.size(); ++i) {
    message.blobs[i].color = toMessage(readings.blobs[i].color);
    message.blobs[i].bearing = readings.blobs[i].bearing;
    message.blobs[i].distance = readings.blobs[i].distance;
    message.blobs[i].elevation = readings.blobs[i].elevation;
    message.blobs[i].size = readings.blobs[i].size;
  }
  message.overflowed = readings.overflowed;
}

/// The blobs are stored in `parts`.
inline void fromMessage(const swarmanoid_msgs::ColorBlobs& message, ColorBlobs& readings, VariableParts& parts) {
  const std::size_t count = message.blobs.size();
  parts.clear();
  ColorBlob* blobs = parts.room<ColorBlob>(count);
  for (std::size_t i = 0; i < count; ++i) {
    const swarmanoid_msgs::ColorBlob& blob = message.blobs[i];
    blobs[i] = {fromMessage(blob.color), blob.bearing, blob.distance, blob.elevation, blob.size};
  }
  readings.blobs = Span<const ColorBlob>(blobs, count);
  readings.overflowed = message.overflowed != 0;
}

REGISTER_DEVICE_TOPIC(FootbotCamera, swarmanoid_msgs::ColorBlobs, kReading, "camera/blobs", "base_link")
REGISTER_DEVICE_TOPIC(EyebotCamera, swarmanoid_msgs::ColorBlobs, kReading, "camera/blobs", "base_link")
REGISTER_DEVICE_TOPIC(EyebotOmnidirectionalCamera, swarmanoid_msgs::ColorBlobs, kReading,
                      "omnidirectional_camera/blobs", "base_link")
REGISTER_DEVICE_TOPIC(EyebotPanTiltCamera, swarmanoid_msgs::ColorBlobs, kReading, "pan_tilt_camera/blobs", "base_link")
REGISTER_DEVICE_TOPIC(FootbotFrontCamera, swarmanoid_msgs::ColorBlobs, kReading, "front_camera/blobs", "base_link")
REGISTER_DEVICE_TOPIC(HandbotCamera, swarmanoid_msgs::ColorBlobs, kReading, "camera/blobs", "base_link")

}  // namespace swarmanoid
