// The rule `charging`: what robots use, what perches give, and who stops; and the installed experiment.
#include <gtest/gtest.h>

#include <fstream>

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

/// Ticks of 0.1 s; perches give every 0.3 s.
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

void tick(Simulation& simulation, int ticks) {
  for (int i = 0; i < ticks; ++i) {
    simulation.tick();
  }
}

TEST(ChargingTest, RobotsUseLessWhenTheyStand) {
  const std::string powers = "<capacity>100</capacity><moving_power>7</moving_power><still_power>0.9</still_power>";
  const auto standing = chargingWorld("", footbot("fb", 5, 5, 0), member("fb"), kStill, powers);
  tick(*standing, 17);
  EXPECT_NEAR(metricOf(*standing, "mean_level"), 100.0 - 1.7 * 0.9, 1e-9);
  const auto driving =
      chargingWorld("", footbot("fb", 5, 5, 0), member("fb"), "<left>2</left><right>2</right>", powers);
  tick(*driving, 17);
  EXPECT_NEAR(metricOf(*driving, "mean_level"), 100.0 - 1.7 * 7.0, 1e-9);
  EXPECT_NEAR(metricOf(*driving, "drained"), 1.7 * 7.0, 1e-9);
  const auto turning =
      chargingWorld("", footbot("fb", 5, 5, 0), member("fb"), "<left>-1</left><right>1</right>", powers);
  tick(*turning, 17);
  EXPECT_NEAR(metricOf(*turning, "mean_level"), 100.0 - 1.7 * 7.0, 1e-9) << "on the spot";
}

TEST(ChargingTest, APerchGivesToWhoeverIsWithinReachAndShowsIt) {
  const auto simulation = chargingWorld(
      perch("near", 5.29, 5, "<supply>0</supply>") + perch("far", 5, 5.31, "<supply>0</supply>"),
      footbot("fb", 5, 5, 0), member("near") + member("far") + member("fb"), kStill,
      "<capacity>500</capacity><first_level>0.5</first_level><still_power>1</still_power><power>40</power>");
  simulation->tick();
  EXPECT_EQ(chargeOf(*simulation, "near"), 2000.0) << "no time has passed";
  EXPECT_EQ(colorOf(*simulation, "near"), colors::kYellow);
  EXPECT_EQ(colorOf(*simulation, "far"), colors::kGreen);
  tick(*simulation, 9);
  // before the ticks 3, 6 and 9: 0.3 s of 40 W each
  EXPECT_NEAR(chargeOf(*simulation, "near"), 2000.0 - 36.0, 1e-9);
  EXPECT_EQ(chargeOf(*simulation, "far"), 2000.0);
  EXPECT_NEAR(metricOf(*simulation, "mean_level"), 250.0 + 36.0 - 1.0, 1e-9);
  simulation->apply(MoveEntity{"fb", {{8.0, 8.0, 0.0}, Eigen::Quaterniond::Identity()}});
  tick(*simulation, 3);
  EXPECT_EQ(colorOf(*simulation, "near"), colors::kGreen);
  EXPECT_NEAR(chargeOf(*simulation, "near"), 2000.0 - 36.0, 1e-9);
}

TEST(ChargingTest, ItGivesToOneAtATimeWhichIsTheOneThatItHas) {
  const auto simulation =
      chargingWorld(perch("perch", 5, 5, "<supply>0</supply>"), footbot("fb_1", 8, 8, 0) + footbot("fb_2", 5.2, 5, 0),
                    member("perch") + member("fb_1") + member("fb_2"), kStill,
                    "<capacity>500</capacity><first_level>0.5</first_level><still_power>0</still_power>");
  tick(*simulation, 4);
  EXPECT_NEAR(metricOf(*simulation, "given"), 15.0, 1e-9) << "0.3 s of 50 W";
  simulation->apply(MoveEntity{"fb_1", {{4.8, 5.0, 0.0}, Eigen::Quaterniond::Identity()}});
  tick(*simulation, 6);
  EXPECT_NEAR(metricOf(*simulation, "given"), 45.0, 1e-9) << "not to both";
  simulation->apply(MoveEntity{"fb_2", {{8.0, 8.0, 0.0}, Eigen::Quaterniond::Identity()}});
  tick(*simulation, 3);
  EXPECT_NEAR(metricOf(*simulation, "given"), 60.0, 1e-9) << "the other one's turn";
}

TEST(ChargingTest, APerchRunsEmptyAndRecovers) {
  const auto simulation =
      chargingWorld(perch("perch", 5, 5, "<capacity>100</capacity><level>0.2</level><supply>10</supply>"),
                    footbot("fb", 5.2, 5, 0), member("perch") + member("fb"), kStill,
                    "<first_level>0.5</first_level><still_power>0</still_power><power>60</power><ready>8</ready>");
  // +3 -18: 5 left; then +3, and 8 of 18 given: empty; +3, +3: 6, and with the next +3 it is ready again
  tick(*simulation, 4);
  EXPECT_NEAR(chargeOf(*simulation, "perch"), 5.0, 1e-9);
  EXPECT_EQ(colorOf(*simulation, "perch"), colors::kYellow);
  tick(*simulation, 3);
  EXPECT_EQ(chargeOf(*simulation, "perch"), 0.0);
  EXPECT_EQ(colorOf(*simulation, "perch"), colors::kRed);
  tick(*simulation, 6);
  EXPECT_NEAR(chargeOf(*simulation, "perch"), 6.0, 1e-9);
  EXPECT_EQ(colorOf(*simulation, "perch"), colors::kRed);
  EXPECT_NEAR(metricOf(*simulation, "given"), 26.0, 1e-9);
  tick(*simulation, 3);
  EXPECT_EQ(chargeOf(*simulation, "perch"), 0.0);
  EXPECT_NEAR(metricOf(*simulation, "given"), 35.0, 1e-9) << "9 at once";
}

TEST(ChargingTest, AnEmptyRobotIsCommandedByNobodyUntilItHasEnough) {
  // 2 rad/s of wheels of 0.029 m: 0.058 m/s; 2.9 J last for 4 ticks of at most 0.75 J
  const auto simulation = chargingWorld(perch("perch", 7, 5, ""), footbot("fb", 5, 5, 0),
                                        member("perch") + member("fb"), "<left>2</left><right>2</right>",
                                        "<capacity>2.9</capacity><moving_power>7.5</moving_power><enough>0.6</enough>"
                                        "<power>4</power>");
  tick(*simulation, 4);
  EXPECT_EQ(metricOf(*simulation, "ran_empty"), 1.0);
  EXPECT_EQ(metricOf(*simulation, "empty"), 1.0);
  EXPECT_NEAR(poseOf(*simulation, "fb").position.x(), 5.0 + 0.4 * 0.058, 1e-6);
  tick(*simulation, 1);
  const double stopped_at = poseOf(*simulation, "fb").position.x();
  tick(*simulation, 19);
  EXPECT_NEAR(poseOf(*simulation, "fb").position.x(), stopped_at, 1e-9);
  EXPECT_EQ(metricOf(*simulation, "mean_level"), 0.0) << "and it uses nothing";
  simulation->apply(MoveEntity{"fb", {{6.75, 5.2, 0.0}, Eigen::Quaterniond::Identity()}});
  // perch at (7, 5): 0.32 m, out of reach
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

/// Without ROS there are no topics, and the rule's wish says so.
TEST(ChargingTest, TheSourceIsWhoCommandsAgain) {
  // empty after its first tick; before the tick 3 the perch fills it
  const auto simulation =
      chargingWorld(perch("perch", 4.8, 5, ""), footbot("fb", 5, 5, 0), member("perch") + member("fb"),
                    "<left>2</left><right>2</right>",
                    "<capacity>2</capacity><first_level>0.01</first_level><enough>0.6</enough><source>topics</source>");
  tick(*simulation, 3);
  EXPECT_EQ(metricOf(*simulation, "empty"), 1.0);
  try {
    simulation->tick();
    ADD_FAILURE() << "it goes on";
  } catch (const std::exception& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("'fb' cannot be commanded by topics: nobody listens to topics here"), std::string::npos)
        << text;
  }
}

TEST(ChargingTest, WhoIsDeletedCountsNoMoreAndAResetStartsAnew) {
  const auto simulation =
      chargingWorld("", footbot("fb_1", 5, 5, 0) + footbot("fb_2", 6, 5, 0), member("fb_1") + member("fb_2"), kStill,
                    "<capacity>50</capacity><still_power>2</still_power><robot>fb_</robot>");
  tick(*simulation, 10);
  EXPECT_NEAR(metricOf(*simulation, "mean_level"), 48.0, 1e-9);
  simulation->apply(DeleteEntity{"fb_1"});
  tick(*simulation, 10);
  EXPECT_NEAR(metricOf(*simulation, "mean_level"), 46.0, 1e-9);
  EXPECT_NEAR(metricOf(*simulation, "drained"), 6.0, 1e-9);
  simulation->reset();
  EXPECT_EQ(metricOf(*simulation, "drained"), 0.0);
  tick(*simulation, 10);
  EXPECT_NEAR(metricOf(*simulation, "mean_level"), 48.0, 1e-9) << "both are there again, and full";
}

TEST(ChargingTest, ARobotThatIsEmptyIsStoppedWhoeverElseCommandsIt) {
  const auto simulation = chargingWorld("", footbot("fb", 5, 5, 0), member("fb"), "<left>2</left><right>2</right>",
                                        "<capacity>10</capacity><moving_power>10</moving_power>");
  tick(*simulation, 12);
  EXPECT_EQ(metricOf(*simulation, "empty"), 1.0);
  simulation->apply(SetCommandSource{"fb", CommandSource::kController});
  tick(*simulation, 3);
  const Eigen::Vector3d place = poseOf(*simulation, "fb").position;
  tick(*simulation, 20);
  EXPECT_NEAR((poseOf(*simulation, "fb").position - place).norm(), 0.0, 1e-9);
  EXPECT_NEAR(metricOf(*simulation, "drained"), 10.0, 1e-9);
}

// All bounds of the experiment, of whose 4 robots each has 1000 J at first.
constexpr double kLeastLevel = 300.0;  // J in the mean over the robots, at any time
constexpr double kMostRanEmpty = 1.0;  // robots in 600 s
constexpr double kUncaring = 4.0;      // robots that ran empty of those that look for no perch

/// @param endurance of the controller [s]
std::unique_ptr<Simulation> charging(std::uint64_t seed, const std::string& endurance = "50", int threads = 1) {
  loadBuiltInPlugins();
  std::ifstream file(findShared("swarmanoid_experiments", "experiments/charging.xml"));
  std::string text(std::istreambuf_iterator<char>(file), {});
  const std::string plain = "<endurance>50</endurance>";
  text.replace(text.find(plain), plain.size(), "<endurance>" + endurance + "</endurance>");
  Experiment experiment = parseExperiment(text, "charging.xml");
  experiment.framework.seed = seed;
  experiment.framework.threads = threads;
  auto simulation = std::make_unique<Simulation>(std::move(experiment));
  simulation->start();
  return simulation;
}

TEST(ChargingExperimentTest, RobotsKeepGoingAndNothingIsLost) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const auto simulation = charging(seed);
    while (!simulation->isFinished()) {
      simulation->tick();
      const double level = metricOf(*simulation, "mean_level");
      const double given = metricOf(*simulation, "given");
      ASSERT_GE(level, kLeastLevel) << "seed " << seed << ", tick " << simulation->space().tick;
      ASSERT_NEAR(4.0 * level, 4.0 * 1000.0 - metricOf(*simulation, "drained") + given, 1e-6);
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
    const auto simulation = charging(seed, "100000");
    while (!simulation->isFinished()) {
      simulation->tick();
    }
    EXPECT_GE(metricOf(*simulation, "ran_empty"), kUncaring) << "seed " << seed;
  }
}

TEST(ChargingExperimentTest, TheSameSeedGivesTheSameBits) {
  const auto expected = hashesOf(*charging(3), 1500);
  EXPECT_EQ(hashesOf(*charging(3, "50", 2), 1500), expected) << "on two threads";
  const auto used = charging(4);
  hashesOf(*used, 700);
  used->reset(3);
  EXPECT_EQ(hashesOf(*used, 1500), expected) << "after a reset";
}

}  // namespace
}  // namespace swarmanoid::test
