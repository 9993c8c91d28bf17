// Microphones hear the sounding beacons of the world: a footbot's from their real positions, those of any robot from
// the ring that the world's values describe, on the ground.
#include "swarmanoid_interface/devices/microphones.hpp"

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "../mock_device.hpp"
#include "swarmanoid_interface/devices/footbot_microphones.hpp"

namespace swarmanoid::mock {
namespace {

/// Microphones at given positions in the robot's frame [m].
class Ears {
 public:
  explicit Ears(std::vector<Eigen::Vector3d> places) : places_(std::move(places)), powers_(places_.size()) {
    for (const Eigen::Vector3d& place : places_) {
      centre_ += place / static_cast<double>(places_.size());
    }
  }

  void hear(const MockState& state) {
    const double background = Sound::power(Sound::kUsualBackground);
    powers_.assign(places_.size(), background);
    double total = background;
    double most = 0.0;
    loudest_ = {};
    const Beacon* source = nullptr;
    for (const Beacon& beacon : state.world.beacons) {
      const Eigen::Vector3d at = state.pose.toRobot(beacon.at);
      if (beacon.sound_level <= 0.0 || (at - centre_).norm() > Sound::kUsualRange) {
        continue;
      }
      const double power = Sound::power(beacon.sound_level);
      for (std::size_t i = 0; i < places_.size(); ++i) {
        powers_[i] += power * Sound::spread((at - places_[i]).squaredNorm());
      }
      const double heard = power * Sound::spread((at - centre_).squaredNorm());
      total += heard;
      if (heard > most) {
        most = heard;
        source = &beacon;
      }
    }
    if (source != nullptr) {
      loudest_ = LoudestSound::at(state.pose.toRobot(source->at) - centre_, most / total, source->sound_frequency,
                                  places_.size());
    }
  }

  const std::vector<Eigen::Vector3d>& places() const { return places_; }
  float level(std::size_t i) const { return static_cast<float>(Sound::level(powers_[i])); }
  const LoudestSound& loudest() const { return loudest_; }

 private:
  std::vector<Eigen::Vector3d> places_;
  std::vector<double> powers_;
  Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();
  LoudestSound loudest_;
};

class MockFootbotMicrophones final : public MockDevice {
 public:
  MockFootbotMicrophones(FootbotMicrophones& readings, MockState& /*state*/) : readings_(readings), ears_(places()) {}

  void sense(const MockState& state) override {
    ears_.hear(state);
    for (std::size_t i = 0; i < FootbotMicrophones::kCount; ++i) {
      readings_.level[i] = ears_.level(i);
    }
    readings_.loudest = ears_.loudest();
  }

 private:
  static std::vector<Eigen::Vector3d> places() {
    std::vector<Eigen::Vector3d> places;
    for (std::size_t i = 0; i < FootbotMicrophones::kCount; ++i) {
      places.push_back(FootbotMicrophones::place(i));
    }
    return places;
  }

  FootbotMicrophones& readings_;
  Ears ears_;
};

class MockMicrophones final : public MockDevice {
 public:
  MockMicrophones(Microphones& readings, MockState& state) : readings_(readings), ears_(places(state.world.ring)) {
    for (const Eigen::Vector3d& place : ears_.places()) {
      microphones_.push_back({0.0F, static_cast<float>(place.x()), static_cast<float>(place.y())});
    }
  }

  void sense(const MockState& state) override {
    ears_.hear(state);
    for (std::size_t i = 0; i < microphones_.size(); ++i) {
      microphones_[i].level = ears_.level(i);
    }
    readings_.sensors = microphones_;
    readings_.loudest = ears_.loudest();
  }

 private:
  static std::vector<Eigen::Vector3d> places(const World::Ring& ring) {
    std::vector<Eigen::Vector3d> places;
    for (std::size_t i = 0; i < ring.sensors; ++i) {
      places.emplace_back(ring.radius * std::cos(ring.angle(i)), ring.radius * std::sin(ring.angle(i)), 0.0);
    }
    return places;
  }

  Microphones& readings_;
  Ears ears_;
  std::vector<Microphone> microphones_;
};

REGISTER_MOCK_DEVICE(FootbotMicrophones, MockFootbotMicrophones)
REGISTER_MOCK_DEVICE(Microphones, MockMicrophones)

}  // namespace
}  // namespace swarmanoid::mock
