// Snapshots of all controllers of this package, in a world of random readings: a controller that has lived its own life
// loads the state of another one, and then commands the same, bit by bit.
#include <gtest/gtest.h>

#include <sstream>

#include "elements.hpp"
#include "random_devices.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/handbot_arms.hpp"
#include "swarmanoid_interface/devices/handbot_rope.hpp"
#include "swarmanoid_interface/plugin_library.hpp"

namespace swarmanoid {
namespace {

using test::element;
using test::RandomDevices;
using test::value;

constexpr auto kTick = std::chrono::milliseconds(250);

/// The controllers that CMakeLists.txt builds.
std::vector<std::string> labels() {
  std::istringstream words(CONTROLLERS);
  return {std::istream_iterator<std::string>(words), {}};
}

/// Parameters of controllers that do not start without.
Configuration parametersOf(const std::string& label) {
  const Configuration inputs =
      element("inputs", {element("footbot_proximity", {element("value", {value("groups", "2")})})});
  const Configuration outputs = element(
      "outputs", {element("footbot_wheels", {element("left", {value("minimum", "-5"), value("maximum", "5")}),
                                             element("right", {value("minimum", "-5"), value("maximum", "5")})})});
  std::vector<Configuration> values;
  if (label == "behaviour_machine") {
    values = {
        element("states", {element("a", {value("behaviour", "exploration"), value("turning", "9")}),
                           element("b", {value("behaviour", "phototaxis")})}),
        element("transitions", {element("there", {value("from", "a"), value("to", "b"),
                                                  value("condition", "black_floor"), value("probability", "0.3")}),
                                element("back", {value("from", "b"), value("to", "a"), value("condition", "always"),
                                                 value("probability", "0.3")})})};
  } else if (label == "eyebot_retrieval") {
    values = {value("prey_color_1", "yellow"), value("prey_color_2", "magenta")};
  } else if (label == "feed_forward_network") {
    values = {inputs, outputs, value("weights", "1, -2, 3, 1"), value("biases", "0, 1")};
  } else if (label == "recurrent_network") {
    values = {inputs, outputs, value("weights", "1, -2, 3, 1, 2, -1, 1, 2"), value("biases", "0, 1"),
              value("time_constants", "0.3, 2")};
  }
  return element("parameters", values);
}

/// A robot with all devices, and its controller.
class Subject {
 public:
  Subject(const std::string& label, std::uint64_t seed)
      : readings(DeviceKind::kSensor), commands(DeviceKind::kActuator), robot("robot", "any", seed) {
    readings.visit([&](const std::string& type, void* device) { robot.provideSensor(type, device); });
    commands.visit([&](const std::string& type, void* device) { robot.provideActuator(type, device); });
    controller = makePlugin<Controller>(*Registry::instance().find(PluginKind::kController, label));
    controller->init(robot, parametersOf(label));
  }

  void step() {
    ++tick;
    robot.startTick(tick, kEpoch + tick * kTick);
    controller->step(kEpoch + tick * kTick, kTick);
  }

  /// The readings of a handbot follow from its commands: at random it would never climb.
  void closeLoop() {
    const auto& arms = robot.actuator<HandbotArms>();
    const auto& rope = robot.actuator<HandbotRope>();
    rope_length -= rope.winding_speed * toSeconds(kTick);
    readings.visit([&](const std::string& type, void* device) {
      if (type == HandbotArmsState::kType) {
        static_cast<HandbotArmsState*>(device)->joints[0].angle = arms.left.shoulder;
      } else if (type == HandbotRopeState::kType) {
        static_cast<HandbotRopeState*>(device)->length = rope_length;
      }
    });
  }

  void takeStateOf(Subject& other) {
    std::vector<std::byte> bytes;
    StateArchive saved(bytes);
    saved(*other.controller, other.robot);
    StateArchive loaded(Span<const std::byte>(bytes.data(), bytes.size()));
    loaded(*controller, robot);
    EXPECT_TRUE(loaded.isAtEnd());
    commands.takeFrom(other.commands);  // as devices are saved
    tick = other.tick;
    rope_length = other.rope_length;
  }

  RandomDevices readings;
  RandomDevices commands;
  Robot robot;
  std::shared_ptr<Controller> controller;
  std::uint64_t tick = 0;
  double rope_length = 2.0;  // m
};

void live(Subject& subject, unsigned ticks, std::mt19937& random) {
  for (unsigned i = 0; i < ticks; ++i) {
    subject.readings.change(random);
    subject.closeLoop();
    subject.step();
  }
}

class ControllerArchiveTest : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override { loadPluginLibrary(GetParam(), {}, {}); }
};

TEST_P(ControllerArchiveTest, GoesOnWithTheSameCommands) {
  if (GetParam() == "conformance") {
    Subject subject("conformance", 1);
    std::vector<std::byte> bytes;
    StateArchive archive(bytes);
    EXPECT_THROW(archive(*subject.controller), StateNotDefined) << "its checks keep readings in their functions";
    return;
  }
  const bool is_long = GetParam() == "climbing" || GetParam() == "eyebot_retrieval";  // some of their states are rare
  const unsigned runs = is_long ? 300 : 40;
  for (unsigned run = 1; run <= runs; ++run) {
    std::mt19937 random(run);
    Subject first(GetParam(), run);
    for (unsigned snapshot = 0; snapshot < 3; ++snapshot) {
      live(first, random() % 40, random);
      Subject second(GetParam(), run + runs);
      live(second, snapshot == 1 ? 0 : random() % 40, random);
      second.takeStateOf(first);
      for (int together = 0; together < 24; ++together) {
        first.readings.change(random);
        first.closeLoop();
        second.readings.takeFrom(first.readings);
        first.step();
        second.step();
        ASSERT_EQ(first.commands.bytes(), second.commands.bytes()) << "run " << run << ", tick " << first.tick;
        ASSERT_EQ(first.robot.debugValues(), second.robot.debugValues()) << "run " << run << ", tick " << first.tick;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, ControllerArchiveTest, testing::ValuesIn(labels()),
                         [](const auto& controller) { return controller.param; });

}  // namespace
}  // namespace swarmanoid
