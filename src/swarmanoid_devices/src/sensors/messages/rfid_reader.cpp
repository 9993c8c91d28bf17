// The reader of radio tags, for any robot with an antenna.
#include "common/overflow_notes.hpp"
#include "common/span_readings.hpp"
#include "common/tags.hpp"
#include "swarmanoid_space/sensor.hpp"

namespace swarmanoid::devices {
namespace {

struct ReaderInstance : SpanReadings<BasicSensorInstance<RfidReader>, RfidTagReading> {
  Transmitter antenna;
  OverflowNote overflow;

  void archive(StateArchive& state) {
    SpanReadings::archive(state);
    state(overflow);
  }
};

class RfidReaderSensor final : public SensorOf<RfidReader, ReaderInstance> {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = RfidReader::kType;
    description.implementation = "default";
    description.is_default = true;
    description.summary = "Reads all tags within reach of the antenna, also behind obstacles.";
    const std::string most = std::to_string(RfidReader::kMostTags);
    description.parameters = {reachParameter(),
                              integer("slots", most, {1.0, static_cast<double>(RfidReader::kMostTags)},
                                      "Tags read at the most in one tick, the nearest.")};
    return description;
  }

  void configure(const Configuration& parameters) override {
    reach_ = parameters.number("reach");
    slots_ = static_cast<std::size_t>(parameters.integer("slots"));
  }

  void sense(const Space& space, std::size_t first, std::size_t last) override {
    thread_local TagSearch search;  // kept between calls so that a steady state allocates nothing
    for (std::size_t k = first; k < last; ++k) {
      senseOne(space, instances_[k], search);
    }
  }

  void report(const Space& space, const ReportAccess& access) override {
    for (ReaderInstance& instance : instances_) {
      noteOverflow(space, access, instance.row, RfidReader::kType, slots_, "tags", instance.readings->overflowed,
                   instance.overflow);
    }
  }

 protected:
  std::size_t mostElements() const override { return RfidReader::kMostTags; }

  void prepareInstance(const Space& space, ReaderInstance& instance) override {
    instance.antenna = antennaOf(*space.entities.model[instance.row], RfidReader::kType);
    instance.makeRoom(slots_);
  }

 private:
  void senseOne(const Space& space, ReaderInstance& instance, TagSearch& search) const {
    const auto& found = search.find(space, positionOf(space, instance.row, instance.antenna), reach_);
    const std::size_t count = std::min(found.size(), slots_);
    for (std::size_t i = 0; i < count; ++i) {
      instance.buffer[i] = {found[i].id, found[i].data};
    }
    instance.readings->tags = Span<const RfidTagReading>(instance.buffer.data(), count);
    instance.readings->overflowed = found.size() > count;
  }

  double reach_ = Rfid::kUsualReach;  // m
  std::size_t slots_ = RfidReader::kMostTags;
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_SENSOR(swarmanoid::devices::RfidReaderSensor)
