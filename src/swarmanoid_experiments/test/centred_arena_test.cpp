// An arena with a centre of its own: all positions move with it. A world with shifted arena and contents makes the same
// run, shifted; if the arena starts at the origin as usual, to the last bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/devices/footbot_ground.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "test_world.hpp"

namespace swarmanoid::test {
namespace {

std::string text(const Eigen::Vector3d& v) {
  return numberText(v.x()) + "," + numberText(v.y()) + "," + numberText(v.z());
}

/// Footbots that diffuse between a prey and the walls of an arena of 6 m by 4 m, over an image.
/// @param attributes of <arena> besides its size @param shift of all positions [m]
std::unique_ptr<Simulation> start(const std::string& engine, const std::string& attributes,
                                  const Eigen::Vector3d& shift) {
  loadBuiltInPlugins();
  const auto at = [&](double x, double y) { return text(shift + Eigen::Vector3d(x, y, 0.0)); };
  const std::string still = "<orientation>0,0,0</orientation>";
  const std::string xml =
      "<ahss-config><framework><clocktick>100</clocktick><maxclock>900</maxclock><random_seed>3</random_seed>"
      "</framework><controllers><diffusion id=\"d\" library=\"diffusion\"><actuators><footbot_wheels/></actuators>"
      "<sensors><footbot_proximity/><footbot_ground/></sensors><parameters/></diffusion></controllers>"
      "<arena size=\"6,4,1\" optimization=\"2D\" bounded=\"true\" " +
      attributes + "><floor_image><file>" + findShared("swarmanoid_experiments", "experiments/rough_terrain.png") +
      "</file><position>" + at(3.0, 2.0) + "</position><size>5.5,3.5</size></floor_image><floor_paint/>" +
      "<floor_patch id=\"patch\"><position>" + at(1.5, 2.0) + "</position><radius>0.3</radius></floor_patch>" +
      "<cylindric_prey id=\"prey\"><position>" + at(3.0, 2.0) + "</position>" + still +
      "<radius>0.2</radius><height>0.2</height></cylindric_prey>" +
      "<distribute quantity=\"9\" layout=\"grid\"><minimum>" + at(0.3, 0.3) + "</minimum><maximum>" + at(5.7, 3.7) +
      "</maximum><footbot id=\"fb\"><controller>d</controller></footbot></distribute></arena><engines><" + engine +
      " id=\"e\"/></engines><arena_physics><engine id=\"e\"><entity id=\"fb\"/><entity id=\"prey\"/></engine>"
      "</arena_physics><rules><area_coverage id=\"cover\" library=\"swarmanoid_devices\"/></rules></ahss-config>";
  auto simulation = std::make_unique<Simulation>(parseExperiment(xml, "centred.xml"));
  simulation->start();
  return simulation;
}

const char* const kEngines[] = {"kinematics2d", "dynamics2d", "dynamics3d"};

TEST(CentredArenaTest, AShiftedWorldMovesTheSameInEachEngine) {
  constexpr double kSame = 1e-9;  // m
  const Eigen::Vector3d shift(-3.0, -2.0, 0.0);
  for (const std::string engine : kEngines) {
    const auto corner = start(engine, "", Eigen::Vector3d::Zero());
    const auto centre = start(engine, "center=\"0,0,0.5\"", shift);
    PaintFloor paint;
    paint.discs = {{{2.0, 2.0}, 0.5, colors::kBlack, 0.7}};
    corner->apply(paint);
    paint.discs[0].position += shift.head<2>();
    centre->apply(paint);
    const Entities& here = corner->space().entities;
    const Entities& there = centre->space().entities;
    ASSERT_EQ(here.order.size(), there.order.size());
    std::vector<float> values;
    double farthest = 0.0;
    for (int k = 0; k < 100; ++k) {
      corner->tick();
      centre->tick();
      for (const Row row : here.order) {
        const Eigen::Vector3d off = there.pose[row].position - shift - here.pose[row].position;
        farthest = std::max(farthest, off.norm());
        const auto* one = corner->space().readings.find<FootbotGround>(row);
        const auto* other = centre->space().readings.find<FootbotGround>(row);
        for (std::size_t i = 0; one != nullptr && i < FootbotGround::kCount; ++i) {
          EXPECT_EQ(one->value[i], other->value[i]) << engine << ", tick " << k << ", " << here.name[row];
          values.push_back(one->value[i]);
        }
      }
    }
    EXPECT_LT(farthest, kSame) << engine;
    std::sort(values.begin(), values.end());
    EXPECT_GT(std::unique(values.begin(), values.end()) - values.begin(), 30) << "the image has many greys";
    EXPECT_EQ(corner->metrics(), centre->metrics()) << engine;
  }
}

TEST(CentredArenaTest, TheCentreOfAnArenaFromTheOriginChangesNoBit) {
  for (const std::string engine : kEngines) {
    const auto usual = start(engine, "", Eigen::Vector3d::Zero());
    const auto same = start(engine, "center=\"3,2,0.5\"", Eigen::Vector3d::Zero());
    EXPECT_EQ(hashesOf(*usual, 40), hashesOf(*same, 40)) << engine;
  }
}

TEST(CentredArenaTest, WallsStandAroundIt) {
  const auto simulation = start("kinematics2d", "center=\"0,0,0.5\"", {-3.0, -2.0, 0.0});
  EXPECT_EQ(poseOf(*simulation, "boundary_west").position, Eigen::Vector3d(-3.05, 0.0, 0.5));
  EXPECT_EQ(poseOf(*simulation, "boundary_east").position, Eigen::Vector3d(3.05, 0.0, 0.5));
  EXPECT_EQ(poseOf(*simulation, "boundary_south").position, Eigen::Vector3d(0.0, -2.05, 0.5));
  EXPECT_EQ(poseOf(*simulation, "boundary_north").position, Eigen::Vector3d(0.0, 2.05, 0.5));
}

std::string refusalOf(Simulation& simulation, const Intervention& intervention) {
  try {
    simulation.apply(intervention);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

TEST(CentredArenaTest, PlacesFromOutsideAreInIt) {
  const auto simulation = start("kinematics2d", "center=\"0,0,0.5\"", {-3.0, -2.0, 0.0});
  const auto moved = [&](double x, double y) {
    return refusalOf(*simulation, MoveEntity{"fb_1", {{x, y, 0.0}, Eigen::Quaterniond::Identity()}});
  };
  EXPECT_EQ("", moved(-2.8, -1.8));
  const std::string allowed = ", allowed: in the arena, from -3, -2, 0 to 3, 2, 1";
  EXPECT_EQ("position: found '-3.2, 0, 0'" + allowed, moved(-3.2, 0.0));
  EXPECT_EQ("position: found '0, 2.2, 0'" + allowed, moved(0.0, 2.2));
  PaintFloor paint;
  paint.discs = {{{-2.9, -1.9}, 0.05, colors::kRed, 1.0}};
  EXPECT_EQ("", refusalOf(*simulation, paint));
  const Floor& floor = simulation->space().floor;
  EXPECT_EQ(floor.colorAt({-2.9, -1.9, 0.0}, simulation->space().tick), colors::kRed);
  EXPECT_EQ(floor.colorAt({-2.8, -1.9, 0.0}, simulation->space().tick), colors::kWhite);
  paint.discs[0].position = {0.0, -2.1};
  EXPECT_EQ("position: found 0, -2.1, allowed: in the arena, from -3, -2 to 3, 2", refusalOf(*simulation, paint));
}

TEST(CentredArenaTest, EntitiesLeaveItAtItsBorders) {
  for (const double side : {-1.0, 1.0}) {
    World world;
    world.size = "6,4,1";
    world.center = "0,0,0.5";
    world.drive = "<left>10</left><right>10</right>";  // 2.9 cm a tick
    world.entities = footbot("fb", side * 2.9, 0.5, side < 0.0 ? 180.0 : 0.0);
    world.members = member("fb");
    const auto simulation = world.make();
    int left = 0;
    for (int k = 1; k <= 10; ++k) {
      simulation->tick();
      for (const Event& event : simulation->space().events) {
        left = event.kind == Event::Kind::kLeftArena ? k : left;
      }
    }
    EXPECT_EQ(left, 4) << "2.9 m + 0.116 m";
  }
}

TEST(CentredArenaTest, TheIndexFindsWhatIsThere) {
  World world;
  world.size = "8,6,2";
  world.center = "-1,-0.5,1";
  world.entities =
      "<distribute quantity=\"200\"><minimum>-5,-3.5,0</minimum><maximum>3,2.5,2</maximum><light "
      "id=\"lamp\"/></distribute>";
  const auto simulation = world.make();
  simulation->tick();
  const Space& space = simulation->space();
  for (const Eigen::Vector3d& centre :
       {Eigen::Vector3d(-4.5, -3.0, 0.5), Eigen::Vector3d(0.0, 0.0, 1.0), Eigen::Vector3d(2.5, -2.0, 1.5)}) {
    std::vector<Row> expected;
    for (const Row row : space.entities.order) {
      if ((space.entities.pose[row].position - centre).norm() <= 1.3) {
        expected.push_back(row);
      }
    }
    EXPECT_GT(expected.size(), 3U);
    EXPECT_EQ(space.index.within(space.entities, centre, 1.3), expected);
  }
}

TEST(CentredArenaTest, ACentreWithoutGroundOrBeyondAllCoordinatesIsRefused) {
  const auto refusal = [](const std::string& center) -> std::string {
    World world;
    world.size = "6,4,1";
    world.center = center;
    try {
      world.make();
    } catch (const ConfigError& error) {
      return std::string(error.what()).substr(std::string(error.what()).find(": ") + 2);
    }
    return "";
  };
  EXPECT_EQ("", refusal("0,0,0"));
  EXPECT_EQ("center: found '0,0,0.6', allowed: a height from -0.5 to 0.5, so that the ground, z = 0, is in the arena",
            refusal("0,0,0.6"));
  EXPECT_EQ("center: found '9998,0,0', allowed: an arena whose coordinates are from -10000 to 10000",
            refusal("9998,0,0"));
  EXPECT_EQ(0U, refusal("0,0").find("center: found '0,0'"));
}

}  // namespace
}  // namespace swarmanoid::test
