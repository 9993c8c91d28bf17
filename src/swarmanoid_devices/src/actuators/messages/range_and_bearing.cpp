// The range-and-bearing sender of any robot.
#include "swarmanoid_interface/devices/range_and_bearing.hpp"

#include "message_sender.hpp"

namespace swarmanoid::devices {
namespace {

class RangeAndBearingSender final : public MessageSender<RangeAndBearing> {
 public:
  static PluginDescription describe() {
    return describeSender("Sends its payload to all robots in sight, in each tick until it falls silent.");
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_ACTUATOR(swarmanoid::devices::RangeAndBearingSender)
