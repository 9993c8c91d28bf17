// The range-and-bearing receiver of any robot: messages and the positions of their senders.
#include "message_receiver.hpp"
#include "swarmanoid_interface/devices/range_and_bearing.hpp"

namespace swarmanoid::devices {
namespace {

class RangeAndBearingReceiver final : public MessageReceiver<RangeAndBearingReceived, RangeAndBearing> {
 public:
  static PluginDescription describe() {
    return describeReceiver("Receives messages of all senders in sight and in range, and measures their positions.");
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_SENSOR(swarmanoid::devices::RangeAndBearingReceiver)
