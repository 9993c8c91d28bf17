/// A robot with its controller in another process, behind a driver with one faulty device: the readings or commands of
/// that device are changed in transit.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "swarmanoid_hosts/controller_host.hpp"
#include "swarmanoid_space/lockstep/lockstep.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid::test {

struct Miswiring {
  std::string device;
  std::function<void(void*)> change;  ///< changes the device
};

/// @param change takes the device by reference
template <class Device, class Change>
Miswiring wire(Change change) {
  return {Device::kType, [change](void* device) mutable { change(*static_cast<Device*>(device)); }};
}

class MiswiredRobot {
 public:
  /// @pre the robot's source is remote
  MiswiredRobot(Simulation& simulation, const std::string& robot, Miswiring miswiring)
      : miswiring_(std::move(miswiring)) {
    Lockstep& lockstep = simulation.lockstep();
    const Registration registration =
        lockstep.join({"miswired", {robot}, {}, {}}, [this, &lockstep](const SensorFrame& frame) {
          SensorFrame sensed = frame;
          rewire(sensed.data, robot_.sensors);
          CommandFrame answer = host_->answer(sensed);
          if (answer.data[0] == static_cast<std::uint8_t>(StepStatus::kStepped)) {
            rewire(answer.data, robot_.actuators);
          }
          lockstep.answer(answer);
        });
    robot_ = registration.robots.front();
    const Registry::Entry& entry = Registry::instance().require(PluginKind::kController, robot_.label);
    host_ = std::make_unique<ControllerHost>(
        registration, [&entry] { return makePlugin<Controller>(entry); }, nullptr);
  }

 private:
  /// Changes the data of a frame with one robot: a byte, a block for each device, and the rest.
  void rewire(Bytes& data, const std::vector<DeviceLayout>& devices) const {
    if (data[0] == 0) {
      return;
    }
    ByteReader in(data);
    Bytes changed;
    ByteWriter out(changed);
    out.number(in.number<std::uint8_t>());
    for (const DeviceLayout& layout : devices) {
      const DeviceType& type = *findDeviceType(layout.type);
      const std::shared_ptr<void> device = type.make();
      VariableParts parts;
      ByteReader block = in.block();
      type.read(block, device.get(), parts);
      if (layout.type == miswiring_.device) {
        miswiring_.change(device.get());
      }
      const std::size_t begin = out.openBlock();
      type.write(device.get(), out);
      out.closeBlock(begin);
    }
    while (in.left() > 0) {
      out.number(in.number<std::uint8_t>());
    }
    data = changed;
  }

  Miswiring miswiring_;
  RemoteRobot robot_;
  std::unique_ptr<ControllerHost> host_;
};

}  // namespace swarmanoid::test
