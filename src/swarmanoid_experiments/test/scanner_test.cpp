// Distance sensors from the experiment file to the controller, in all engines: their readings follow from the positions
// of robots and walls, and have the same bits with any number of threads, after a reset, and across handovers.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/eyebot_distance.hpp"
#include "swarmanoid_interface/devices/footbot_scanner.hpp"
#include "swarmanoid_interface/devices/handbot_distance.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "test_world.hpp"

namespace swarmanoid::test {
namespace {

constexpr float kNothing = std::numeric_limits<float>::infinity();
constexpr double kRate = 2.3;  // rad/s

/// Turns its scanner, if it has one.
class TestScanning final : public Controller {
 public:
  void init(Robot& robot, const Configuration& parameters) override {
    if (robot.hasActuator(FootbotScanner::kType)) {
      robot.actuator<FootbotScanner>().turnAt(kRate);
    }
    parameters.refuseUnread();
  }
  void step(Time, Duration) override {}
};

std::string entity(const std::string& type, const std::string& id, const std::string& position, double yaw) {
  return "<" + type + " id='" + id + "'><position>" + position + "</position><orientation>0,0," + std::to_string(yaw) +
         "</orientation><controller>" + type + "</controller></" + type + ">";
}

/// Robots beside walls: east of the footbot at x = 2.31, north of the handbot at y = 6.4, and above the eyebot at z =
/// 2.45.
std::unique_ptr<Simulation> world(const std::string& ground, int threads = 1) {
  loadBuiltInPlugins();
  std::string text =
      "<ahss-config><framework><clocktick>100</clocktick><maxclock>1000</maxclock><threads>" + std::to_string(threads) +
      "</threads></framework><controllers>"
      "<test_scanning id='footbot' library='swarmanoid_devices'><actuators><footbot_scanner/></actuators>"
      "<sensors><footbot_scanner_readings/></sensors></test_scanning>"
      "<test_scanning id='eyebot' "
      "library='swarmanoid_devices'><actuators><eyebot_velocity/></actuators><sensors><eyebot_distance/></sensors></"
      "test_scanning>"
      "<test_scanning id='handbot' library='swarmanoid_devices'><sensors><handbot_distance/></sensors></test_scanning>"
      "</controllers><arena size='8,8,3' optimization='3D'>" +
      entity("footbot", "fb", "1.6,2,0", 25.0) + entity("eyebot", "eb", "5,4,1", -20.0) +
      entity("handbot", "hb", "6,6,0", 35.0) +
      "<block id='east'><position>2.36,2,0.2</position><orientation>0,0,0</orientation><size>0.1,3,0.4</size></block>"
      "<block id='over'><position>5,4,2.5</position><orientation>0,0,0</orientation><size>2,2,0.1</size></block>"
      "<block id='north'><position>6,6.5,0.2</position><orientation>0,0,0</orientation><size>3,0.2,0.4</size></block>";
  std::string members = "<entity id='fb'/><entity id='east'/>";
  for (int i = 0; i < 20; ++i) {
    const std::string id = "other_" + std::to_string(i);
    text += entity("footbot", id, std::to_string(0.3 + 0.31 * i) + ",0.2,0", 17.0 * i);
    members += "<entity id='" + id + "'/>";
  }
  text += "</arena><engines><" + ground +
          " id='ground'/><dynamics3d id='space'/></engines><arena_physics><engine id='ground'>" + members +
          "</engine><engine id='space'><entity id='eb'/><entity id='hb'/><entity id='over'/><entity id='north'/>"
          "</engine></arena_physics></ahss-config>";
  auto simulation = std::make_unique<Simulation>(parseExperiment(text, "test.xml"));
  simulation->start();
  return simulation;
}

template <class Device>
const Device& readingsOf(const Simulation& simulation, const char* robot) {
  const Space& space = simulation.space();
  return *space.readings.find<Device>(space.entities.find(robot));
}

/// @param ticks finished ticks; the last readings are of the state one tick earlier
void expectScan(const Simulation& simulation, int ticks) {
  const auto& readings = readingsOf<FootbotScannerReadings>(simulation, "fb");
  const Pose& pose = poseOf(simulation, "fb");
  const double heading = headingOf(simulation, "fb");
  EXPECT_NEAR(std::remainder(kRate * 0.1 * (ticks - 1) - readings.angle, 2.0 * M_PI), 0.0, 1e-9);
  int finite = 0;
  for (std::size_t i = 0; i < FootbotScannerReadings::kSamples; ++i) {
    const double head = kRate * 0.1 * (ticks - 2 + (static_cast<double>(i) + 1.0) / 8.0);
    for (const std::size_t beam : {1, 3}) {
      const double way = heading + head + FootbotScannerReadings::offset(beam);
      const double distance = (2.31 - pose.position.x()) / std::cos(way);
      const double y = pose.position.y() + distance * std::sin(way);
      if (distance > 0.0 && distance < 1.49 && y > 0.7 && y < 3.4) {
        EXPECT_NEAR(distance, readings.distances(beam)[i], 1e-4) << i << " of beam " << beam;
        ++finite;
      }
    }
  }
  EXPECT_GT(finite, 3) << "samples that see the wall";
}

class ScannerTest : public testing::TestWithParam<std::string> {};

TEST_P(ScannerTest, MeasuresFromTheFileToTheController) {
  const auto simulation = world(GetParam());
  hashesOf(*simulation, 5);
  expectScan(*simulation, 5);
  const auto& eyebot = readingsOf<EyebotDistance>(*simulation, "eb");
  const double height = poseOf(*simulation, "eb").position.z();
  EXPECT_NEAR(height + EyebotDistance::kDownHeight, eyebot.down, 1e-3);
  EXPECT_NEAR(2.45 - height - EyebotDistance::kUpHeight, eyebot.up, 1e-3);
  EXPECT_EQ(kNothing, eyebot.around[5]);
  const auto& handbot = readingsOf<HandbotDistance>(*simulation, "hb");
  // sensor 2 faces 5 degrees off the normal of the wall, whose face is 0.4 m from the axis
  EXPECT_NEAR(0.4 / std::cos(M_PI / 36.0) - HandbotDistance::kRingRadius, handbot.distance[2], 1e-3);
  EXPECT_EQ(kNothing, handbot.distance[8]);
}

std::vector<std::uint64_t> deepHashes(Simulation& simulation, int ticks) {
  std::vector<std::uint64_t> hashes;
  for (int i = 0; i < ticks; ++i) {
    hashesOf(simulation, 1);
    hashes.push_back(deepHash(simulation.space()));
  }
  return hashes;
}

TEST_P(ScannerTest, ReadsTheSameBitsWithTwoThreadsAndAfterAReset) {
  const auto simulation = world(GetParam());
  const auto expected = deepHashes(*simulation, 17);
  EXPECT_EQ(expected, deepHashes(*world(GetParam(), 2), 17)) << "on two threads";
  simulation->reset();
  EXPECT_EQ(expected, deepHashes(*simulation, 17)) << "after a reset";
  expectScan(*simulation, 17);
}

INSTANTIATE_TEST_SUITE_P(Engines, ScannerTest, testing::Values("kinematics2d", "dynamics2d", "dynamics3d"),
                         [](const auto& engine) { return engine.param; });

TEST(ScannerHandoverTest, TheHeadTurnsOnWhoeverMovesTheRobot) {
  const auto simulation = world("kinematics2d");
  hashesOf(*simulation, 6);
  simulation->apply(HandOverEntity{"fb", "space"});
  hashesOf(*simulation, 3);
  expectScan(*simulation, 9);
  simulation->apply(HandOverEntity{"fb", "ground"});
  hashesOf(*simulation, 8);
  expectScan(*simulation, 17);
}

}  // namespace
}  // namespace swarmanoid::test

REGISTER_CONTROLLER(swarmanoid::test::TestScanning, "test_scanning")
