// Controllers of networks, with devices that the test owns: parameters, commands, and allocations in a step.
#include <gtest/gtest.h>

#include <cmath>

#include "elements.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/differential_drive.hpp"
#include "swarmanoid_interface/devices/light.hpp"
#include "swarmanoid_interface/testing/count_allocations.hpp"

namespace swarmanoid {
namespace {

using test::element;
using test::refusalOf;
using test::value;

constexpr auto kTick = std::chrono::milliseconds(100);

/// A robot with two light sensors and two wheels: a Braitenberg vehicle.
class Vehicle {
 public:
  Vehicle() {
    light.sensors = readings;
    robot.provideSensor(Light::kType, &light);
    robot.provideActuator(DifferentialDrive::kType, &drive);
  }

  void start(const std::string& label, const std::vector<Configuration>& values) {
    std::vector<Configuration> all{
        element("inputs", {element("light", {element("sensors", {element("value", {value("count", "2")})})})}),
        element("outputs", {element("differential_drive",
                                    {element("speed", {value("minimum", "-0.1"), value("maximum", "0.3")}),
                                     element("turn_rate", {value("minimum", "-2"), value("maximum", "2")})})})};
    all.insert(all.end(), values.begin(), values.end());
    controller = makePlugin<Controller>(*Registry::instance().find(PluginKind::kController, label));
    controller->init(robot, element("parameters", all));
  }
  void step() { controller->step(kEpoch, kTick); }

  Robot robot{"vehicle", "any", 1};
  std::vector<LightReading> readings{{0.5F, 0.5F}, {0.25F, -0.5F}};
  Light light;
  DifferentialDrive drive;
  std::shared_ptr<Controller> controller;
};

double logistic(double x) { return 1.0 / (1.0 + std::exp(-x)); }

TEST(FeedForwardControllerTest, CommandsWhatIsComputedByHand) {
  Vehicle vehicle;
  vehicle.start("feed_forward_network", {value("weights", "0, 0, 4, -4"), value("biases", "0, 1")});
  vehicle.step();
  EXPECT_NEAR(vehicle.drive.speed, 0.1, 1e-15);
  EXPECT_NEAR(vehicle.drive.turn_rate, -2.0 + 4.0 * logistic(2.0), 1e-15);  // 1 + 4 * 0.5 - 4 * 0.25
  Vehicle hidden;
  hidden.start("feed_forward_network",
               {value("hidden", "1"), value("weights", "4, -4, 1, 2"), value("biases", "1, 0, 0")});
  hidden.step();
  EXPECT_NEAR(hidden.drive.speed, -0.1 + 0.4 * logistic(std::tanh(2.0)), 1e-15);
  EXPECT_NEAR(hidden.drive.turn_rate, -2.0 + 4.0 * logistic(2.0 * std::tanh(2.0)), 1e-15);
}

TEST(FeedForwardControllerTest, SaysHowManyParametersItNeeds) {
  const auto refused = [](const std::vector<Configuration>& values) {
    return refusalOf([&] { Vehicle().start("feed_forward_network", values); });
  };
  EXPECT_EQ(
      refused({value("hidden", "3, 2"), value("weights", "1, 2"), value("biases", "0")}),
      "file.xml:8: weights: found 2 numbers, allowed: 16 numbers separated by commas (neurons by layer: 2, 3, 2, 2)");
  EXPECT_EQ(refused({value("weights", "1, 2, 3, 4"), value("biases", "0")}),
            "file.xml:8: biases: found 1 numbers, allowed: 2 numbers separated by commas (neurons by layer: 2, 2)");
  EXPECT_EQ(
      refused({value("weights", "1, 2, 3, 4")}),
      "file.xml:7: <parameters> has no 'biases', which the network needs: 2 numbers separated by commas (neurons by "
      "layer: 2, 2)");
  EXPECT_EQ(refused({value("weights", "1, 2, x, 4"), value("biases", "0, 0")}),
            "file.xml:8: weights: found '1, 2, x, 4', allowed: 4 numbers separated by commas");
  EXPECT_EQ(refused({value("hidden", "3,"), value("weights", "1, 2, 3, 4"), value("biases", "0, 0")}),
            "file.xml:8: hidden: found '', allowed: a whole number from 1 to 1000");
  EXPECT_EQ(
      refused({value("weights", "1, 2, 3, 4"), value("biases", "0, 0"), value("time_constants", "1, 1")}),
      "file.xml:8: 'time_constants' is not known in <parameters>; allowed: inputs, outputs, hidden, weights, biases");
}

TEST(RecurrentControllerTest, FollowsItsEquation) {
  // both neurons without connections: y = g . I (1 - e^(-t / tau))
  Vehicle vehicle;
  vehicle.start("recurrent_network", {value("weights", "0, 0, 0, 0, 4, -4, 0, 0"), value("biases", "0, 1"),
                                      value("time_constants", "1, 0.5")});
  for (int k = 1; k <= 30; ++k) {
    vehicle.step();
    EXPECT_NEAR(vehicle.drive.speed, 0.1, 1e-15);
    EXPECT_NEAR(vehicle.drive.turn_rate, -2.0 + 4.0 * logistic(1.0 + 1.0 - std::exp(-0.1 * k / 0.5)), 1e-13);
  }
  vehicle.controller->reset();
  vehicle.step();
  EXPECT_NEAR(vehicle.drive.turn_rate, -2.0 + 4.0 * logistic(1.0 + 1.0 - std::exp(-0.2)), 1e-13);
}

TEST(RecurrentControllerTest, SaysHowManyParametersItNeeds) {
  const auto refused = [](const std::vector<Configuration>& values) {
    return refusalOf([&] { Vehicle().start("recurrent_network", values); });
  };
  EXPECT_EQ(refused({value("hidden", "3"), value("weights", "1, 2")}),
            "file.xml:8: weights: found 2 numbers, allowed: 35 numbers separated by commas (2 inputs, 5 neurons)");
  EXPECT_EQ(
      refused({value("weights", "1,2,3,4,5,6,7,8"), value("biases", "0,0"), value("time_constants", "1, 0")}),
      "file.xml:8: time_constants: found '1, 0', allowed: 2 numbers separated by commas, each from 0.001 to 1000000");
}

TEST(NetworkControllersTest, AllocateNothingInAStep) {
  if (SWARMANOID_COUNTS_ALLOCATIONS == 0) {
    GTEST_SKIP() << "the sanitizer has its own malloc";
  }
  for (const char* label : {"feed_forward_network", "recurrent_network"}) {
    Vehicle vehicle;
    std::vector<Configuration> values{value("weights", "1, 2, 3, 4"), value("biases", "0, 0")};
    if (std::string(label) == "recurrent_network") {
      values = {value("weights", "1, 2, 3, 4, 5, 6, 7, 8"), value("biases", "0, 0"), value("time_constants", "1, 2")};
    }
    vehicle.start(label, values);
    vehicle.step();
    const long before = heap_allocations;
    for (int k = 0; k < 100; ++k) {
      vehicle.readings[0].value = 0.01F * static_cast<float>(k);
      vehicle.step();
    }
    EXPECT_EQ(heap_allocations - before, 0) << label;
  }
  EXPECT_GT(heap_allocations, 0) << "the counting works";
}

}  // namespace
}  // namespace swarmanoid
