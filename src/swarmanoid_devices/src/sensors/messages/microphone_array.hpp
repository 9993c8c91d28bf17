/// Base class of microphones: each adds up the sounds that reach it, by the law of Sound, over a uniform background;
/// together they measure the direction of the loudest source. They are at the links microphone_0, microphone_1, ... of
/// the robot's description.
///
/// To add microphones, write their struct with `std::array<float, kCount> level` and `LoudestSound loudest`, and a
/// class such as
///
///     class MyMicrophones final : public MicrophoneArray<MyMicrophones, MyEars, MyEars::kCount> {
///      public:
///       static PluginDescription describe() { return describeArray("Two ears."); }
///       static float& levelOf(Instance& instance, std::size_t i) { return instance.readings->level[i]; }
///     };
#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <string>

#include "common/parameters.hpp"
#include "sensors/rays/ring_geometry.hpp"
#include "surroundings/sight_lines.hpp"
#include "surroundings/sound_sources.hpp"
#include "swarmanoid_interface/devices/microphones.hpp"
#include "swarmanoid_space/sensor.hpp"

namespace swarmanoid::devices {

static_assert(Microphones::kMost == kMostRingSensors);

template <class Device, int count>
struct MicrophoneInstance : BasicSensorInstance<Device> {
  std::shared_ptr<const RingGeometry<count>> ring;

  void archive(StateArchive& /*state*/) {}
};

/// `Array` derives from this, and has `static float& levelOf(Instance&, std::size_t)`, the reading of a microphone.
template <class Array, class Device, int count, class InstanceOfArray = MicrophoneInstance<Device, count>>
class MicrophoneArray : public SensorOf<Device, InstanceOfArray> {
  using Base = SensorOf<Device, InstanceOfArray>;

 public:
  using Instance = InstanceOfArray;

  void configure(const Configuration& parameters) override {
    range_ = parameters.number("range", Sound::kUsualRange);
    background_ = Sound::power(parameters.number("background", Sound::kUsualBackground));
    const double shadow = parameters.number("shadow", 0.0);
    casts_shadows_ = shadow > 0.0;
    shadowed_part_ = Sound::power(-shadow);
  }

  const void* add(Space& space, Row row) override {
    // the bank outlives the sensor, and exists even without loudspeakers
    loudspeakers_ = &space.actuation.template bank<Loudspeaker>();
    return Base::add(space, row);
  }

  void sense(const Space& space, std::size_t first, std::size_t last) override {
    // kept between calls so that a steady state allocates nothing
    thread_local Scratch scratch;
    scratch.sources.clear();
    for (std::size_t k = first; k < last; ++k) {
      senseOne(space, this->instances_[k], scratch);
    }
  }

 protected:
  static PluginDescription describeArray(const std::string& summary) {
    PluginDescription description;
    description.label = Device::kType;
    description.implementation = "inverse_square";
    description.is_default = true;
    description.summary = summary;
    description.parameters = {number("range", "m", numberText(Sound::kUsualRange), {0.001, 10000.0},
                                     "Distance from the middle of the microphones beyond which a source is not heard."),
                              number("background", "dB", numberText(Sound::kUsualBackground), {0.0, 140.0},
                                     "Sound pressure level of the surroundings, re 20 uPa, which is heard in silence."),
                              number("shadow", "dB", "0", {0.0, 100.0},
                                     "Attenuation of a source behind an obstacle; 0: obstacles are ignored.")};
    return description;
  }

  void prepareInstance(const Space& space, Instance& instance) override {
    instance.ring = rings_.of(space.entities.model[instance.row], Device::kType, {"microphone"});
  }

 private:
  struct Scratch {
    SoundSources sources;
    SightLines lines;
  };

  void senseOne(const Space& space, Instance& instance, Scratch& scratch) const {
    const RingGeometry<count>& ring = *instance.ring;
    const Pose& pose = space.entities.pose[instance.row];
    const Eigen::Vector3d centre = pose.toWorld(ring.centre);
    const auto& sources = scratch.sources.find(space, *loudspeakers_, instance.row, centre, range_);
    if (casts_shadows_ && !sources.empty()) {
      scratch.lines.begin(space, instance.row, centre, range_);
    }
    std::array<Eigen::Vector3d, RingGeometry<count>::kMost> microphones;
    std::array<double, RingGeometry<count>::kMost> powers;
    powers.fill(background_);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      microphones[i] = pose.toWorld(ring.from.col(static_cast<Eigen::Index>(i)));
    }
    double power_at_centre = background_;
    double loudest_power = 0.0;
    const SoundSource* loudest = nullptr;
    for (const SoundSource& source : sources) {
      const bool is_shadowed = casts_shadows_ && scratch.lines.isOccluded(source.position, source.row);
      const double power = is_shadowed ? shadowed_part_ * source.power : source.power;
      for (std::size_t i = 0; i < ring.size(); ++i) {
        powers[i] += power * Sound::spread((source.position - microphones[i]).squaredNorm());
      }
      const double heard = power * Sound::spread((source.position - centre).squaredNorm());
      power_at_centre += heard;
      if (heard > loudest_power) {
        loudest_power = heard;
        loudest = &source;
      }
    }
    for (std::size_t i = 0; i < ring.size(); ++i) {
      Array::levelOf(instance, i) = static_cast<float>(Sound::level(powers[i]));
    }
    instance.readings->loudest = {};
    if (loudest != nullptr) {
      instance.readings->loudest = LoudestSound::at(pose.orientation.conjugate() * (loudest->position - centre),
                                                    loudest_power / power_at_centre, loudest->frequency, ring.size());
    }
  }

  double range_ = Sound::kUsualRange;  // m
  double background_ = 0.0;            // power
  bool casts_shadows_ = false;
  double shadowed_part_ = 1.0;  // part of a source's power that passes an obstacle
  const Bank<Loudspeaker>* loudspeakers_ = nullptr;
  Rings<count> rings_;
};

}  // namespace swarmanoid::devices
