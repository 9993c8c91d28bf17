// Batteries of eyebots: power of flight, landing with an empty battery, and charging under the ceiling.
#include <gtest/gtest.h>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/eyebot_magnet.hpp"
#include "swarmanoid_interface/devices/eyebot_velocity.hpp"
#include "test_world.hpp"

namespace swarmanoid::test {
namespace {

/// Rises at a speed until its magnet attaches; then its rotors stop.
class TestFlyer final : public Controller {
 public:
  void init(Robot& robot, const Configuration& parameters) override {
    velocity_ = &robot.actuator<EyebotVelocity>();
    magnet_ = &robot.actuator<EyebotMagnet>();
    state_ = &robot.sensor<EyebotMagnetState>();
    up_ = parameters.number("up");
  }
  void step(Time, Duration) override {
    magnet_->on = true;
    velocity_->linear = {0.0, 0.0, state_->attached ? 0.0 : up_};
  }

 private:
  EyebotVelocity* velocity_ = nullptr;
  EyebotMagnet* magnet_ = nullptr;
  const EyebotMagnetState* state_ = nullptr;
  double up_ = 0.0;
};

// 2 kg, four discs of 0.092 m, efficiency 0.5: sqrt(19.62^3 / (2 * 1.225 * 0.1063616)) / 0.5
constexpr double kFlight = 340.4887;  // W
constexpr double kStandby = 4.0;      // W

std::unique_ptr<Simulation> started(double height, double up, double capacity, double level,
                                    const std::string& rules = "") {
  const std::string text =
      "<ahss-config><framework><clocktick>10</clocktick><maxclock>100000</maxclock></framework><controllers>"
      "<test_flyer id=\"fly\" library=\"swarmanoid_devices\"><actuators><eyebot_velocity/><eyebot_magnet/></actuators>"
      "<sensors><eyebot_magnet_state/><battery/></sensors><parameters><up>" +
      numberText(up) +
      "</up></parameters></test_flyer></controllers><arena size=\"4,4,5\" optimization=\"3D\">"
      "<ceiling_perch "
      "id=\"perch\"><position>2,2,2.5</position><orientation>0,0,0</orientation><capacity>5000</capacity>"
      "<supply>0</supply></ceiling_perch><eyebot id=\"eb\"><position>2,2," +
      numberText(height) +
      "</position><orientation>0,0,0</orientation><controller>fly</controller><battery>true</"
      "battery><battery_capacity>" +
      numberText(capacity) + "</battery_capacity><battery_level>" + numberText(level) +
      "</battery_level></eyebot></arena><engines><dynamics3d id=\"air\"/></engines><arena_physics><engine id=\"air\">" +
      member("perch") + member("eb") + "</engine></arena_physics><rules>" + rules + "</rules></ahss-config>";
  loadBuiltInPlugins();
  auto simulation = std::make_unique<Simulation>(parseExperiment(text, "test.xml"));
  simulation->start();
  return simulation;
}

double of(const Simulation& simulation, const std::string& entity, const std::string& property) {
  return *simulation.space().property(simulation.space().entities.find(entity), property);
}

const BatteryState& stateOf(const Simulation& simulation) {
  return simulation.space().batteries[simulation.space().entities.find("eb")][0];
}

TEST(FlyingBatteryTest, HoverPowerIsThatOfMomentumTheory) {
  EXPECT_NEAR(robotModel("eyebot")->possible_battery->flight, kFlight, 1e-3);
  EXPECT_NEAR(hoverPower(1.0, 0.5, 1.0), 27.76102, 1e-5) << "1 kg under 0.5 m2: sqrt(9.81^3 / 1.225)";
  EXPECT_NEAR(hoverPower(4.0, 0.5, 1.0) / hoverPower(1.0, 0.5, 1.0), 8.0, 1e-12);
}

TEST(FlyingBatteryTest, FlyingDrawsItAndStandingDoesNot) {
  const auto flying = started(1.0, 0.0, 199800.0, 1.0);
  tick(*flying, 43);
  EXPECT_NEAR(stateOf(*flying).used, 0.43 * (kStandby + kFlight), 1e-3);
  const auto standing = started(0.0, -0.1, 199800.0, 1.0);
  tick(*standing, 43);
  EXPECT_NEAR(stateOf(*standing).used, 0.43 * kStandby, 1e-9);
}

TEST(FlyingBatteryTest, AnEyebotWhoseBatteryIsEmptyLands) {
  // 400 J at 3.4449 J a tick: 116.1 ticks
  const auto simulation = started(1.0, 0.0, 400.0, 1.0);
  tick(*simulation, 116);
  EXPECT_FALSE(stateOf(*simulation).is_empty);
  tick(*simulation, 1);
  EXPECT_TRUE(stateOf(*simulation).is_empty);
  EXPECT_NEAR(poseOf(*simulation, "eb").position.z(), 1.0, 0.05);
  tick(*simulation, 700);  // it hovers for 2 s, and descends at 0.3 m/s
  EXPECT_NEAR(poseOf(*simulation, "eb").position.z(), 0.0, 0.02);
  EXPECT_NEAR(stateOf(*simulation).used, 400.0, 1e-9);
}

TEST(FlyingBatteryTest, OneThatIsHighUpLandsToo) {
  // a safe stop alone would lower it by 2.4 m, beside the perch at 2.5 m
  const auto simulation = started(4.0, 0.0, 400.0, 1.0);
  simulation->apply(DeleteEntity{"perch"});
  tick(*simulation, 117);
  EXPECT_TRUE(stateOf(*simulation).is_empty);
  tick(*simulation, 1100);  // 2 s and 8 s of the stop, and a second
  EXPECT_LT(poseOf(*simulation, "eb").position.z(), 1.5);
  tick(*simulation, 600);
  EXPECT_NEAR(poseOf(*simulation, "eb").position.z(), 0.0, 0.02);
  EXPECT_NEAR(stateOf(*simulation).used, 400.0, 1e-9);
}

TEST(FlyingBatteryTest, AnEyebotIsChargedByThePerchThatItHangsFrom) {
  const auto simulation =
      started(1.80, 0.2, 3000.0, 0.5, "<charging id=\"charging\"><interval>0.1</interval></charging>");
  double received = 0.0;
  double used_before = 0.0;
  bool hangs = false;
  for (int i = 0; i < 1500; ++i) {
    used_before = stateOf(*simulation).used;
    simulation->tick();
    const Row row = simulation->space().entities.find("eb");
    hangs = simulation->space().attachments.isAttached(row);
    received = stateOf(*simulation).received;
    if (!hangs) {
      ASSERT_EQ(received, 0.0) << "it only flies below";
    }
    ASSERT_NEAR(of(*simulation, "eb", "charge"), 1500.0 + received - stateOf(*simulation).used, 1e-6);
  }
  ASSERT_TRUE(hangs);
  EXPECT_NEAR(stateOf(*simulation).used - used_before, 0.01 * kStandby, 1e-9) << "its rotors rest";
  EXPECT_GT(received, 300.0);
  EXPECT_NEAR(of(*simulation, "perch", "charge"), 5000.0 - std::get<double>(simulation->metrics().at("charging.given")),
              1e-6);
  EXPECT_NEAR(of(*simulation, "perch", "charge") + received, 5000.0, 50.0 * 0.1 + 1e-6) << "it pays each 0.1 s";
}

}  // namespace
}  // namespace swarmanoid::test

REGISTER_CONTROLLER(swarmanoid::test::TestFlyer, "test_flyer")
