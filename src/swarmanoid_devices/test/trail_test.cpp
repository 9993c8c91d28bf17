// The rules `trail` and `trips`, without engines: painting of the floor by robots, and trips of robots between patches.
#include <gtest/gtest.h>

#include <string>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid::test {
namespace {

std::string trailFootbot(const std::string& id, double x, double y) {
  return "<footbot id=\"" + id + "\"><position>" + numberText(x) + "," + numberText(y) +
         ",0</position><orientation>0,0,0</orientation></footbot>";
}

/// Cells of 0.1 m, without fading; a nest around (1, 1) and food around (4, 4), each a disc of 0.4 m.
std::unique_ptr<Simulation> make(const std::string& rules, const std::string& arena =
                                                               "<floor_paint><cell>0.1</cell>"
                                                               "</floor_paint>") {
  loadPluginLibrary("swarmanoid_devices", {}, {});
  auto simulation =
      std::make_unique<Simulation>(parseExperiment(R"(<ahss-config>
  <framework><clocktick>100</clocktick><maxclock>1000</maxclock></framework>
  <arena size="5,5,3" optimization="2D">)" + arena + R"(
    <floor_patch id="nest"><position>1, 1, 0</position><radius>0.4</radius></floor_patch>
    <floor_patch id="food"><position>4, 4, 0</position><radius>0.4</radius></floor_patch>)" +
                                                       trailFootbot("fb_1", 2.03, 3.06) + trailFootbot("fb_2", 3, 3) +
                                                       trailFootbot("other", 2, 1) + R"(
  </arena>
  <rules>)" + rules + "</rules></ahss-config>",
                                                   "trail.xml"));
  return simulation;
}

std::string refusalOfRules(const std::string& rules, const std::string& arena = "") {
  try {
    make(rules, arena);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

double metricOf(const Simulation& simulation, const std::string& name) {
  return std::get<double>(simulation.metrics().at(name));
}

void put(Simulation& simulation, const std::string& entity, double x, double y) {
  simulation.apply(MoveEntity{entity, {{x, y, 0.0}, Eigen::Quaterniond::Identity()}});
  simulation.tick();
}

constexpr const char* kTrail =
    "<trail id='t'><led_color>red</led_color><color>blue</color><strength>0.25</strength><radius>0.06</radius>"
    "<every>3</every></trail>";

/// No controller commands LEDs here: the test sets their colours in the space, as an actuator would.
class TrailTest : public testing::Test {
 protected:
  TrailTest() { simulation->start(); }

  void light(const std::string& robot, std::size_t led, Color color) {
    Space& space = const_cast<Space&>(simulation->space());
    space.leds[space.entities.find(robot)][led] = color;
  }
  const PaintLayer& paint() const { return simulation->space().floor.paint; }

  const std::unique_ptr<Simulation> simulation = make(kTrail);
};

TEST_F(TrailTest, IsPaintedUnderThoseThatShowTheColour) {
  light("fb_1", 5, colors::kRed);
  light("other", 0, {254, 0, 0});
  simulation->tick();
  simulation->tick();
  EXPECT_EQ(paint().spotCount(), 0U) << "every third tick";
  simulation->tick();
  EXPECT_EQ(metricOf(*simulation, "t.painting"), 1.0);
  EXPECT_EQ(paint().spotCount(), 0U) << "asked for after the tick, done before the next one";
  simulation->tick();
  ASSERT_EQ(paint().spotCount(), 1U) << "the middle (2.05, 3.05) is 0.022 m away, the next one 0.081 m";
  EXPECT_NEAR((paint().spot(0, 0).position - Eigen::Vector2d(2.05, 3.05)).norm(), 0.0, 1e-9);
  EXPECT_EQ(paint().spot(0, 0).color, colors::kBlue);
  EXPECT_NEAR(paint().spot(0, 0).strength, 0.25, 1e-9);
  ASSERT_EQ(simulation->space().interventions.size(), 1U);
  EXPECT_EQ(simulation->space().interventions[0].asked_by, "rule 't' (trail)");
  for (int i = 0; i < 3; ++i) {
    simulation->tick();
  }
  EXPECT_NEAR(paint().spot(0, 0).strength, 0.4375, 1e-7) << "0.25 over 0.25";
  light("fb_1", 5, colors::kBlack);
  for (int i = 0; i < 3; ++i) {
    simulation->tick();
  }
  EXPECT_EQ(metricOf(*simulation, "t.painting"), 0.0);
}

TEST_F(TrailTest, OneInterventionPaintsForAll) {
  light("fb_1", 0, colors::kRed);
  light("fb_2", 11, colors::kRed);
  for (int i = 0; i < 4; ++i) {
    simulation->tick();
  }
  EXPECT_EQ(metricOf(*simulation, "t.painting"), 2.0);
  ASSERT_EQ(simulation->space().interventions.size(), 1U);
  EXPECT_EQ(std::get<PaintFloor>(simulation->space().interventions[0].what).discs.size(), 2U);
  EXPECT_GT(paint().spotCount(), 1U);
}

TEST_F(TrailTest, RobotsOutsideTheArenaLayNone) {
  Space& space = const_cast<Space&>(simulation->space());
  space.entities.pose[space.entities.find("fb_1")].position = {5.01, 1.5, 0.0};
  space.entities.pose[space.entities.find("fb_2")].position.x() = 5.0;
  light("fb_1", 0, colors::kRed);
  light("fb_2", 0, colors::kRed);
  for (int i = 0; i < 4; ++i) {
    simulation->tick();
  }
  EXPECT_EQ(metricOf(*simulation, "t.painting"), 1.0) << "the one on the border";
  ASSERT_EQ(paint().spotCount(), 1U);
  EXPECT_NEAR(paint().spot(0, 0).position.y(), 3.0, 0.06) << "the other one is at 1.5";
}

TEST(TrailRuleTest, NeedsAFloorThatTakesPaint) {
  EXPECT_EQ(
      refusalOfRules(kTrail).rfind("trail.xml:7: found the rule 'trail', allowed: in an arena with <floor_paint>", 0),
      0U)
      << refusalOfRules(kTrail);
}

constexpr const char* kTrips = "<trips id='t'><robots>fb_</robots></trips>";

TEST(TripsTest, CountsArrivalsOnTheOtherPatch) {
  const auto simulation = make(kTrips);
  simulation->start();
  put(*simulation, "fb_1", 1.2, 1.3);
  EXPECT_EQ(metricOf(*simulation, "t.trips"), 0.0) << "it came from nowhere";
  put(*simulation, "fb_1", 2.0, 2.0);
  put(*simulation, "fb_1", 0.8, 1.0);
  EXPECT_EQ(metricOf(*simulation, "t.trips"), 0.0) << "back on the patch it came from";
  put(*simulation, "fb_1", 4.1, 4.3);
  put(*simulation, "fb_1", 4.0, 4.0);
  EXPECT_EQ(metricOf(*simulation, "t.trips"), 1.0);
  put(*simulation, "fb_2", 1.0, 1.0);
  put(*simulation, "fb_1", 3.0, 2.0);
  put(*simulation, "fb_1", 1.0, 1.39);
  EXPECT_EQ(metricOf(*simulation, "t.trips"), 2.0) << "and back";
  put(*simulation, "fb_2", 4.0, 3.7);
  EXPECT_EQ(metricOf(*simulation, "t.trips"), 3.0) << "another one";
  put(*simulation, "other", 4.2, 4.2);
  put(*simulation, "other", 1.2, 0.8);
  EXPECT_EQ(metricOf(*simulation, "t.trips"), 3.0) << "one that does not count";
  EXPECT_EQ(simulation->space().tick, 11U);
  EXPECT_NEAR(metricOf(*simulation, "t.trips_per_minute"), 3.0 * 60.0 / 1.1, 1e-9);
  simulation->reset();
  EXPECT_EQ(metricOf(*simulation, "t.trips"), 0.0);
  put(*simulation, "fb_1", 4.0, 4.0);
  EXPECT_EQ(metricOf(*simulation, "t.trips"), 0.0) << "where it was before the reset is forgotten";
}

TEST(TripsTest, ThatOnTheBorderOfAPatchIsOnIt) {
  const auto simulation = make(kTrips);
  simulation->start();
  put(*simulation, "fb_1", 0.6, 1.0);
  put(*simulation, "fb_1", 3.59, 4.0);
  EXPECT_EQ(metricOf(*simulation, "t.trips"), 0.0) << "1 cm beside it";
  put(*simulation, "fb_1", 3.6, 4.0);
  EXPECT_EQ(metricOf(*simulation, "t.trips"), 1.0);
}

TEST(TripsTest, EndsTheRunWithSuccessWhenThereAreEnough) {
  const auto simulation = make("<trips id='t'><enough>1</enough></trips>");
  simulation->start();
  put(*simulation, "other", 1.0, 1.0);
  EXPECT_FALSE(simulation->isFinished());
  EXPECT_EQ(simulation->success(), false);
  put(*simulation, "other", 4.0, 4.0);
  EXPECT_TRUE(simulation->isFinished());
  EXPECT_EQ(simulation->success(), true);
}

TEST(TripsTest, PatchesMustBeThereAndTwo) {
  EXPECT_EQ(refusalOfRules("<trips id='t'><to>nest</to></trips>"),
            "trail.xml:7: to: found 'nest', which is from too, allowed: another floor patch");
  EXPECT_EQ(refusalOfRules("<trips id='t'><to>fod</to></trips>"),
            "trail.xml:7: to: found 'fod', allowed: the id of a floor patch (nest, food); did you mean 'food'?");
  EXPECT_EQ(refusalOfRules("<trips id='t'><to>food, nest</to></trips>"),
            "trail.xml:7: to: found 'nest', which is from too, allowed: another floor patch");
  EXPECT_EQ(refusalOfRules("<trips id='t'><to>food,</to></trips>"),
            "trail.xml:7: to: found '', allowed: the id of a floor patch (nest, food)");
  EXPECT_EQ(refusalOfRules("<trips id='t'><from></from></trips>"),
            "trail.xml:7: from: found '', allowed: the id of a floor patch (nest, food)");
}

TEST(TripsTest, ASideMayBeSeveralPatchesAndReturnsAreToTheFirstSide) {
  const auto simulation =
      make("<trips id='t'><robots>fb_</robots><to>food, berries</to></trips>",
           "<floor_patch id='berries'><position>1, 4, 0</position><radius>0.4</radius></floor_patch>");
  simulation->start();
  const auto expect = [&](double trips, double returns, const char* why) {
    EXPECT_EQ(metricOf(*simulation, "t.trips"), trips) << why;
    EXPECT_EQ(metricOf(*simulation, "t.returns"), returns) << why;
  };
  put(*simulation, "fb_1", 4.0, 4.0);
  put(*simulation, "fb_1", 1.0, 4.0);
  expect(0.0, 0.0, "from one of the same side to the other");
  put(*simulation, "fb_1", 1.0, 1.0);
  expect(1.0, 1.0, "home from the berries, whatever came first");
  put(*simulation, "fb_1", 4.0, 4.0);
  expect(2.0, 1.0, "out again");
  put(*simulation, "fb_1", 1.0, 1.0);
  expect(3.0, 2.0, "home from the food");
}

}  // namespace
}  // namespace swarmanoid::test
