/// Worlds of robots with range-and-bearing boards, whose messages are computed by hand.
#pragma once

#include <memory>
#include <vector>

#include "device_world.hpp"
#include "swarmanoid_interface/devices/range_and_bearing.hpp"

namespace swarmanoid::test {

/// The board of one robot: its command, and the messages that it has received.
struct Board {
  Row row = kNoRow;
  RangeAndBearing* command = nullptr;
  const RangeAndBearingReceived* received = nullptr;

  Span<const RangeAndBearingMessage> messages() const { return received->messages; }
};

class MessageWorld : public DeviceWorld {
 public:
  /// @param parameters of the receivers
  explicit MessageWorld(const Parameters& parameters = {}, const Errors& errors = {}, std::uint64_t seed = 1)
      : DeviceWorld(seed),
        receiver(makeDevice<Sensor>(PluginKind::kSensor, RangeAndBearingReceived::kType, parameters, errors)),
        sender(makeDevice<Actuator>(PluginKind::kActuator, RangeAndBearing::kType, {})) {}

  /// Adds a board to a robot, the sensor first, as simulations do.
  Board equip(Row row) {
    Board board;
    board.row = row;
    board.received = static_cast<const RangeAndBearingReceived*>(receiver->add(space, row));
    board.command = static_cast<RangeAndBearing*>(sender->add(space, row));
    return board;
  }
  Board footbot(double x, double y, double heading = 0.0) { return equip(addFootbot(x, y, heading)); }
  Board eyebot(double x, double y, double z, double heading = 0.0) { return equip(addEyebot(x, y, z, heading)); }

  void remove(const Board& board) {
    receiver->remove(space, board.row);
    sender->remove(space, board.row);
    DeviceWorld::remove(board.row);
  }

  /// Commands become actuations, and in the next tick readings.
  void exchange() {
    actuate(*sender);
    ++space.tick;
    sense(*receiver);
  }

  std::shared_ptr<Sensor> receiver;
  std::shared_ptr<Actuator> sender;
};

}  // namespace swarmanoid::test
