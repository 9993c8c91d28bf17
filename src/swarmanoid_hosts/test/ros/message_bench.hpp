/// Converts devices to messages and back, for tests.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_interface/device_type.hpp"

namespace swarmanoid::test {

/// Converts to a message and back, to a device with its initial value.
template <class Message, class Device>
Device thereAndBack(const Device& device) {
  Message message;
  toMessage(device, message);
  Device back;
  fromMessage(message, back);
  return back;
}

inline Bytes bytesOf(const std::string& type, const void* device) {
  Bytes bytes;
  ByteWriter writer(bytes);
  findDeviceType(type)->write(device, writer);
  return bytes;
}

template <class Message, class Device>
void expectNothingLost(const Device& device) {
  const Device back = thereAndBack<Message>(device);
  EXPECT_NE(bytesOf(Device::kType, std::make_unique<Device>().get()), bytesOf(Device::kType, &device));
  EXPECT_EQ(bytesOf(Device::kType, &device), bytesOf(Device::kType, &back)) << Device::kType;
}

template <class Message, class Device>
std::string refusalOf(const Message& message, Device device = {}) {
  const Bytes before = bytesOf(Device::kType, &device);
  VariableParts parts;
  try {
    detail::receive(message, device, parts);
  } catch (const std::exception& error) {
    EXPECT_EQ(before, bytesOf(Device::kType, &device));
    return error.what();
  }
  return "";
}

}  // namespace swarmanoid::test
