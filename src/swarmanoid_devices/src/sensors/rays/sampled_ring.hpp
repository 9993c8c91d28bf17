/// The implementation `sampled` of any ring of sensors, and the registration of rings with it.
///
/// Readings are taken from a table of recorded ones by distance and angle (thesis 3.1; sample_table.hpp has the file
/// format). The ideal implementation, its base class, finds the stimuli of each sensor; the table gives the reading for
/// each. A sensor with several stimuli, such as lamps, reads their sum.
///
/// A family of rings needs for it
///
///     static constexpr SampledLaw kSampledLaw{...};
///     double range() const;                   // maximum distance of a stimulus [m]
///     void setRange(const SampleTable&, const Configuration& parameters);  // from the table
///     static std::vector<Parameter> parametersBesideTable();
///     template <class Visit> void visitFelt(const Space&, const Instance&, Visit visit) const;
///
/// where visitFelt calls visit(sensor, distance [m], angle [rad], strength) for each stimulus of its sensors.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "ring_geometry.hpp"
#include "swarmanoid_experiment_files/samples/sample_table.hpp"
#include "swarmanoid_experiment_files/samples/sampled_sensor.hpp"

namespace swarmanoid::devices {

/// Margin of a sensor's range beyond its table, for rounding [m].
constexpr double kSampledMargin = 1e-9;

/// Properties of the tables of a family.
struct SampledLaw {
  Stimulus stimulus;
  Range readings;  ///< range of the finite readings
  double nothing;  ///< reading without a stimulus; infinite readings are allowed if this is infinite
};

template <class Ideal>
class SampledRing final : public Ideal, public SampledSensor {
 public:
  using Instance = typename Ideal::Instance;

  static PluginDescription describe() {
    PluginDescription description = Ideal::describe();
    description.implementation = "sampled";
    description.is_default = false;
    description.implementation_aliases.clear();
    description.summary += " Readings are taken from a table of recorded ones.";
    description.parameters = {makeParameter("file", Parameter::Type::kText, "", std::nullopt, {},
                                            "A CSV file of readings by distance and angle; its folder is relative to "
                                            "the experiment file's.")};
    for (Parameter& parameter : Ideal::parametersBesideTable()) {
      description.parameters.push_back(std::move(parameter));
    }
    return description;
  }

  void configure(const Configuration& parameters) override {
    const SampledLaw& law = Ideal::kSampledLaw;
    table_ = readSampleTable(parameters.text("file"), {law.readings, law.nothing == kInfinity});
    this->setRange(table_, parameters);
  }

  void sense(const Space& space, std::size_t first, std::size_t last) override {
    if (table_.isEmpty()) {
      Ideal::sense(space, first, last);
      return;
    }
    for (std::size_t k = first; k < last; ++k) {
      senseOne(space, this->instances_[k]);
    }
  }

  Stimulus stimulus() const override { return Ideal::kSampledLaw.stimulus; }
  void configureIdeal(const Configuration& parameters) override { Ideal::configure(parameters); }
  bool hasErrors() const override { return this->delivers_; }
  double reach() const override { return this->range(); }
  std::size_t sensorCount() const override { return this->instances_.front().ring->size(); }
  Line line(std::size_t sensor) const override {
    const auto column = static_cast<Eigen::Index>(sensor);
    const auto& ring = *this->instances_.front().ring;
    return {ring.from.col(column), ring.direction.col(column)};
  }
  double reading(std::size_t sensor) const override {
    // valueOf takes a mutable instance, but nothing is written here
    Instance& instance = const_cast<Instance&>(this->instances_.front());
    return static_cast<double>(Ideal::valueOf(instance, sensor));
  }

 private:
  void senseOne(const Space& space, Instance& instance) const {
    const SampledLaw& law = Ideal::kSampledLaw;
    const std::size_t size = instance.ring->size();
    std::array<double, kMostRingSensors> sums;
    std::array<bool, kMostRingSensors> feels;
    std::fill_n(sums.begin(), size, 0.0);
    std::fill_n(feels.begin(), size, false);
    instance.random.startTick(space.tick);
    this->visitFelt(space, instance, [&](std::size_t sensor, double distance, double angle, double strength) {
      const double rank = table_.isRandom() ? instance.random.uniform() : 0.0;
      sums[sensor] += strength * table_.reading(distance, angle, rank);
      feels[sensor] = true;
    });
    for (std::size_t i = 0; i < size; ++i) {
      const double felt = std::isfinite(sums[i]) ? std::min(sums[i], law.readings.maximum) : sums[i];
      Ideal::valueOf(instance, i) = static_cast<float>(feels[i] ? felt : law.nothing);
    }
  }

  SampleTable table_;  // empty: readings by the ideal law
};

}  // namespace swarmanoid::devices

/// At the end of the source of a ring of sensors: registers it with the ideal law, and with readings from a table.
#define REGISTER_RING(Class) \
  REGISTER_SENSOR(Class)     \
  REGISTER_SENSOR(::swarmanoid::devices::SampledRing<Class>)
