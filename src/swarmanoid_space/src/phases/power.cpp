// Phase 7: batteries supply the energy that their robots used in the tick, and are charged. Also part of phase 3:
// functions that are off on the super-capacitor alone, and without any charge.
#include <algorithm>
#include <cmath>

#include "phases.hpp"
#include "swarmanoid_space/power_demand.hpp"

namespace swarmanoid {

double standbyPower(const BatteryModel& battery, const ControllerDescription* controller) {
  double power = battery.electronics;
  if (controller != nullptr) {
    for (const auto* devices : {&controller->sensors, &controller->actuators}) {
      for (const DeviceDescription& device : *devices) {
        power += battery.powerOf(device.type);
      }
    }
  }
  return power;
}

namespace {

/// Power of a motor in excess of its drive's, because it turns slower than its voltage would make it without load, by
/// the law of a direct-current motor. All speeds are fractions of the maximum speed. @param voltage fraction of the
/// full voltage, from -1 to 1
double loadPower(double stall, double voltage, double speed) {
  const double forward = voltage < 0.0 ? -speed : speed;
  const double lag = std::clamp(std::abs(voltage) - forward, 0.0, std::abs(voltage));
  return stall * std::abs(voltage) * lag;
}

/// Excess power of both wheels. @pre the robot has wheels that are driven
double loadPower(const Space& space, Row row, const BatteryModel& battery) {
  const EntityModel::Wheels& geometry = *space.entities.model[row]->wheels;
  const WheelsCommand& wheels = space.wheels[row];
  const Eigen::Quaterniond to_body = space.entities.pose[row].orientation.conjugate();
  const double ahead = (to_body * space.entities.twist[row].linear).x();
  const double aside = 0.5 * geometry.separation * (to_body * space.entities.twist[row].angular).z();
  const double left = geometry.radius * geometry.max_speed * wheels.grip.left;  // ground speed at full voltage [m/s]
  const double right = geometry.radius * geometry.max_speed * wheels.grip.right;
  const double stall = 0.5 * std::max(0.0, battery.stall - battery.drive);
  return loadPower(stall, geometry.radius * wheels.left / left, (ahead - aside) / left) +
         loadPower(stall, geometry.radius * wheels.right / right, (ahead + aside) / right);
}

}  // namespace

double powerDemand(const Space& space, Row row, const BatteryModel& battery, double standby) {
  const EntityModel& model = *space.entities.model[row];
  double power = standby;
  for (const Color& led : space.leds[row]) {
    power += battery.led * led.brightness();
  }
  const WheelsCommand& wheels = space.wheels[row];
  if (wheels.is_driven && model.wheels) {
    const double turned = std::abs(wheels.left) / wheels.grip.left + std::abs(wheels.right) / wheels.grip.right;
    power += battery.drive * turned / (2.0 * model.wheels->max_speed);
    power += battery.stall > 0.0 ? loadPower(space, row, battery) : 0.0;
  }
  if (battery.flight > 0.0 && space.flight[row].is_driven && !isCarried(space, row)) {
    power += battery.flight;
  }
  return power;
}

bool isCarried(const Space& space, Row row) {
  constexpr double kClearance = 0.01;  // m
  const Eigen::Vector3d& position = space.entities.pose[row].position;
  const bool is_over_terrain = space.terrain && space.terrain->contains(position.x(), position.y());
  const double ground = is_over_terrain ? space.terrain->heightAt(position.x(), position.y()) : 0.0;
  return position.z() - space.entities.model[row]->origin_height < ground + kClearance ||
         space.attachments.isAttached(row);
}

}  // namespace swarmanoid

namespace swarmanoid::phases {
namespace {

/// Takes energy from a store, limited to its content. @return the energy taken
double take(double energy, double& store) {
  const double taken = std::min(energy, store);
  store -= taken;
  return taken;
}

void drain(const Space& space, Row row, double dt, Span<double> stores, BatteryState& state) {
  state.power = 0.0;
  if (state.is_empty) {
    return;
  }
  const double needed = powerDemand(space, row, *space.entities.model[row]->battery, state.standby) * dt;
  double taken = take(needed, stores[kBatteryCharge]);
  taken += take(needed - taken, stores[kBatteryCapacitor]);
  state.used += taken;
  state.power = taken / dt;
  const double most = space.entities.model[row]->battery->capacitor;
  const double refill = std::min(most * dt / BatteryModel::kRefillTime, most - stores[kBatteryCapacitor]);
  stores[kBatteryCapacitor] = std::min(stores[kBatteryCapacitor] + take(refill, stores[kBatteryCharge]), most);
}

void charge(double capacity, double dt, Span<double> stores, BatteryState& state) {
  const double before = stores[kBatteryCharge];
  stores[kBatteryCharge] = std::min(before + stores[kBatterySupply] * dt, capacity);
  const double given = stores[kBatteryCharge] - before;
  state.received += given;
  state.input = given / dt;
}

}  // namespace

void cutPower(const Space& space, const ActuateAccess& access, const std::vector<RobotInstance>& instances) {
  if (space.powered.empty()) {
    return;
  }
  for (const Row row : space.powered) {
    const BatteryState& state = space.batteries[row][0];
    if (isOnCapacitor(space.properties[row], state)) {
      access.wheels[row].left = 0.0;
      access.wheels[row].right = 0.0;
    }
    if (state.is_empty) {
      const Span<Color> leds = access.leds[row];
      std::fill(leds.begin(), leds.end(), colors::kBlack);
    }
  }
  // a safe stop ends with hovering if the robot has not reached the ground in time
  for (const RobotInstance& instance : instances) {
    FlightCommand& flight = access.flight[instance.row];
    if (instance.source_when_charged && !instance.stops_since && flight.is_driven && !isCarried(space, instance.row)) {
      flight.linear = {0.0, 0.0, -SafeStopSettings{}.descend_speed};
      flight.yaw_rate = 0.0;
    }
  }
}

void power(const Space& space, const PowerAccess& access) {
  const double dt = toSeconds(space.clocktick);
  for (const Row row : space.powered) {
    const BatteryModel& battery = *space.entities.model[row]->battery;
    const Span<double> stores = access.properties[row];
    BatteryState& state = access.batteries[row][0];
    drain(space, row, dt, stores, state);
    charge(battery.capacity, dt, stores, state);
    judgeEmptiness(battery, stores, state);
  }
}

}  // namespace swarmanoid::phases
