// The rule `charging`: energy that perches supply to battery-powered robots, and robots that stop; and the installed
// experiment.
#include <gtest/gtest.h>

#include <fstream>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "test_world.hpp"

namespace swarmanoid::test {
namespace {

double metricOf(const Simulation& simulation, const std::string& name) {
  return std::get<double>(simulation.metrics().at("charging." + name));
}

double chargeOf(const Simulation& simulation, const std::string& perch) {
  return *simulation.space().property(simulation.space().entities.find(perch), "charge");
}

Color colorOf(const Simulation& simulation, const std::string& perch) {
  return simulation.space().entities.color[simulation.space().entities.find(perch)];
}

std::string perch(const std::string& id, double x, double y, const std::string& parameters) {
  return "<charging_perch id=\"" + id + "\"><position>" + numberText(x) + "," + numberText(y) +
         ",0</position><orientation>0,0,0</orientation>" + parameters + "</charging_perch>";
}

/// A battery-powered footbot without super-capacitor. It draws 3.74 W, and 0.7733 W more at 2 rad/s.
std::string powered(const std::string& id, double x, double y, double capacity, double level = 1.0) {
  std::string text = footbot(id, x, y, 0);
  return text.insert(text.find("</footbot>"),
                     "<battery>true</battery><battery_capacitor>0</battery_capacitor><battery_capacity>" +
                         numberText(capacity) + "</battery_capacity><battery_level>" + numberText(level) +
                         "</battery_level><battery_enough>0.6</battery_enough>");
}

/// Ticks of 0.1 s; perches look for robots every 0.3 s.
std::unique_ptr<Simulation> chargingWorld(const std::string& perches, const std::string& robots,
                                          const std::string& members, const std::string& drive,
                                          const std::string& parameters) {
  World world;
  world.entities = perches + robots;
  world.members = members;
  world.drive = drive;
  world.rules = "<charging id=\"charging\"><interval>0.3</interval>" + parameters + "</charging>";
  world.ticks = 10000;
  auto simulation = world.make();
  simulation->start();
  return simulation;
}

constexpr const char* kStill = "<left>0</left><right>0</right>";
constexpr double kStandby = 3.74;  // W

const BatteryState& batteryOf(const Simulation& simulation, const std::string& robot) {
  return simulation.space().batteries[simulation.space().entities.find(robot)][0];
}

double supplyOf(const Simulation& simulation, const std::string& robot) {
  return *simulation.space().property(simulation.space().entities.find(robot), "supply");
}

TEST(ChargingTest, CountsWhatRobotsWithABatteryUse) {
  const auto simulation =
      chargingWorld("", powered("fb_1", 5, 5, 100) + powered("fb_2", 6, 5, 50) + footbot("fb_3", 7, 5, 0),
                    member("fb_1") + member("fb_2") + member("fb_3"), kStill, "");
  tick(*simulation, 17);
  EXPECT_NEAR(metricOf(*simulation, "drained"), 2.0 * 1.7 * kStandby, 1e-9);
  EXPECT_NEAR(metricOf(*simulation, "mean_level"), 75.0 - 1.7 * kStandby, 1e-9);
}

TEST(ChargingTest, APerchGivesToWhoeverIsWithinReachAndShowsIt) {
  const auto simulation = chargingWorld(
      perch("near", 5.29, 5, "<supply>0</supply>") + perch("far", 5, 5.31, "<supply>0</supply>"),
      powered("fb", 5, 5, 500, 0.5), member("near") + member("far") + member("fb"), kStill, "<power>40</power>");
  simulation->tick();
  EXPECT_EQ(chargeOf(*simulation, "near"), 2000.0) << "it has not paid yet";
  EXPECT_EQ(colorOf(*simulation, "near"), colors::kYellow);
  EXPECT_EQ(colorOf(*simulation, "far"), colors::kGreen);
  tick(*simulation, 9);
  // before the ticks 3, 6 and 9: 0.3 s of 40 W each
  EXPECT_NEAR(chargeOf(*simulation, "near"), 2000.0 - 36.0, 1e-9);
  EXPECT_EQ(chargeOf(*simulation, "far"), 2000.0);
  EXPECT_NEAR(metricOf(*simulation, "mean_level"), 250.0 + 40.0 - kStandby, 1e-9);
  simulation->apply(MoveEntity{"fb", {{8.0, 8.0, 0.0}, Eigen::Quaterniond::Identity()}});
  tick(*simulation, 3);
  EXPECT_EQ(colorOf(*simulation, "near"), colors::kGreen);
  EXPECT_EQ(supplyOf(*simulation, "fb"), 0.0);
  EXPECT_NEAR(chargeOf(*simulation, "near"), 2000.0 - 48.0, 1e-9) << "until it looked again";
  tick(*simulation, 9);
  EXPECT_NEAR(chargeOf(*simulation, "near"), 2000.0 - 48.0, 1e-9);
}

TEST(ChargingTest, ItGivesToOneAtATimeWhichIsTheOneThatItHas) {
  const auto simulation = chargingWorld(perch("perch", 5, 5, "<supply>0</supply>"),
                                        powered("fb_1", 8, 8, 500, 0.5) + powered("fb_2", 5.2, 5, 500, 0.5),
                                        member("perch") + member("fb_1") + member("fb_2"), kStill, "");
  tick(*simulation, 4);
  EXPECT_NEAR(metricOf(*simulation, "given"), 15.0, 1e-9) << "0.3 s of 50 W";
  simulation->apply(MoveEntity{"fb_1", {{4.8, 5.0, 0.0}, Eigen::Quaterniond::Identity()}});
  tick(*simulation, 6);
  EXPECT_NEAR(metricOf(*simulation, "given"), 45.0, 1e-9) << "not to both";
  EXPECT_EQ(batteryOf(*simulation, "fb_1").received, 0.0);
  simulation->apply(MoveEntity{"fb_2", {{8.0, 8.0, 0.0}, Eigen::Quaterniond::Identity()}});
  tick(*simulation, 6);
  EXPECT_NEAR(metricOf(*simulation, "given"), 75.0, 1e-9) << "the other one's turn";
  EXPECT_NEAR(batteryOf(*simulation, "fb_1").received, 20.0, 1e-9);
}

TEST(ChargingTest, APerchRunsEmptyAndRecovers) {
  const auto simulation = chargingWorld(
      perch("perch", 5, 5, "<capacity>100</capacity><level>0.2</level><supply>10</supply>"),
      powered("fb", 5.2, 5, 1000, 0.5), member("perch") + member("fb"), kStill, "<power>60</power><ready>8</ready>");
  // -18 + 3: 5 J remain, which it can supply in 0.3 s; then -5 + 3: empty, until it has 9 J
  tick(*simulation, 4);
  EXPECT_NEAR(chargeOf(*simulation, "perch"), 5.0, 1e-9);
  EXPECT_EQ(colorOf(*simulation, "perch"), colors::kYellow);
  EXPECT_NEAR(supplyOf(*simulation, "fb"), 5.0 / 0.3, 1e-9);
  tick(*simulation, 3);
  EXPECT_NEAR(chargeOf(*simulation, "perch"), 3.0, 1e-9);
  EXPECT_EQ(colorOf(*simulation, "perch"), colors::kRed);
  EXPECT_EQ(supplyOf(*simulation, "fb"), 0.0);
  tick(*simulation, 5);
  EXPECT_NEAR(chargeOf(*simulation, "perch"), 6.0, 1e-9);
  EXPECT_EQ(colorOf(*simulation, "perch"), colors::kRed);
  EXPECT_NEAR(metricOf(*simulation, "given"), 23.0, 1e-9);
  tick(*simulation, 1);
  EXPECT_NEAR(chargeOf(*simulation, "perch"), 9.0, 1e-9);
  EXPECT_EQ(colorOf(*simulation, "perch"), colors::kYellow);
  tick(*simulation, 3);
  EXPECT_NEAR(metricOf(*simulation, "given"), 32.0, 1e-9);
  EXPECT_NEAR(batteryOf(*simulation, "fb").received, 32.0, 1e-9);
}

TEST(ChargingTest, AnEmptyRobotIsCommandedByNobodyUntilItHasEnough) {
  // wheels of 0.029 m at 2 rad/s: 0.058 m/s, and 4.5133 W; 2.9 J last for 6.4 ticks
  const auto simulation =
      chargingWorld(perch("perch", 7, 5, ""), powered("fb", 5, 5, 2.9), member("perch") + member("fb"),
                    "<left>2</left><right>2</right>", "<power>4</power>");
  tick(*simulation, 7);
  EXPECT_EQ(metricOf(*simulation, "ran_empty"), 1.0);
  EXPECT_EQ(metricOf(*simulation, "empty"), 1.0);
  EXPECT_NEAR(metricOf(*simulation, "drained"), 2.9, 1e-12);
  EXPECT_NEAR(poseOf(*simulation, "fb").position.x(), 5.0 + 0.7 * 0.058, 1e-6);
  tick(*simulation, 1);
  const double stopped_at = poseOf(*simulation, "fb").position.x();
  tick(*simulation, 19);
  EXPECT_NEAR(poseOf(*simulation, "fb").position.x(), stopped_at, 1e-9);
  EXPECT_EQ(metricOf(*simulation, "mean_level"), 0.0) << "and it uses nothing";
  simulation->apply(MoveEntity{"fb", {{6.75, 5.2, 0.0}, Eigen::Quaterniond::Identity()}});
  // the perch at (7, 5) is 0.32 m away, out of reach
  tick(*simulation, 6);
  EXPECT_EQ(metricOf(*simulation, "mean_level"), 0.0);
  simulation->apply(MoveEntity{"fb", {{6.9, 5.2, 0.0}, Eigen::Quaterniond::Identity()}});
  tick(*simulation, 3);
  EXPECT_NEAR(metricOf(*simulation, "mean_level"), 1.2, 1e-9);
  EXPECT_EQ(metricOf(*simulation, "empty"), 1.0) << "not enough";
  EXPECT_NEAR(poseOf(*simulation, "fb").position.x(), 6.9, 1e-9);
  tick(*simulation, 3);
  EXPECT_EQ(metricOf(*simulation, "empty"), 0.0);
  EXPECT_GT(poseOf(*simulation, "fb").position.x(), 6.9 + 0.005) << "it drives on";
  EXPECT_EQ(metricOf(*simulation, "ran_empty"), 1.0);
}

TEST(ChargingTest, APerchThatIsDeletedChargesNobody) {
  const auto simulation = chargingWorld(perch("perch", 5, 5, ""), powered("fb", 5.2, 5, 500, 0.5),
                                        member("perch") + member("fb"), kStill, "");
  tick(*simulation, 4);
  EXPECT_EQ(supplyOf(*simulation, "fb"), 50.0);
  simulation->apply(DeleteEntity{"perch"});
  tick(*simulation, 1);
  EXPECT_EQ(supplyOf(*simulation, "fb"), 0.0);
}

TEST(ChargingTest, APerchWhoseRobotIsDeletedIsFree) {
  const auto simulation = chargingWorld(perch("perch", 5, 5, ""), powered("fb", 5.2, 5, 500, 0.5),
                                        member("perch") + member("fb"), kStill, "");
  tick(*simulation, 4);
  EXPECT_EQ(colorOf(*simulation, "perch"), colors::kYellow);
  simulation->apply(DeleteEntity{"fb"});
  tick(*simulation, 3);
  EXPECT_EQ(colorOf(*simulation, "perch"), colors::kGreen);
}

TEST(ChargingTest, WhoIsDeletedCountsNoMoreAndAResetStartsAnew) {
  const auto simulation = chargingWorld("", powered("fb_1", 5, 5, 50) + powered("fb_2", 6, 5, 50),
                                        member("fb_1") + member("fb_2"), kStill, "<robot>fb_</robot>");
  tick(*simulation, 10);
  EXPECT_NEAR(metricOf(*simulation, "mean_level"), 50.0 - kStandby, 1e-9);
  simulation->apply(DeleteEntity{"fb_1"});
  tick(*simulation, 10);
  EXPECT_NEAR(metricOf(*simulation, "mean_level"), 50.0 - 2.0 * kStandby, 1e-9);
  EXPECT_NEAR(metricOf(*simulation, "drained"), 3.0 * kStandby, 1e-9);
  simulation->reset();
  EXPECT_EQ(metricOf(*simulation, "drained"), 0.0);
  tick(*simulation, 10);
  EXPECT_NEAR(metricOf(*simulation, "mean_level"), 50.0 - kStandby, 1e-9) << "both are there again, and full";
}

// Limits of the experiment; each of its 4 robots has 1000 J at first.
constexpr double kLeastLevel = 300.0;  // J, mean over the robots, at any time
constexpr double kMostRanEmpty = 1.0;  // robots in 600 s
constexpr double kUncaring = 4.0;      // robots that ran empty among those that never look for a perch

/// @param little part of the capacity below which a robot looks for a perch
std::unique_ptr<Simulation> charging(std::uint64_t seed, const std::string& little = "0.7", int threads = 1) {
  loadBuiltInPlugins();
  std::ifstream file(findShared("swarmanoid_experiments", "experiments/charging.xml"));
  std::string text(std::istreambuf_iterator<char>(file), {});
  const std::string plain = "<little>0.7</little>";
  text.replace(text.find(plain), plain.size(), "<little>" + little + "</little>");
  Experiment experiment = parseExperiment(text, "charging.xml");
  experiment.framework.seed = seed;
  experiment.framework.threads = threads;
  auto simulation = std::make_unique<Simulation>(std::move(experiment));
  simulation->start();
  return simulation;
}

constexpr std::uint64_t kInterval = 5;  // ticks

double sumOf(const Simulation& simulation, double BatteryState::*member) {
  double sum = 0.0;
  for (const Row row : simulation.space().powered) {
    sum += simulation.space().batteries[row][0].*member;
  }
  return sum;
}

double capacitors(const Simulation& simulation) {
  double sum = 0.0;
  for (const Row row : simulation.space().powered) {
    sum += simulation.space().properties[row][kBatteryCapacitor];
  }
  return sum;
}

TEST(ChargingExperimentTest, RobotsKeepGoingAndNothingIsLost) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const auto simulation = charging(seed);
    while (!simulation->isFinished()) {
      const double received_before = sumOf(*simulation, &BatteryState::received);
      simulation->tick();
      const double level = metricOf(*simulation, "mean_level");
      const double given = metricOf(*simulation, "given");
      ASSERT_GE(level, kLeastLevel) << "seed " << seed << ", tick " << simulation->space().tick;
      ASSERT_NEAR(4.0 * level + capacitors(*simulation),
                  4.0 * 1060.0 - metricOf(*simulation, "drained") + sumOf(*simulation, &BatteryState::received), 1e-6);
      if ((simulation->space().tick - 1) % kInterval == 0) {
        ASSERT_NEAR(given, received_before, 1e-6) << "perches have paid";
      }
      ASSERT_NEAR(chargeOf(*simulation, "perch_1") + chargeOf(*simulation, "perch_2"),
                  2.0 * 2000.0 + metricOf(*simulation, "supplied") - given, 1e-6);
    }
    EXPECT_LE(metricOf(*simulation, "ran_empty"), kMostRanEmpty) << "seed " << seed;
    EXPECT_GT(metricOf(*simulation, "given"), 4.0 * 1000.0) << "each was charged more than once";
    EXPECT_TRUE(simulation->failures().empty());
  }
}

TEST(ChargingExperimentTest, ThoseThatLookForNoPerchRunEmpty) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const auto simulation = charging(seed, "0");
    while (!simulation->isFinished()) {
      simulation->tick();
    }
    EXPECT_GE(metricOf(*simulation, "ran_empty"), kUncaring) << "seed " << seed;
  }
}

TEST(ChargingExperimentTest, TheSameSeedGivesTheSameBits) {
  const auto expected = hashesOf(*charging(3), 1500);
  EXPECT_EQ(hashesOf(*charging(3, "0.7", 2), 1500), expected) << "on two threads";
  const auto used = charging(4);
  hashesOf(*used, 700);
  used->reset(3);
  EXPECT_EQ(hashesOf(*used, 1500), expected) << "after a reset";
}

}  // namespace
}  // namespace swarmanoid::test
