#include "swarmanoid_interface/frame_parts.hpp"

namespace swarmanoid {

void writeBlock(const DeviceType& type, const void* device, ByteWriter& out) {
  const std::size_t begin = out.openBlock();
  type.write(device, out);
  out.closeBlock(begin);
}

void readBlock(const DeviceType& type, ByteReader& in, void* device, VariableParts& parts) {
  ByteReader block = in.block();
  type.read(block, device, parts);
  if (block.left() > 0) {
    throw ByteError("found " + std::to_string(block.left()) + " bytes more than expected");
  }
}

void writeDebugValues(const std::vector<Robot::DebugValue>& values, ByteWriter& out) {
  out.number(static_cast<std::uint32_t>(values.size()));
  for (const auto& [key, value] : values) {
    out.text(key);
    out.text(value);
  }
}

std::vector<Robot::DebugValue> readDebugValues(ByteReader& in) {
  std::vector<Robot::DebugValue> values;
  const auto count = in.number<std::uint32_t>();
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::string key = in.text();
    values.emplace_back(key, in.text());
  }
  return values;
}

}  // namespace swarmanoid
