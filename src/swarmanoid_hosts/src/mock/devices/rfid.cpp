// The antenna, in the middle of a mock robot, reads and writes the tags of the world that are within reach.
#include "swarmanoid_interface/devices/rfid.hpp"

#include <algorithm>
#include <vector>

#include "../mock_device.hpp"

namespace swarmanoid::mock {
namespace {

double wayTo(const Tag& tag, const MockState& state) { return (tag.at - state.pose.position.head<2>()).norm(); }

/// Returns the indices in World::tags of the tags within reach, nearest first.
std::vector<std::size_t> tagsInReach(const MockState& state) {
  std::vector<std::size_t> reached;
  for (std::size_t i = 0; i < state.world.tags.size(); ++i) {
    if (wayTo(state.world.tags[i], state) <= Rfid::kUsualReach) {
      reached.push_back(i);
    }
  }
  std::stable_sort(reached.begin(), reached.end(), [&state](std::size_t one, std::size_t other) {
    return wayTo(state.world.tags[one], state) < wayTo(state.world.tags[other], state);
  });
  return reached;
}

class MockRfidReader final : public MockDevice {
 public:
  MockRfidReader(RfidReader& readings, MockState& /*state*/) : readings_(readings) {}

  void sense(const MockState& state) override {
    tags_.clear();
    for (const std::size_t i : tagsInReach(state)) {
      tags_.push_back({state.world.tags[i].id, state.world.tags[i].data});
    }
    const std::size_t count = std::min(tags_.size(), RfidReader::kMostTags);
    readings_.tags = Span<const RfidTagReading>(tags_.data(), count);
    readings_.overflowed = tags_.size() > count;
  }

 private:
  RfidReader& readings_;
  std::vector<RfidTagReading> tags_;
};

class MockRfidWriter final : public MockDevice {
 public:
  MockRfidWriter(const RfidWriter& command, MockState& /*state*/) : command_(command) {}

  void act(MockState& state, double /*dt*/) override {
    if (!command_.writes) {
      return;
    }
    for (const std::size_t i : tagsInReach(state)) {
      if (command_.id == 0 || command_.id == state.world.tags[i].id) {
        state.world.tags[i].data = command_.data;
        return;
      }
    }
  }

 private:
  const RfidWriter& command_;
};

REGISTER_MOCK_DEVICE(RfidReader, MockRfidReader)
REGISTER_MOCK_DEVICE(RfidWriter, MockRfidWriter)

}  // namespace
}  // namespace swarmanoid::mock
