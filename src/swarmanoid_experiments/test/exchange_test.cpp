// The rule `exchange`: batteries are swapped while the super-capacitor powers the footbot, and energy is conserved. A
// footbot in these tests draws 3.74 W at rest, and 0.7733 W more at 2 rad/s.
#include <gtest/gtest.h>

#include "test_world.hpp"

namespace swarmanoid::test {
namespace {

constexpr double kStandby = 3.74;  // W
constexpr const char* kStill = "<left>0</left><right>0</right>";

struct ExchangeWorld {
  std::string robots;
  std::string station = "<batteries>3</batteries><capacity>200</capacity><supply>0</supply>";
  std::string rule;
  std::string drive = kStill;
  int threads = 1;
};

std::string powered(const std::string& id, double x, double level) {
  std::string text = footbot(id, x, 5, 0);
  return text.insert(text.find("</footbot>"),
                     "<battery>true</battery><battery_capacity>200</battery_capacity>"
                     "<battery_level>" +
                         numberText(level) + "</battery_level>");
}

std::unique_ptr<Simulation> started(const ExchangeWorld& what) {
  World world;
  world.entities = "<exchange_station id=\"station\"><position>5.26,5,0</position><orientation>0,0,0</orientation>" +
                   what.station + "</exchange_station>" + what.robots;
  world.members =
      member("station") + member("fb_1") + (what.robots.find("fb_2") == std::string::npos ? "" : member("fb_2"));
  world.drive = what.drive;
  world.framework = "<threads>" + std::to_string(what.threads) + "</threads>";
  world.rules = "<exchange id=\"exchange\">" + what.rule + "</exchange>";
  world.ticks = 10000;
  auto simulation = world.make();
  simulation->start();
  return simulation;
}

double of(const Simulation& simulation, const std::string& entity, const std::string& property) {
  return *simulation.space().property(simulation.space().entities.find(entity), property);
}

double metricOf(const Simulation& simulation, const std::string& name) {
  return std::get<double>(simulation.metrics().at("exchange." + name));
}

/// Energy in batteries and capacitors, plus the used and minus the supplied energy [J].
double balance(const Simulation& simulation) {
  const Space& space = simulation.space();
  double sum = metricOf(simulation, "drained") - metricOf(simulation, "supplied");
  for (const Row row : space.entities.order) {
    const EntityModel& model = *space.entities.model[row];
    for (std::size_t i = 0; i < model.properties.size(); ++i) {
      sum += model.properties[i].unit == "J" ? space.properties[row][i] : 0.0;
    }
  }
  return sum;
}

TEST(ExchangeTest, SwapsABatteryWhileTheCapacitorKeepsTheRobotAlive) {
  const auto simulation = started({powered("fb_1", 5.0, 0.4),
                                   "<batteries>3</batteries><capacity>200</capacity>"
                                   "<supply>0</supply>",
                                   "<swap_time>7.3</swap_time>", "<left>0</left><right>2</right>", 1});
  tick(*simulation, 1);
  EXPECT_EQ(of(*simulation, "fb_1", "charge"), 0.0) << "its battery is out";
  EXPECT_EQ(of(*simulation, "station", "battery_1"), 80.0) << "and where the new one was";
  EXPECT_EQ(of(*simulation, "station", "arm"), 200.0);
  EXPECT_EQ(metricOf(*simulation, "swapping"), 1.0);
  tick(*simulation, 72);
  EXPECT_EQ(of(*simulation, "fb_1", "charge"), 0.0);
  EXPECT_NEAR(of(*simulation, "fb_1", "capacitor"), 60.0 - 7.3 * kStandby, 1e-9)
      << "wheels are off from the first tick";
  EXPECT_NEAR(headingOf(*simulation, "fb_1"), 0.0, 1e-9);
  EXPECT_EQ(metricOf(*simulation, "swaps"), 0.0);
  tick(*simulation, 1);
  EXPECT_EQ(metricOf(*simulation, "swaps"), 1.0);
  EXPECT_EQ(of(*simulation, "station", "arm"), 0.0);
  EXPECT_NEAR(of(*simulation, "fb_1", "charge"), 200.0 - 0.1 * (kStandby + 4.0 * 0.029 / 0.3) - 0.1, 1e-9)
      << "a tick has passed, and the capacitor has got 0.1 J";
  EXPECT_EQ(metricOf(*simulation, "ran_empty"), 0.0);
  tick(*simulation, 5);
  EXPECT_GT(headingOf(*simulation, "fb_1"), 0.01) << "its wheels are on again";
}

TEST(ExchangeTest, NothingIsLost) {
  const auto simulation =
      started({powered("fb_1", 5.0, 0.4) + powered("fb_2", 5.52, 0.3),
               "<batteries>2</batteries><capacity>200</capacity><level>0.97</level><supply>31</supply>",
               "<swap_time>2.1</swap_time><interval>0.7</interval>", kStill, 1});
  const double before = balance(*simulation);
  EXPECT_NEAR(before, 80.0 + 60.0 + 2.0 * 60.0 + 2.0 * 194.0, 1e-9);
  for (int i = 0; i < 3000; ++i) {
    simulation->tick();
    ASSERT_NEAR(balance(*simulation), before, 1e-6) << "tick " << i;
  }
  EXPECT_GT(metricOf(*simulation, "swaps"), 10.0);
  EXPECT_GT(metricOf(*simulation, "supplied"), 1000.0);
  EXPECT_EQ(metricOf(*simulation, "ran_empty"), 0.0);
}

TEST(ExchangeTest, WaitsForABatteryThatIsChargedEnough) {
  const auto simulation = started({powered("fb_1", 5.0, 0.4),
                                   "<batteries>1</batteries><capacity>200</capacity>"
                                   "<level>0.9</level><supply>5</supply>",
                                   "<interval>0.4</interval>", kStill, 1});
  tick(*simulation, 20);
  EXPECT_EQ(metricOf(*simulation, "swapping"), 0.0);
  // 180 J plus 2 J per 0.4 s: 190 J, 0.95 of 200, after five times
  tick(*simulation, 2);
  EXPECT_EQ(metricOf(*simulation, "swapping"), 1.0);
}

TEST(ExchangeTest, TheStationChargesTheFullestFirst) {
  const auto simulation = started({powered("fb_1", 8.0, 1.0),
                                   "<batteries>3</batteries><capacity>200</capacity>"
                                   "<level>0.5</level><supply>100</supply>",
                                   "<interval>0.3</interval>", kStill, 1});
  simulation->apply(SetProperty{"station", "battery_2", "185"});
  simulation->apply(SetProperty{"station", "battery_3", "120"});
  tick(*simulation, 4);  // 30 J before tick 3
  EXPECT_NEAR(of(*simulation, "station", "battery_2"), 200.0, 1e-9);
  EXPECT_NEAR(of(*simulation, "station", "battery_3"), 135.0, 1e-9);
  EXPECT_EQ(of(*simulation, "station", "battery_1"), 100.0);
}

TEST(ExchangeTest, ARobotThatWaitsTooLongIsOffAndGoesOnWithTheNewBattery) {
  const auto simulation =
      started({powered("fb_1", 5.0, 0.4), "<batteries>1</batteries><capacity>200</capacity><supply>0</supply>",
               "<swap_time>20</swap_time>", kStill, 1});
  tick(*simulation, 160);
  EXPECT_EQ(metricOf(*simulation, "ran_empty"), 0.0);
  tick(*simulation, 1);
  EXPECT_EQ(metricOf(*simulation, "ran_empty"), 1.0) << "60 J last for 16.04 s";
  tick(*simulation, 40);
  EXPECT_EQ(metricOf(*simulation, "empty"), 0.0);
  EXPECT_EQ(metricOf(*simulation, "swaps"), 1.0);
}

TEST(ExchangeTest, TheBatteryOfARobotThatIsDeletedGoesBack) {
  const auto simulation = started({powered("fb_1", 5.0, 0.4),
                                   "<batteries>1</batteries><capacity>200</capacity>"
                                   "<supply>0</supply>",
                                   "", kStill, 1});
  tick(*simulation, 5);
  EXPECT_EQ(of(*simulation, "station", "arm"), 200.0);
  simulation->apply(DeleteEntity{"fb_1"});
  tick(*simulation, 1);
  EXPECT_EQ(of(*simulation, "station", "arm"), 0.0);
  EXPECT_EQ(of(*simulation, "station", "battery_1"), 200.0);
}

TEST(ExchangeTest, ARobotThatIsDraggedOffBlocksTheStationUntilItIsBack) {
  const auto simulation = started({powered("fb_1", 5.0, 0.4) + powered("fb_2", 5.52, 0.6), ExchangeWorld{}.station,
                                   "<swap_time>1.1</swap_time>", kStill, 1});
  tick(*simulation, 5);  // 0.4 s of the swap
  simulation->apply(MoveEntity{"fb_1", {{8.0, 5.0, 0.0}, Eigen::Quaterniond::Identity()}});
  simulation->apply(SetProperty{"fb_2", "charge", "30"});
  tick(*simulation, 40);
  EXPECT_EQ(metricOf(*simulation, "swaps"), 0.0);
  EXPECT_EQ(metricOf(*simulation, "swapping"), 1.0);
  EXPECT_EQ(of(*simulation, "station", "arm"), 200.0);
  EXPECT_EQ(of(*simulation, "station", "battery_1"), 80.0);
  EXPECT_EQ(of(*simulation, "fb_1", "charge"), 0.0);
  EXPECT_NEAR(of(*simulation, "fb_1", "capacitor"), 60.0 - 4.5 * kStandby, 1e-9);
  EXPECT_NEAR(of(*simulation, "fb_2", "charge"), 30.0 - 4.0 * kStandby, 1e-9) << "it has to wait";
  simulation->apply(MoveEntity{"fb_1", {{5.03, 4.98, 0.0}, Eigen::Quaterniond::Identity()}});
  tick(*simulation, 6);
  EXPECT_EQ(metricOf(*simulation, "swaps"), 0.0) << "1 s of the swap";
  tick(*simulation, 1);
  EXPECT_EQ(metricOf(*simulation, "swaps"), 1.0);
  EXPECT_NEAR(of(*simulation, "fb_1", "charge"), 200.0 - 0.1 * kStandby - 0.1, 1e-9);
  tick(*simulation, 1);
  EXPECT_EQ(of(*simulation, "fb_2", "charge"), 0.0) << "its turn";
}

TEST(ExchangeTest, ARobotTakesNoMoreThanItsCapacity) {
  const auto simulation = started({powered("fb_1", 5.0, 0.4),
                                   "<batteries>1</batteries><capacity>300</capacity><level>0.6</level>"
                                   "<supply>0</supply>",
                                   "<ready>0.85</ready><swap_time>0.5</swap_time>", kStill, 1});
  tick(*simulation, 1);
  EXPECT_EQ(of(*simulation, "station", "arm"), 180.0);
  simulation->apply(SetProperty{"station", "arm", "240"});
  tick(*simulation, 5);
  EXPECT_EQ(metricOf(*simulation, "swaps"), 1.0);
  EXPECT_NEAR(of(*simulation, "fb_1", "charge"), 200.0, 2.0);
  EXPECT_EQ(of(*simulation, "station", "battery_1"), 80.0 + 40.0);
}

TEST(ExchangeTest, AStationWhoseArmHoldsABatteryStartsNoSwap) {
  const auto simulation = started({powered("fb_1", 8.0, 0.4), ExchangeWorld{}.station, "", kStill, 1});
  simulation->apply(SetProperty{"station", "arm", "70"});
  simulation->apply(MoveEntity{"fb_1", {{5.0, 5.0, 0.0}, Eigen::Quaterniond::Identity()}});
  tick(*simulation, 5);
  EXPECT_EQ(metricOf(*simulation, "swapping"), 0.0);
  EXPECT_EQ(of(*simulation, "station", "arm"), 70.0);
}

TEST(ExchangeTest, ItLeavesAloneWhoIsFarAwayOrHasEnough) {
  const auto simulation =
      started({powered("fb_1", 4.95, 0.4) + powered("fb_2", 5.52, 0.6), ExchangeWorld{}.station, "", kStill, 1});
  tick(*simulation, 10);
  EXPECT_EQ(metricOf(*simulation, "swapping"), 0.0) << "0.31 m away; 0.6 of its capacity";
}

TEST(ExchangeTest, TheSameBitsAfterAResetAndOnTwoThreads) {
  ExchangeWorld world{powered("fb_1", 5.0, 0.4) + powered("fb_2", 5.52, 0.3), ExchangeWorld{}.station,
                      "<swap_time>3</swap_time>", kStill, 1};
  const auto used = started(world);
  const auto expected = hashesOf(*used, 120);
  used->reset();
  EXPECT_EQ(hashesOf(*used, 120), expected);
  world.threads = 2;
  EXPECT_EQ(hashesOf(*started(world), 120), expected);
}

}  // namespace
}  // namespace swarmanoid::test
