// A rule switches a lamp every 7 ticks, and a footbot's light sensors read it in exactly the ticks in which it is on.
#include <gtest/gtest.h>

#include <vector>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/light.hpp"
#include "swarmanoid_space/rule.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid {
namespace {

constexpr std::uint64_t kPeriod = 7;  // ticks
constexpr std::uint64_t kTicks = 31;

/// Off after 7 ticks, on again after 14, ...
class LampSwitch final : public Rule {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = "lamp_switch";
    return description;
  }
  void configure(const Configuration&) override {}
  void beforeTick(const Space& space, InterventionQueue& queue) override {
    if (space.tick > 0 && space.tick % kPeriod == 0) {
      const bool is_on = *space.property(space.entities.find("lamp"), "intensity") > 0.0;
      queue.ask(SetProperty{"lamp", "intensity", is_on ? "0" : "1.5"});
    }
  }
};

std::vector<float> readings;  // of the sensor ahead, one per tick

class LightReader final : public Controller {
 public:
  void init(Robot& robot, const Configuration&) override { light_ = &robot.sensor<Light>(); }
  void step(Time, Duration) override { readings.push_back(light_->sensors[0].value); }

 private:
  const Light* light_ = nullptr;
};

std::unique_ptr<Simulation> world(const std::string& rules) {
  loadBuiltInPlugins();
  // the lamp is 0.4 m ahead and 0.3 m to the left of the sensor, which is 0.085 m from the axis and 0.06 m above the
  // ground
  auto simulation = std::make_unique<Simulation>(parseExperiment(R"(
<ahss-config>
  <framework><clocktick>100</clocktick><maxclock>1000</maxclock></framework>
  <controllers><light_reader id="reader"><sensors><light/></sensors></light_reader></controllers>
  <arena size="5,5,3" optimization="2D">
    <footbot id="fb"><position>2, 2, 0</position><orientation>0, 0, 0</orientation>
      <controller>reader</controller></footbot>
    <light id="lamp"><position>2.485, 2.3, 0.06</position><orientation>0, 0, 0</orientation>
      <color>blue</color><intensity>1.5</intensity></light>
  </arena>)" + rules + "</ahss-config>",
                                                                 "lamp.xml"));
  simulation->start();
  return simulation;
}

std::unique_ptr<Simulation> switchedWorld() { return world("<rules><lamp_switch id='switch'/></rules>"); }

bool isOnIn(std::uint64_t tick) { return tick / kPeriod % 2 == 0; }

std::vector<std::uint64_t> hashesOfRun(Simulation& simulation) {
  std::vector<std::uint64_t> hashes;
  for (std::uint64_t tick = 0; tick < kTicks; ++tick) {
    simulation.tick();
    hashes.push_back(simulation.stateHash());
  }
  return hashes;
}

TEST(SwitchedLampTest, SensorsReadItInExactlyTheTicksInWhichItShines) {
  readings.clear();
  const auto simulation = switchedWorld();
  hashesOfRun(*simulation);
  ASSERT_EQ(readings.size(), kTicks);
  // blue: 1/3 of white; 0.5 m away: (0.1 / 0.5)^2; cosine 0.4 / 0.5
  const double shining = 1.5 / 3.0 * 0.04 * 0.8;
  for (std::uint64_t tick = 0; tick < kTicks; ++tick) {
    if (isOnIn(tick)) {
      EXPECT_NEAR(readings[tick], shining, 1e-7) << tick;
    } else {
      EXPECT_EQ(readings[tick], 0.0F) << tick;
    }
  }
}

TEST(SwitchedLampTest, TheHashDiffersFromThatOfALampThatStaysOnWhileItIsOff) {
  const auto steady = hashesOfRun(*world(""));
  const auto switched = hashesOfRun(*switchedWorld());
  for (std::uint64_t tick = 0; tick < kTicks; ++tick) {
    EXPECT_EQ(steady[tick] == switched[tick], isOnIn(tick)) << tick;
  }
}

TEST(SwitchedLampTest, EachSwitchIsAnEventOfItsTickAndNamesTheRule) {
  const auto simulation = switchedWorld();
  const Space& space = simulation->space();
  for (std::uint64_t tick = 0; tick < kTicks; ++tick) {
    simulation->tick();
    const bool is_switched = tick > 0 && tick % kPeriod == 0;
    ASSERT_EQ(space.events.size(), is_switched ? 1U : 0U) << tick;
    ASSERT_EQ(space.interventions.size(), space.events.size()) << tick;
    if (is_switched) {
      EXPECT_EQ(space.events[0].text, isOnIn(tick) ? "intensity from 0 to 1.5" : "intensity from 1.5 to 0") << tick;
      EXPECT_EQ(space.interventions[0].asked_by, "rule 'switch' (lamp_switch)");
    }
  }
}

TEST(SwitchedLampTest, AResetIsAFreshStart) {
  const auto simulation = switchedWorld();
  readings.clear();
  const auto first = hashesOfRun(*simulation);
  const std::vector<float> first_readings = readings;
  simulation->reset({}, true);
  readings.clear();
  EXPECT_EQ(hashesOfRun(*simulation), first);
  EXPECT_EQ(readings, first_readings);
}

}  // namespace
}  // namespace swarmanoid

REGISTER_RULE(swarmanoid::LampSwitch)
REGISTER_CONTROLLER(swarmanoid::LightReader, "light_reader")
