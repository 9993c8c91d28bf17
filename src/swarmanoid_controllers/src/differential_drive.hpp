/// Functions that drive a robot on two wheels towards a target and away from obstacles.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/devices/differential_drive.hpp"
#include "swarmanoid_interface/devices/footbot_proximity.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_interface/devices/proximity.hpp"
#include "swarmanoid_interface/robot.hpp"

namespace swarmanoid {

/// Turns on the spot while the target is to the side; otherwise drives a curve towards it.
/// @tparam Drive FootbotWheels, DifferentialDrive or MobileBase
/// @param bearing of the target [rad]; @param speed when it is straight ahead [m/s]
template <class Drive>
void steer(Drive& wheels, double bearing, double speed) {
  constexpr double kGain = 2.0;         // 1/s
  constexpr double kFastestTurn = 1.5;  // rad/s
  const double ahead = std::max(0.0, std::cos(bearing));
  wheels.drive(speed * ahead * ahead, std::clamp(kGain * bearing, -kFastestTurn, kFastestTurn));
}

/// Turn rate of a wandering robot, which drives arcs of 3 s on average.
/// @param turn_rate of the current arc [rad/s] @param dt since the last call [s] @return turn rate from now on [rad/s]
inline double wanderingTurnRate(RandomStream& random, double turn_rate, double dt) {
  constexpr double kArc = 3.0;       // s on average
  constexpr double kTightest = 0.8;  // rad/s
  return random.uniform() < dt / kArc ? random.uniform(-kTightest, kTightest) : turn_rate;
}

/// The direction of obstacles, as the sum of the proximity readings taken as vectors.
struct ObstacleVector {
  double x = 0.0;  ///< ahead
  double y = 0.0;  ///< left

  /// @param half_field sensors farther to the side than this do not count [rad]
  explicit ObstacleVector(const FootbotProximity& proximity, double half_field = M_PI) {
    if (!isAnythingNear(proximity)) {
      return;
    }
    static const Directions directions;
    for (std::size_t i = 0; i < FootbotProximity::kCount; ++i) {
      const float value = proximity.value[i];
      if (value > 0.0F && std::abs(FootbotProximity::angle(i)) <= half_field) {
        add(value, directions.cosine[i], directions.sine[i]);
      }
    }
  }
  explicit ObstacleVector(const Proximity& proximity, double half_field = M_PI) {
    for (const ProximityReading& reading : proximity.sensors) {
      const double angle = reading.angle;
      if (reading.value > 0.0F && std::abs(angle) <= half_field) {
        add(reading.value, std::cos(angle), std::sin(angle));
      }
    }
  }
  double length() const { return x == 0.0 && y == 0.0 ? 0.0 : std::hypot(x, y); }
  double bearing() const { return std::atan2(y, x); }

 private:
  void add(float value, double cosine, double sine) {
    x += value * cosine;
    y += value * sine;
  }

  /// Directions of the sensors of a footbot.
  struct Directions {
    std::array<double, FootbotProximity::kCount> cosine;
    std::array<double, FootbotProximity::kCount> sine;

    Directions() {
      for (std::size_t i = 0; i < FootbotProximity::kCount; ++i) {
        cosine[i] = std::cos(FootbotProximity::angle(i));
        sine[i] = std::sin(FootbotProximity::angle(i));
      }
    }
  };

  /// Whether any sensor detects an obstacle; usually none does. Testing the bits of all values together is faster than
  /// testing them one by one.
  static bool isAnythingNear(const FootbotProximity& proximity) {
    std::array<std::uint32_t, FootbotProximity::kCount> bits;
    static_assert(sizeof(bits) == sizeof(proximity.value));
    std::memcpy(bits.data(), &proximity.value, sizeof(bits));
    std::uint32_t any = 0;
    for (const std::uint32_t value : bits) {
      any |= value;
    }
    return any != 0;
  }
};

/// Drives with the devices in the controller's configuration: the generic ones if listed, otherwise those of a footbot.
class MobileBase {
 public:
  MobileBase() = default;
  /// @throws DeviceError if the robot has neither
  explicit MobileBase(Robot& robot) {
    if (robot.hasActuator(DifferentialDrive::kType)) {
      drive_ = &robot.actuator<DifferentialDrive>();
    } else {
      footbot_wheels_ = &robot.actuator<FootbotWheels>();
    }
    if (robot.hasSensor(Proximity::kType)) {
      proximity_ = &robot.sensor<Proximity>();
    } else {
      footbot_proximity_ = &robot.sensor<FootbotProximity>();
    }
  }

  /// @param speed ahead [m/s]; @param turn_rate [rad/s], counter-clockwise
  void drive(double speed, double turn_rate) {
    if (drive_ != nullptr) {
      drive_->drive(speed, turn_rate);
    } else {
      footbot_wheels_->drive(speed, turn_rate);
    }
  }

  /// @param half_field see ObstacleVector
  ObstacleVector obstacles(double half_field) const {
    return proximity_ != nullptr ? ObstacleVector(*proximity_, half_field)
                                 : ObstacleVector(*footbot_proximity_, half_field);
  }

 private:
  DifferentialDrive* drive_ = nullptr;
  FootbotWheels* footbot_wheels_ = nullptr;
  const Proximity* proximity_ = nullptr;
  const FootbotProximity* footbot_proximity_ = nullptr;
};

}  // namespace swarmanoid
