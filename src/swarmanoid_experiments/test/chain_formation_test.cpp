// The installed experiment `chain_formation`: reactions of one robot to the end of a chain; and the paper's result that
// the time of the first path grows with the distance between nest and prey. Without links there is no path.
#include <gtest/gtest.h>

#include "installed_experiment.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/color_blob_camera.hpp"
#include "swarmanoid_interface/devices/footbot_beacon.hpp"
#include "swarmanoid_interface/devices/footbot_proximity.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "test_world.hpp"

namespace swarmanoid::test {
namespace {

constexpr auto kTick = std::chrono::milliseconds(100);
constexpr Color kNest{255, 0, 255};

/// A robot whose readings the test sets; it joins a chain as soon as it may.
class OneRobot {
 public:
  explicit OneRobot(const std::string& leaving = "0", const std::string& nest = "magenta") {
    robot_.provideSensor(FootbotCamera::kType, &camera_);
    robot_.provideSensor(FootbotProximity::kType, &proximity_);
    robot_.provideActuator(FootbotWheels::kType, &wheels_);
    robot_.provideActuator(FootbotBeacon::kType, &beacon);
    loadPluginLibrary("chain_formation", {}, {});
    controller_ = makePlugin<Controller>(*Registry::instance().find(PluginKind::kController, "chain_formation"));
    Configuration parameters("parameters", "", {"chain.xml", 7});
    parameters.set("distance", "0.7");
    parameters.set("joining", "10");
    parameters.set("leaving", leaving);
    parameters.set("nest_color", nest);
    controller_->init(robot_, parameters);
  }

  void see(Color color, double distance, double bearing) {
    blobs_.push_back({color, static_cast<float>(bearing), static_cast<float>(distance)});
  }
  void seeNothing() { blobs_.clear(); }
  void step(int ticks = 1) {
    for (int i = 0; i < ticks; ++i) {
      camera_.blobs = blobs_;
      robot_.startTick(tick_, kEpoch + tick_ * kTick);
      controller_->step(kEpoch + tick_++ * kTick, kTick);
    }
  }
  bool isDriving() const { return wheels_.left != 0.0 || wheels_.right != 0.0; }

  FootbotBeacon beacon;

 private:
  Robot robot_{"robot", "footbot", 1};
  FootbotCamera camera_;
  FootbotProximity proximity_;
  FootbotWheels wheels_;
  std::vector<ColorBlob> blobs_;
  std::uint64_t tick_ = 0;
  std::shared_ptr<Controller> controller_;
};

TEST(ChainFormationControllerTest, WhoIsBeyondTheEndOfAChainShowsTheNextColour) {
  const std::vector<std::vector<Color>> chains = {{kNest, colors::kBlue},
                                                  {kNest, colors::kBlue, colors::kGreen},
                                                  {colors::kBlue, colors::kGreen, colors::kYellow},
                                                  {colors::kYellow, colors::kBlue, colors::kGreen},
                                                  {colors::kGreen, colors::kYellow, colors::kBlue}};
  for (const std::vector<Color>& chain : chains) {
    OneRobot robot;
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {  // collinear, 0.7 m apart
      robot.see(chain[i], 0.7 * static_cast<double>(chain.size() - 1 - i), 2.9);
    }
    robot.step(2);  // it perceives, then joins
    EXPECT_EQ(toString(robot.beacon.color), toString(chain.back()));
    EXPECT_FALSE(robot.isDriving());
  }
}

TEST(ChainFormationControllerTest, WhoIsBesideTheChainOrSeesItGoOnDoesNotJoin) {
  OneRobot beside;
  beside.see(kNest, 0.99, 0.8);
  beside.see(colors::kBlue, 0.7, 0.0);  // 45 degrees off the line through both
  OneRobot amid;
  amid.see(kNest, 0.7, 0.0);
  amid.see(colors::kBlue, 0.9, 3.0);
  for (OneRobot* robot : {&beside, &amid}) {
    robot->step(2);
    EXPECT_FALSE(robot->beacon.color.isLit());
    EXPECT_TRUE(robot->isDriving());
  }
}

TEST(ChainFormationControllerTest, ALinkLeavesWhenTheOneBeforeIsGone) {
  OneRobot robot;
  robot.see(kNest, 0.7, 1.0);
  robot.step(2);
  EXPECT_TRUE(robot.beacon.color.isLit());
  robot.seeNothing();
  robot.step(19);
  EXPECT_TRUE(robot.beacon.color.isLit()) << "for 2 s somebody may have driven past";
  robot.step(2);
  EXPECT_FALSE(robot.beacon.color.isLit());
}

TEST(ChainFormationControllerTest, TheLastLinkLeavesByChanceUnlessItSeesAPrey) {
  OneRobot last("10"), beside_prey("10"), in_the_middle("10");
  for (OneRobot* robot : {&last, &beside_prey, &in_the_middle}) {
    robot->see(kNest, 0.7, 1.0);
    robot->step(2);
    EXPECT_TRUE(robot->beacon.color.isLit());
  }
  beside_prey.see(colors::kRed, 0.6, -1.0);
  in_the_middle.see(colors::kGreen, 0.7, -2.0);
  for (OneRobot* robot : {&last, &beside_prey, &in_the_middle}) {
    robot->step();
  }
  EXPECT_FALSE(last.beacon.color.isLit());
  EXPECT_TRUE(beside_prey.beacon.color.isLit());
  EXPECT_TRUE(in_the_middle.beacon.color.isLit());
}

TEST(ChainFormationControllerTest, ANestInAColourOfLinksIsRefused) {
  try {
    OneRobot robot("0", "green");
    FAIL() << "it was not refused";
  } catch (const ConfigError& error) {
    EXPECT_STREQ(error.what(),
                 "chain.xml:7: nest_color: found 'green', which links show, allowed: any other colour than blue, green "
                 "and yellow");
  }
}

TEST(ChainFormationControllerTest, ANestInTheColourOfThePreyIsRefused) {
  try {
    OneRobot robot("0", "red");
    FAIL() << "it was not refused";
  } catch (const ConfigError& error) {
    EXPECT_STREQ(error.what(),
                 "chain.xml:7: nest_color: found 'red', which is prey_color too, allowed: a colour of its own");
  }
}

/// Runs to the end. @return the time of the first path [s], or of the end
double formationTime(std::uint64_t seed, const std::vector<std::string>& overrides, bool is_success) {
  const auto simulation = installed("chain_formation", seed, overrides);
  finish(*simulation);
  EXPECT_TRUE(simulation->failures().empty());
  EXPECT_EQ(simulation->success(), std::optional<bool>(is_success)) << "seed " << seed << ", " << overrides.back();
  return metricOf(*simulation, "path.formation_time");
}

TEST(ChainFormationExperimentTest, APathTakesTheLongerTheFartherThePreyIs) {
  constexpr std::uint64_t kSeeds = 4;
  std::vector<double> means;  // mean times [s]
  for (const char* prey : {"1.8, 1, 0", "2.6, 1, 0", "3.4, 1, 0"}) {
    means.push_back(0.0);
    for (std::uint64_t seed = 11; seed < 11 + kSeeds; ++seed) {
      means.back() += formationTime(seed, {std::string("arena.prey.position=") + prey}, true) / kSeeds;
    }
  }
  EXPECT_LT(means[0], means[1]);
  EXPECT_LT(means[1], means[2]);
}

TEST(ChainFormationExperimentTest, WithoutLinksThatStayThereIsNoPath) {
  for (std::uint64_t seed = 11; seed <= 12; ++seed) {
    for (const char* override : {"controllers.cc.parameters.joining=0", "controllers.cc.parameters.leaving=10"}) {
      formationTime(seed, {"framework.maxclock=3000", override}, false);
    }
  }
}

TEST(ChainFormationExperimentTest, TheSameSeedGivesTheSameBits) {
  const std::string far_away = "arena.prey.position=5.6,1,0";
  const auto expected = hashesOf(*installed("chain_formation", 4, {far_away}), 300);
  EXPECT_EQ(hashesOf(*installed("chain_formation", 4, {far_away}, 2), 300), expected) << "on two threads";
  EXPECT_NE(hashesOf(*installed("chain_formation", 5, {far_away}), 300), expected) << "another seed";
}

}  // namespace
}  // namespace swarmanoid::test
