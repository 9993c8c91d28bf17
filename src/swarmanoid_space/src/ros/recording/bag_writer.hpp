/// A rosbag that is written without a master, in simulated time.
#pragma once

#include <rosbag/bag.h>

#include <boost/make_shared.hpp>
#include <string>

namespace swarmanoid {

class BagWriter {
 public:
  /// @throws rosbag::BagException
  void open(const std::string& file, rosbag::compression::CompressionType compression) {
    file_ = file;
    compression_ = compression;
    bag_.open(file, rosbag::bagmode::Write);
    bag_.setCompression(compression);
  }

  /// Goes on with a file that was closed. @throws rosbag::BagException
  void reopen() {
    if (!bag_.isOpen()) {
      bag_.open(file_, rosbag::bagmode::Append);
      bag_.setCompression(compression_);
    }
  }

  /// Completes the file.
  void close() {
    if (bag_.isOpen()) {
      bag_.close();
    }
  }

  template <class Message>
  void write(const std::string& topic, const ros::Time& time, const Message& message) {
    bag_.write(topic, time, message);
  }

  /// A player will latch the topic, as the space does.
  template <class Message>
  void writeLatched(const std::string& topic, const ros::Time& time, const Message& message) {
    auto header = boost::make_shared<ros::M_string>();
    (*header)["type"] = ros::message_traits::datatype(message);
    (*header)["md5sum"] = ros::message_traits::md5sum(message);
    (*header)["message_definition"] = ros::message_traits::definition(message);
    (*header)["latching"] = "1";
    (*header)["callerid"] = "/swarmanoid";
    bag_.write(topic, time, message, header);
  }

 private:
  rosbag::Bag bag_;
  std::string file_;
  rosbag::compression::CompressionType compression_ = rosbag::compression::Uncompressed;
};

}  // namespace swarmanoid
