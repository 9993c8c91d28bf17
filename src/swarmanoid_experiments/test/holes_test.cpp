// Entities without ground below fall, in the tick computed by geometry, in every engine; connected bodies support each
// other.
#include <gtest/gtest.h>

#include <cmath>

#include "handover_world.hpp"
#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/devices/eyebot_velocity.hpp"
#include "swarmanoid_interface/testing/count_allocations.hpp"

REGISTER_ENGINE(swarmanoid::test::GlideEngine)

namespace swarmanoid::test {
namespace {

constexpr double kWheelRadius = 0.029;  // of a footbot, m
constexpr double kDegree = M_PI / 180.0;

/// Parameters of "drive" for straight motion by that distance in each tick [m].
std::string ahead(double way, const std::string& more = "") {
  const std::string speed = numberText(way / 0.1 / kWheelRadius);
  return "<left>" + speed + "</left><right>" + speed + "</right>" + more;
}

std::string disc(const std::string& id, const Eigen::Vector2d& middle, double radius) {
  return "<hole id=\"" + id + "\"><position>" + numberText(middle.x()) + "," + numberText(middle.y()) +
         ",0</position><radius>" + numberText(radius) + "</radius></hole>";
}

std::string rectangle(const std::string& id, const Eigen::Vector2d& middle, const Eigen::Vector2d& size) {
  return "<hole id=\"" + id + "\"><position>" + numberText(middle.x()) + "," + numberText(middle.y()) +
         ",0</position><size>" + numberText(size.x()) + "," + numberText(size.y()) + "</size></hole>";
}

std::unique_ptr<Simulation> startedIn(const World& world, const std::string& engine) {
  std::string xml = world.xml();
  const std::string usual = "<kinematics2d id=\"ground\"></kinematics2d>";
  xml.replace(xml.find(usual), usual.size(), "<" + engine + " id=\"ground\"/>");
  loadBuiltInPlugins();
  auto simulation = std::make_unique<Simulation>(parseExperiment(xml, "test.xml"));
  simulation->start();
  return simulation;
}

bool isThere(const Simulation& simulation, const std::string& name) {
  return simulation.space().entities.find(name) != kNoRow;
}

/// The falls of a number of ticks, each with its tick.
std::string falls(Simulation& simulation, int ticks) {
  std::string text;
  for (int i = 0; i < ticks; ++i) {
    simulation.tick();
    for (const Event& event : simulation.space().events) {
      if (event.kind == Event::Kind::kFellIntoHole) {
        text += std::to_string(simulation.space().tick) + " " + event.entity + " " + event.text + "; ";
      }
    }
  }
  return text;
}

/// "fb" starts at (1.3, 2.1) and drives by `step` per tick, at 37.3 degrees from x, towards a disc of 0.21 m with its
/// centre 0.731 m ahead and 0.05 m to the side.
World towardsADisc(double step) {
  const double heading = 37.3 * kDegree;
  const Eigen::Vector2d along(std::cos(heading), std::sin(heading));
  const Eigen::Vector2d aside(-along.y(), along.x());
  World world;
  world.entities =
      footbot("fb", 1.3, 2.1, 37.3) + disc("pit", Eigen::Vector2d(1.3, 2.1) + 0.731 * along + 0.05 * aside, 0.21);
  world.members = member("fb");
  world.drive = ahead(step);
  return world;
}

constexpr double kWayToTheDisc = 0.527039;  // 0.731 - sqrt(0.21^2 - 0.05^2), m

TEST(HolesTest, ARobotFallsInTheTickInWhichItsMiddleIsOverTheHole) {
  for (const auto& [step, tick] : {std::pair(0.0123830, 43), std::pair(0.02, 27), std::pair(0.0071, 75)}) {
    ASSERT_EQ(std::ceil(kWayToTheDisc / step), tick) << "the test's own numbers";
    const auto simulation = started(towardsADisc(step));
    EXPECT_EQ(falls(*simulation, 90), std::to_string(tick) + " fb hole 'pit'; ");
    EXPECT_FALSE(isThere(*simulation, "fb"));
    EXPECT_EQ(simulation->robotCount(), 0U);
  }
}

TEST(HolesTest, WhatAControllerFailsInWhenItsRobotFallsIsAnEventOfThatTick) {
  World world = towardsADisc(0.02);
  world.drive += "<throws_when_it_goes>true</throws_when_it_goes>";
  world.ticks = 27;  // the last tick
  const auto simulation = started(world);
  tick(*simulation, 27);
  const std::string events = eventsIn(*simulation);
  const auto fallen = events.find(std::string(toString(Event::Kind::kFellIntoHole)) + " fb hole 'pit'; ");
  const auto failed =
      events.find(std::string(toString(Event::Kind::kControllerFailed)) + " fb destroy: told to, at the end; ");
  EXPECT_NE(fallen, std::string::npos) << events;
  EXPECT_NE(failed, std::string::npos) << events;
  EXPECT_LT(fallen, failed);
}

TEST(HolesTest, ARobotThatPassesAsideDoesNotFall) {
  World world = towardsADisc(0.02);
  world.entities = footbot("fb", 1.0, 2.0, 0.0) + disc("pit", {2.0, 2.211}, 0.21);
  EXPECT_EQ(falls(*started(world), 90), "") << "its left wheel crosses the hole, its middle passes 1 mm beside it";
  world.entities = footbot("fb", 1.0, 2.0, 0.0) + disc("pit", {2.0, 2.209}, 0.21);
  EXPECT_NE(falls(*started(world), 90), "");
}

class HolesInEngineTest : public testing::TestWithParam<const char*> {};

/// Engines with forces need time to accelerate: the place of the fall is known, but not the tick.
TEST_P(HolesInEngineTest, TheEventIsTheSameInEveryEngine) {
  const auto simulation = startedIn(towardsADisc(0.02), GetParam());
  const Eigen::Vector2d from = poseOf(*simulation, "fb").position.head<2>();
  double way = 0.0;
  std::string fall;
  while (fall.empty() && simulation->space().tick < 60) {
    way = (poseOf(*simulation, "fb").position.head<2>() - from).norm();
    fall = falls(*simulation, 1);
  }
  EXPECT_EQ(fall, std::to_string(simulation->space().tick) + " fb hole 'pit'; ");
  EXPECT_LT(way, kWayToTheDisc + 1e-3);
  EXPECT_GT(way, kWayToTheDisc - 0.021) << "it drove to its edge";
  EXPECT_EQ(falls(*simulation, 20), "") << "once";
  simulation->reset();
  ASSERT_TRUE(isThere(*simulation, "fb"));
  EXPECT_LT((poseOf(*simulation, "fb").position.head<2>() - from).norm(), 1e-9);
}

TEST_P(HolesInEngineTest, WhatStandsOverAHoleFallsAtOnceAndWhatIsFixedStays) {
  World world;
  world.entities = prey("prey", 3.0, 3.02) +
                   "<block id=\"wall\"><position>3.2, 3, 0.1</position><orientation>0,0,0</orientation>"
                   "<size>0.1, 0.1, 0.2</size></block><block id=\"crate\"><position>2.8, 3, 0.1</position>"
                   "<orientation>0,0,20</orientation><size>0.1,0.1,0.2</size><mass>1</mass></block>" +
                   disc("pit", {3.0, 3.0}, 0.4);
  world.members = member("prey") + member("wall") + member("crate");
  const auto simulation = startedIn(world, GetParam());
  EXPECT_EQ(falls(*simulation, 5), "1 prey hole 'pit'; 1 crate hole 'pit'; ");
  EXPECT_TRUE(isThere(*simulation, "wall"));
}

INSTANTIATE_TEST_SUITE_P(Engines, HolesInEngineTest, testing::Values("kinematics2d", "dynamics2d", "dynamics3d"));

TEST(HolesTest, ARobotFallsWhenBothWheelsHaveLostTheGround) {
  World world;
  world.members = member("fb");
  world.drive = ahead(0.013);
  // slits below the wheels, 0.07 m to the sides of the centre
  const std::string left = rectangle("left", {3.0, 2.07}, {2.0, 0.02});
  const std::string right = rectangle("right", {3.1, 1.93}, {2.0, 0.02});
  world.entities = footbot("fb", 1.5, 2.0, 0.0) + left;
  EXPECT_EQ(falls(*started(world), 90), "");
  world.entities = footbot("fb", 1.5, 2.0, 0.0) + right;
  EXPECT_EQ(falls(*started(world), 90), "");
  world.entities = footbot("fb", 1.5, 2.0, 0.0) + left + right;
  // the right one begins at 2.1: 0.6 m from the start, 46.15 ticks
  EXPECT_EQ(falls(*started(world), 90), "47 fb hole 'left'; ");
}

TEST(HolesTest, WhatNoEngineMovesStays) {
  World world;
  world.entities = footbot("fb", 1.0, 1.0, 0.0) + prey("prey", 3.0, 3.0) + disc("pit", {3.0, 3.0}, 0.4);
  world.members = member("fb");
  const auto simulation = started(world);
  EXPECT_EQ(falls(*simulation, 3), "");
}

TEST(HolesTest, WhatAnEngineMovesAboveTheFloorStays) {
  World world;
  world.entities = footbot("fb", 3.0, 3.0, 0.0) + prey("prey", 1.0, 1.0) + disc("pit", {3.0, 3.0}, 0.4);
  world.entities.replace(world.entities.find(",0</position>"), 2, ",1");
  world.members = member("prey");
  world.engines = "<kinematics2d id=\"shelf\"><distance>1</distance></kinematics2d>";
  world.physics = "<engine id=\"shelf\"><entity id=\"fb\"/></engine>";
  EXPECT_EQ(falls(*started(world), 3), "");
}

class Hover final : public Controller {
 public:
  void init(Robot& robot, const Configuration&) override { robot.actuator<EyebotVelocity>(); }
  void step(Time, Duration) override {}
};

TEST(HolesTest, WhoFliesDoesNotFall) {
  World world;
  world.entities =
      "<eyebot id=\"eb\"><position>3,3,0</position><orientation>0,0,0</orientation><controller>hover"
      "</controller></eyebot>" +
      disc("pit", {3.0, 3.0}, 0.4);
  world.members = member("eb");
  std::string xml = world.xml();
  xml.insert(xml.find("</controllers>"),
             "<hover id=\"hover\" library=\"swarmanoid_devices\"><actuators><eyebot_velocity/></actuators></hover>");
  loadBuiltInPlugins();
  Simulation simulation(parseExperiment(xml, "test.xml"));
  simulation.start();
  EXPECT_EQ(falls(simulation, 3), "");
}

/// "fb" grips "prey", 0.171 m ahead of it, in its first tick, and drives by 1 cm per tick to a ditch that begins 0.3 m
/// ahead.
World pushers(const std::string& mass, const std::string& more = "") {
  World world = carrierWorld();
  std::string load = prey("prey", 5, 5.171);
  load.insert(load.find("</cylindric_prey>"), "<mass>" + mass + "</mass>");
  world.entities = footbot("fb", 5, 5, 90) + load + rectangle("ditch", {5.0, 6.3003}, {4.0, 2.0});
  world.drive = ahead(0.01, "<close_at>0</close_at>" + more);
  return world;
}

TEST(HolesTest, ARobotHoldsALightThingOverAHoleAndFallsWithIt) {
  // a footbot weighs 1.8 kg; the prey, held since the end of tick 1, is over the ditch from tick 14 on, the footbot
  // from tick 31 on
  EXPECT_EQ(falls(*started(pushers("0.3")), 60), "31 fb hole 'ditch'; 31 prey hole 'ditch'; ");
  EXPECT_EQ(falls(*started(pushers("1.79")), 60), "31 fb hole 'ditch'; 31 prey hole 'ditch'; ");
}

TEST(HolesTest, AHeavyThingDrawsTheRobotThatHoldsIt) {
  EXPECT_EQ(falls(*started(pushers("1.81")), 60), "14 fb hole 'ditch', drawn by 'prey'; 14 prey hole 'ditch'; ");
}

TEST(HolesTest, WhatIsLetGoOverAHoleFalls) {
  EXPECT_EQ(falls(*started(pushers("0.3", "<open_at>20</open_at>")), 25), "21 prey hole 'ditch'; ");
}

/// Forty robots, placed and driven at random, among three holes.
World dangerousWorld(int threads) {
  World world;
  world.size = "6,6,2";
  world.bounded = true;
  world.ticks = 300;
  world.framework = "<threads>" + std::to_string(threads) + "</threads><random_seed>11</random_seed>";
  world.entities =
      "<distribute quantity=\"40\" layout=\"uniform\"><minimum>0.3,0.3,0</minimum><maximum>5.7,5.7,0</maximum><footbot "
      "id=\"fb\"><controller>drive</controller></footbot></distribute>" +
      disc("a", {1.7, 2.3}, 0.31) + disc("b", {4.1, 3.9}, 0.27) + rectangle("c", {3.3, 1.1}, {0.9, 0.2});
  world.members = member("fb");
  world.drive = "<left>0</left><right>0</right><random>true</random>";
  return world;
}

TEST(HolesTest, WhoFallsDoesNotDependOnThreadsAndFallsAgainAfterAReset) {
  const auto alone = started(dangerousWorld(1));
  const auto expected = hashesOf(*alone, 200);
  EXPECT_LT(alone->robotCount(), 38U);
  EXPECT_GT(alone->robotCount(), 5U);
  EXPECT_EQ(hashesOf(*started(dangerousWorld(2)), 200), expected);
  alone->reset();
  EXPECT_EQ(alone->robotCount(), 40U);
  EXPECT_EQ(hashesOf(*alone, 200), expected);
}

TEST(HolesTest, WhoHasFallenIsUnknownAndItsNameIsFree) {
  const auto simulation = started(towardsADisc(0.02));
  falls(*simulation, 30);
  for (const Intervention& intervention :
       {Intervention(DeleteEntity{"fb"}), Intervention(HandOverEntity{"fb", "ground"}),
        Intervention(MoveEntity{"fb", {{5, 5, 0}, Eigen::Quaterniond::Identity()}}),
        Intervention(SetCommandSource{"fb", CommandSource::kNone})}) {
    EXPECT_THROW(simulation->apply(intervention), ConfigError);
  }
  EntityDescription entity;
  entity.type = "footbot";
  entity.id = "fb";
  entity.position = {5, 5, 0};
  entity.controller = "drive";
  simulation->apply(SpawnEntity{entity, {"ground"}});
  tick(*simulation, 10);
  EXPECT_NEAR(poseOf(*simulation, "fb").position.x(), 5.2, 1e-9);
}

TEST(HolesTest, ARuleForHandoverForgetsWhoHasFallen) {
  World world = towardsADisc(0.02);
  world.entities += disc("edge", {3.0, 3.0}, 0.001);
  world.engines = "<kinematics2d id=\"twin\"/>";
  // it would enter the box in the tick of its fall, at 1.7295, 2.4272
  world.physics =
      "<handover entity=\"fb\" to=\"twin\"><inside><minimum>1.72,0,0</minimum><maximum>3,3,1</maximum></inside>"
      "</handover><handover entity=\"fb\" to=\"ground\"><inside><minimum>1.74,0,0</minimum><maximum>3,3,1</maximum>"
      "</inside></handover>";
  const auto simulation = started(world);
  tick(*simulation, 26);
  EXPECT_EQ(moverOf(*simulation, "fb"), "ground");
  simulation->tick();
  EXPECT_EQ(eventsIn(*simulation), "handed_over fb from ground to twin; fell_into_hole fb hole 'pit'; ");
  tick(*simulation, 10);
  EXPECT_EQ(eventsIn(*simulation), "");
}

TEST(HolesTest, WhoIsPutOntoAHoleFallsInTheNextTick) {
  World world = towardsADisc(0.0);
  world.entities += footbot("other", 6.0, 6.0, 0.0);
  world.members += member("other");
  const auto simulation = started(world);
  tick(*simulation, 3);
  const Eigen::Vector3d pit(1.3 + 0.731 * std::cos(37.3 * kDegree), 2.1 + 0.731 * std::sin(37.3 * kDegree), 0.0);
  simulation->apply(MoveEntity{"other", {pit, Eigen::Quaterniond::Identity()}});
  EXPECT_EQ(falls(*simulation, 2), "4 other hole 'pit'; ");
  EXPECT_TRUE(isThere(*simulation, "fb"));
}

TEST(HolesTest, LookingAtHolesAllocatesNothing) {
  if (SWARMANOID_COUNTS_ALLOCATIONS == 0) {
    GTEST_SKIP() << "the sanitizer has its own malloc";
  }
  World world = pushers("0.3");
  world.drive = "<left>0</left><right>0</right><close_at>0</close_at>";
  world.entities += rectangle("under_the_prey", {5.0, 5.2}, {0.2, 0.1});
  const auto simulation = started(world);
  tick(*simulation, 10);
  ASSERT_TRUE(isThere(*simulation, "prey")) << "held over the hole";
  const long before = heap_allocations;
  tick(*simulation, 10);
  EXPECT_EQ(heap_allocations - before, 0);
}

}  // namespace
}  // namespace swarmanoid::test

REGISTER_CONTROLLER(swarmanoid::test::Hover, "hover")
