/// The bytes of records in files of the format "ROSBAG V2.0" (wiki.ros.org/Bags/Format/2.0).
///
/// A record is a header and data, each preceded by its length. A header is a list of name=value, each preceded by its
/// length. Numbers are little-endian, as on this computer.
#pragma once

#include <ros/time.h>

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace swarmanoid::bag_records {

enum class Operation : std::uint8_t {
  kMessage = 0x02,
  kFileHeader = 0x03,
  kIndex = 0x04,
  kChunk = 0x05,
  kChunkInfo = 0x06,
  kConnection = 0x07
};

using Bytes = std::vector<char>;

template <class Number>
std::enable_if_t<std::is_arithmetic_v<Number>> append(Bytes& bytes, Number number) {
  const std::size_t end = bytes.size();
  bytes.resize(end + sizeof number);
  std::memcpy(bytes.data() + end, &number, sizeof number);
}

inline void append(Bytes& bytes, std::string_view text) { bytes.insert(bytes.end(), text.begin(), text.end()); }

inline void append(Bytes& bytes, const ros::Time& time) {
  append(bytes, time.sec);
  append(bytes, time.nsec);
}

/// Appends a header, with its length, to bytes; fields are added between construction and destruction.
class Header {
 public:
  explicit Header(Bytes& bytes) : bytes_(bytes), start_(bytes.size()) { append(bytes_, std::uint32_t{0}); }
  Header(Bytes& bytes, Operation operation) : Header(bytes) { field("op", static_cast<std::uint8_t>(operation)); }
  ~Header() {
    const auto length = static_cast<std::uint32_t>(bytes_.size() - start_ - sizeof(std::uint32_t));
    std::memcpy(bytes_.data() + start_, &length, sizeof length);
  }
  Header(const Header&) = delete;
  Header& operator=(const Header&) = delete;

  template <class Value>
  Header& field(std::string_view name, const Value& value) {
    const std::size_t place = bytes_.size();
    append(bytes_, std::uint32_t{0});
    append(bytes_, name);
    bytes_.push_back('=');
    append(bytes_, value);
    const auto length = static_cast<std::uint32_t>(bytes_.size() - place - sizeof(std::uint32_t));
    std::memcpy(bytes_.data() + place, &length, sizeof length);
    return *this;
  }

 private:
  Bytes& bytes_;
  std::size_t start_;
};

}  // namespace swarmanoid::bag_records
