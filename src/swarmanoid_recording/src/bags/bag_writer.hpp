/// Writes messages to a bag, in simulated time.
#pragma once

#include <ros/message_traits.h>
#include <ros/serialization.h>

#include <string>

#include "bag_file.hpp"

namespace swarmanoid {

class BagWriter {
 public:
  /// @throws std::runtime_error, as do all functions here, see BagFile
  void open(OutDescriptor file, BagFile::Compression compression) { file_.open(std::move(file), compression); }
  void flush() { file_.flush(); }
  /// Completes the bag; a later message continues it.
  void complete() { file_.complete(); }

  template <class Message>
  void write(const std::string& topic, const ros::Time& time, const Message& message) {
    writeTo(topic, time, message, false);
  }

  /// Writes to a topic that players latch, as the space does.
  template <class Message>
  void writeLatched(const std::string& topic, const ros::Time& time, const Message& message) {
    writeTo(topic, time, message, true);
  }

 private:
  template <class Message>
  void writeTo(const std::string& topic, const ros::Time& time, const Message& message, bool is_latched) {
    namespace traits = ros::message_traits;
    std::optional<std::uint32_t> number = file_.findTopic(topic);
    if (!number) {
      number = file_.addTopic(
          topic, {traits::datatype(message), traits::md5sum(message), traits::definition(message), is_latched});
    }
    const std::uint32_t size = ros::serialization::serializationLength(message);
    ros::serialization::OStream stream(file_.add(*number, time, size), size);
    ros::serialization::serialize(stream, message);
  }

  BagFile file_;
};

}  // namespace swarmanoid
