// Replays recorded frames with a controller, without a bag: tests equal ticks, differences, and the report.
#include <gtest/gtest.h>

#include <limits>

#include "../../src/replay/device_values.hpp"
#include "../../src/replay/report.hpp"
#include "swarmanoid_interface/devices/color_blob_camera.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_interface/step_controller.hpp"

namespace swarmanoid::replay {
namespace {

/// Drives at a speed that depends on its parameter and a random number; from `turn_at` on it turns.
class Driver final : public Controller {
 public:
  void init(Robot& robot, const Configuration& parameters) override {
    robot_ = &robot;
    wheels_ = &robot.actuator<FootbotWheels>();
    camera_ = &robot.sensor<FootbotCamera>();
    turn_at_ = parameters.integer("turn_at", std::int64_t{1000});
    fail_at_ = parameters.integer("fail_at", std::int64_t{1000});
    broken_at_ = parameters.integer("broken_at", std::int64_t{1000});
  }
  void step(Time, Duration) override {
    wheels_->left = robot_->random().uniform() + static_cast<double>(camera_->blobs.size());
    wheels_->right = count_ >= turn_at_ ? -1.0 : 1.0;
    robot_->debug("state", count_ >= turn_at_ ? "turns" : "drives");
    if (count_ == fail_at_) {
      throw std::runtime_error("told to");
    }
    if (count_ == broken_at_) {
      wheels_->left = std::numeric_limits<double>::quiet_NaN();
    }
    ++count_;
  }

 private:
  Robot* robot_ = nullptr;
  FootbotWheels* wheels_ = nullptr;
  const FootbotCamera* camera_ = nullptr;
  std::int64_t turn_at_ = 0;
  std::int64_t fail_at_ = 0;
  std::int64_t broken_at_ = 0;
  std::int64_t count_ = 0;
};

std::shared_ptr<Controller> makeDriver() { return std::make_shared<Driver>(); }

SensorFrame frameOf(std::uint64_t tick) {
  SensorFrame frame;
  frame.stamp = {0, 0, tick};
  frame.seed = 5;
  frame.clocktick = std::chrono::milliseconds(100);
  frame.time = kEpoch + tick * frame.clocktick;
  ColorBlob blob;
  blob.color = Color{255, 128, 0};
  blob.distance = 1.5F;
  blob.bearing = -0.25F;
  FootbotCamera camera;
  camera.blobs = Span<const ColorBlob>(&blob, tick % 2);
  ByteWriter out(frame.data);
  out.number(std::uint8_t{1});
  const std::size_t begin = out.openBlock();
  findDeviceType(FootbotCamera::kType)->write(&camera, out);
  out.closeBlock(begin);
  return frame;
}

RecordedRun startOf(const std::string& parameter = "", int value = 0) {
  const auto* camera = findDeviceType(FootbotCamera::kType);
  RecordedRun run;
  run.start.seed = 5;
  run.start.clocktick = std::chrono::milliseconds(100);
  Configuration parameters("parameters", "", {});
  if (!parameter.empty()) {
    parameters.set(parameter, std::to_string(value));
  }
  run.start.robots.push_back({"fb_1",
                              "footbot",
                              "fc",
                              "driver",
                              {{camera->type, camera->layout}},
                              {{FootbotWheels::kType, "f8 f8"}},
                              parameters});
  return run;
}

/// Returns the recording that a space would make of this controller.
RecordedRun record(std::uint64_t ticks, const std::string& parameter = "", int value = 0) {
  RecordedRun run = startOf(parameter, value);
  ControllerHost host(run.start, makeDriver, nullptr);
  for (std::uint64_t tick = 0; tick < ticks; ++tick) {
    run.ticks.push_back({frameOf(tick), host.answer(frameOf(tick))});
  }
  return run;
}

/// Returns the same recording with other parameters for the replayed controller.
RecordedRun with(RecordedRun run, const std::string& parameter, int value) {
  run.start.robots.front().parameters = startOf(parameter, value).robot().parameters;
  return run;
}

std::string reportOf(const RecordedRun& run, TickRange range = {}) {
  return report(run, "fb_1", compare(run, makeDriver, nullptr, range));
}

TEST(ReplayTest, TheSameControllerDoesTheSame) {
  const RecordedRun run = record(10);
  const Comparison comparison = compare(run, makeDriver, nullptr);
  EXPECT_EQ(10U, comparison.compared);
  EXPECT_EQ(10U, comparison.equal);
  EXPECT_FALSE(comparison.first);
  EXPECT_EQ("fb_1: all 10 ticks are equal\n", report(run, "fb_1", comparison));
  EXPECT_EQ("", warnings(run, "fb_1"));
}

TEST(ReplayTest, AnotherOneIsDistinguishedWhereItFirstDecidesOtherwise) {
  const RecordedRun run = with(record(10), "turn_at", 7);
  EXPECT_EQ(
      "fb_1: 7 of 10 ticks are equal\n"
      "first difference: fb_1, tick 7, 0.700 s\n"
      "  footbot_wheels (f8 f8)\n"
      "    right: recorded 1, replayed -1\n"
      "  readings\n"
      "    footbot_camera: [(255 128 0 -0.25 1.5 0 0)] false\n"
      "  debug values\n"
      "    state: recorded drives, replayed turns\n",
      reportOf(run));
}

TEST(ReplayTest, OnlyTheRangeIsComparedButAllBeforeItIsStepped) {
  const RecordedRun run = with(record(10), "turn_at", 7);
  EXPECT_EQ("fb_1: all 4 ticks are equal\n", reportOf(run, {3, 6}));
  EXPECT_EQ(0U, reportOf(run, {8, 9}).find("fb_1: 0 of 2 ticks are equal\nfirst difference: fb_1, tick 8, 0.800 s\n"));
}

TEST(ReplayTest, AFailureIsTheSameFailure) {
  const RecordedRun run = record(5, "fail_at", 4);
  EXPECT_EQ("fb_1: all 5 ticks are equal\n", reportOf(run));
  EXPECT_EQ(0U, reportOf(with(run, "fail_at", 9))
                    .find("fb_1: 4 of 5 ticks are equal\n"
                          "first difference: fb_1, tick 4, 0.400 s\n"
                          "  the controller: recorded failed: told to, replayed stepped\n"));
}

TEST(ReplayTest, ANumberThatIsNoneIsWhatTheSpaceStoppedTheRobotFor) {
  RecordedRun run = record(5, "broken_at", 4);
  CommandFrame& last = *run.ticks[4].commands;
  last.data.clear();
  ByteWriter out(last.data);
  out.number(static_cast<std::uint8_t>(StepStatus::kFailed));
  out.text(kNotFinite);
  EXPECT_EQ("fb_1: all 5 ticks are equal\n", reportOf(run));
  EXPECT_EQ(0U, reportOf(with(run, "broken_at", 9)).find("fb_1: 4 of 5 ticks are equal\n"));
}

TEST(ReplayTest, DebugValuesAloneAreNoDifference) {
  RecordedRun run = record(3);
  Bytes& data = run.ticks[1].commands->data;
  data[data.size() - 1] = 'S';  // the last letter of "drives"
  EXPECT_EQ("fb_1: all 3 ticks are equal\n", reportOf(run));
}

TEST(ReplayTest, WhatTheRecordingLacksIsSaid) {
  RecordedRun run = record(10);
  run.ticks.erase(run.ticks.begin() + 4, run.ticks.begin() + 6);
  run.ticks.erase(run.ticks.begin(), run.ticks.begin() + 2);
  run.ticks.back().commands.reset();
  EXPECT_EQ(
      "warning: fb_1: the recording begins at tick 2, after the controller's start; what it knew by then is missing\n"
      "warning: fb_1: ticks 4 to 5 are missing\n",
      warnings(run, "fb_1"));
  const Comparison comparison = compare(run, makeDriver, nullptr);
  EXPECT_EQ(5U, comparison.compared);
  EXPECT_EQ(1U, comparison.without_commands);
}

TEST(ReplayTest, OtherFieldsThanHereAreRefused) {
  RecordedRun run = record(3);
  run.start.robots.front().actuators.front().layout = "f4 f4";
  try {
    compare(run, makeDriver, nullptr);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(
        "device 'footbot_wheels' of robot 'fb_1' has the fields 'f4 f4' in the space, and 'f8 f8' here; build both "
        "from the same version",
        error.what());
  }
}

TEST(ReplayTest, TheTableHasALineADevice) {
  const RecordedRun run = record(3);
  const std::string text = table(run, {1, 1});
  EXPECT_EQ(0U, text.find("fb_1\t1\t0.100\treading\tfootbot_camera\t[(255 128 0 -0.25 1.5 0 0)] false\n"
                          "fb_1\t1\t0.100\tcommand\tfootbot_wheels\t"));
  EXPECT_NE(std::string::npos, text.find(" 1\nfb_1\t1\t0.100\tdebug\tstate\tdrives\n"));
  EXPECT_EQ(3, std::count(text.begin(), text.end(), '\n'));
}

TEST(DeviceValuesTest, NumbersAreReadByTheirLayout) {
  Bytes bytes;
  ByteWriter out(bytes);
  out.number(0.1F);
  out.number(std::uint32_t{2});
  out.number(std::uint8_t{200});
  out.number(std::int16_t{-3});
  out.number(std::uint8_t{1});
  out.number(std::int16_t{4});
  out.number(true);
  const auto fields = decode("f4 (u1 i2)* b1", bytes);
  EXPECT_EQ("0.1 [(200 -3) (1 4)] true", toText(fields));
  const std::vector<std::pair<std::string, std::string>> expected = {
      {"0", "0.1"}, {"1[0].0", "200"}, {"1[0].1", "-3"}, {"1[1].0", "1"}, {"1[1].1", "4"}, {"2", "true"}};
  EXPECT_EQ(expected, named(fields, {"unknown", "f4 (u1 i2)* b1"}));
  EXPECT_THROW(decode("f8 (u1 i2)* b1", bytes), ByteError);
  EXPECT_THROW(decode("f4 (u1 i2)*", bytes), ByteError);
  EXPECT_THROW(decode("f4 (u1 x2)* b1", bytes), ByteError);
}

TEST(DeviceValuesTest, NumbersHaveTheNamesOfTheirFields) {
  const std::vector<ColorBlob> blobs{{colors::kOrange, -0.25F, 1.5F, -0.5F, 0.125F}};
  FootbotCamera camera;
  camera.blobs = blobs;
  const DeviceType& type = *findDeviceType(FootbotCamera::kType);
  Bytes bytes;
  ByteWriter out(bytes);
  type.write(&camera, out);
  const std::vector<std::pair<std::string, std::string>> expected = {
      {"blobs[0].color.red", "255"}, {"blobs[0].color.green", "128"}, {"blobs[0].color.blue", "0"},
      {"blobs[0].bearing", "-0.25"}, {"blobs[0].distance", "1.5"},    {"blobs[0].elevation", "-0.5"},
      {"blobs[0].size", "0.125"},    {"overflowed", "false"}};
  EXPECT_EQ(expected, named(decode(type.layout, bytes), {type.type, type.layout}));
  // for another version of the device only the positions are known
  Bytes other;
  ByteWriter(other).number(2.5F);
  EXPECT_EQ((std::vector<std::pair<std::string, std::string>>{{"0", "2.5"}}),
            named(decode("f4", other), {type.type, "f4"}));
}

}  // namespace
}  // namespace swarmanoid::replay
