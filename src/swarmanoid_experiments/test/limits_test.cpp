// Every number in an experiment file has bounds, and with any value the run either has finite poses or is rejected with
// the location of the value and its bounds. The numbers come from the tables that readers and schema use.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "swarmanoid_experiment_files/experiment_tags.hpp"
#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/eyebot_laser.hpp"
#include "swarmanoid_interface/devices/eyebot_velocity.hpp"
#include "swarmanoid_interface/devices/footbot_turret.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_interface/devices/handbot_arms.hpp"
#include "swarmanoid_interface/devices/handbot_rope.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid {
namespace {

/// Has all devices of its robot and does not use them.
class Idle final : public Controller {
 public:
  void init(Robot&, const Configuration&) override {}
  void step(Time, Duration) override {}
};

/// Commands the largest numbers, with alternating signs.
class Wild final : public Controller {
 public:
  void init(Robot& robot, const Configuration&) override { robot_ = &robot; }
  void step(Time, Duration) override {
    value_ = -value_;
    if (robot_->type() == "footbot") {
      robot_->actuator<FootbotWheels>() = {value_, -value_};
      FootbotTurret& turret = robot_->actuator<FootbotTurret>();
      value_ > 0.0 ? turret.holdAngle(value_) : turret.turnAt(value_);
    } else if (robot_->type() == "eyebot") {
      robot_->actuator<EyebotVelocity>() = {Eigen::Vector3d::Constant(value_), value_};
      robot_->actuator<EyebotLaser>() = {true, value_, value_};
    } else if (robot_->hasActuator(HandbotArms::kType)) {
      robot_->actuator<HandbotArms>() = {{value_, value_, value_}, {value_, value_, value_}};
      robot_->actuator<HandbotRope>() = {value_ > 0.0, value_};
    }
  }

 private:
  Robot* robot_ = nullptr;
  double value_ = std::numeric_limits<double>::max();
};

bool isNumeric(const Parameter& parameter) {
  using Type = Parameter::Type;
  return parameter.type != Type::kBoolean && parameter.type != Type::kText && parameter.type != Type::kChoice &&
         parameter.type != Type::kColor;
}

std::size_t componentsOf(const Parameter& parameter) {
  using Type = Parameter::Type;
  if (parameter.type == Type::kVector2) {
    return 2;
  }
  return parameter.type == Type::kVector3 || parameter.type == Type::kAngles3 ? 3 : 1;
}

/// A number in a file, and its path for --set.
struct Number {
  std::string path;
  Parameter parameter;
};

class World {
 public:
  explicit World(std::string engine, std::string controller = "idle")
      : engine_(std::move(engine)), controller_(std::move(controller)) {
    loadBuiltInPlugins();
    for (const char* robot : {"footbot", "eyebot", "handbot"}) {
      text_ += controllerOf(robot);
    }
    text_ += "</controllers>\n<arena size='10,10,3' optimization='2D' bounded='true'>\n" + entities() + terrain() +
             "</arena>\n<engines><" + engine_ +
             " id='e'/><kinematics2d id='other'/></engines>\n<arena_physics>\n"
             "<engine id='e'>";
    for (const char* member : {"fb", "eb", "hb", "prey", "wall", "crate", "group"}) {
      text_ += "<entity id='" + std::string(member) + "'/>";
    }
    text_ +=
        "</engine>\n<handover id='rule' entity='crate' to='other'><inside><minimum>7,7,0</minimum><maximum>8,8,1"
        "</maximum></inside></handover>\n</arena_physics></ahss-config>";
    addTag("framework", "framework");
    addTag("arena", "arena");
    addTag("arena.distribute", "arena/distribute");
    leaveOutOtherAreas();
    addTag("arena.nest", "arena/floor_patch");
    addTag("arena.pit", "arena/hole");
    addTag("arena.floor_image", "arena/floor_image");
    addTag("arena.floor_paint", "arena/floor_paint");
    addTag("arena_physics.rule.inside", "arena_physics/handover/inside");
    add("engines.e", Registry::instance().find(PluginKind::kEngine, engine_)->description.parameters);
  }

  const std::vector<Number>& numbers() const { return numbers_; }

  /// Result of a run with that value: "" if it has finite poses, else the rejection or the error.
  std::string refusalOf(const std::string& path, const std::string& value, int ticks = 3) const {
    try {
      Simulation simulation(parseExperiment(text_, "world.xml", {{path, value}}));
      simulation.start();
      for (int tick = 0; tick < ticks; ++tick) {
        simulation.tick();
      }
      for (const Pose& pose : simulation.space().entities.pose) {
        if (!pose.position.allFinite() || !pose.orientation.coeffs().allFinite()) {
          return "ran with a pose that is not finite";
        }
      }
      return "";
    } catch (const ConfigError& error) {
      return error.what();
    } catch (const std::exception& error) {
      return std::string("stopped: ") + error.what();
    }
  }

 private:
  /// The group is distributed in a box, which rejects the parameters of discs, rings and lines by name.
  void leaveOutOtherAreas() {
    for (const char* name : {"center", "radius", "inner_radius", "from", "to"}) {
      const auto is_it = [&](const Number& number) { return number.path == std::string("arena.distribute.") + name; };
      numbers_.erase(std::remove_if(numbers_.begin(), numbers_.end(), is_it), numbers_.end());
    }
  }

  void add(const std::string& path, const std::vector<Parameter>& parameters) {
    for (const Parameter& parameter : parameters) {
      if (isNumeric(parameter)) {
        numbers_.push_back({path + "." + parameter.name, parameter});
      }
    }
  }

  void addTag(const std::string& path, const std::string& tag_path) {
    for (const ExperimentTag& tag : experimentTags()) {
      if ((tag.in.empty() ? tag.name : tag.in + "/" + tag.name) != tag_path) {
        continue;
      }
      add(path, tag.values);
      for (const ExperimentAttribute& attribute : tag.attributes) {
        add(path, {attribute.value});
      }
    }
  }

  std::string devicesOf(const std::string& robot, PluginKind kind, const std::string& section) {
    std::string text = "<" + section + ">";
    for (const Registry::Entry* entry : Registry::instance().all(kind)) {
      const PluginDescription& device = entry->description;
      const bool is_spatial = device.label.rfind("handbot_", 0) == 0 || device.label.rfind("eyebot_magnet", 0) == 0;
      const bool is_carried = std::find(device.robots.begin(), device.robots.end(), robot) != device.robots.end();
      const bool is_usual = Registry::instance().find(kind, device.label) == entry;  // the default one
      if (is_usual && is_carried && (!is_spatial || engine_ == "dynamics3d") && isChosen(device.label)) {
        text += "<" + device.label + "/>";
        add("controllers." + robot + "_idle." + section + "." + device.label, device.parameters);
      }
    }
    return text + "</" + section + ">";
  }

  /// Each engine gets a different one of the devices that exclude each other on a robot.
  bool isChosen(const std::string& device) const {
    const std::map<std::string, std::string> only_in{{"footbot_leds", "kinematics2d"},
                                                     {"footbot_beacon", "dynamics2d"},
                                                     {"footbot_preferential_direction", "dynamics3d"},
                                                     {"eyebot_velocity", "kinematics2d"},
                                                     {"eyebot_position", "dynamics3d"}};
    const auto found = only_in.find(device);
    return found == only_in.end() || found->second == engine_ ||
           (device == "eyebot_velocity" && engine_ == "dynamics2d");
  }

  std::string controllerOf(const std::string& robot) {
    return "<" + controller_ + " id='" + robot + "_idle'>" + devicesOf(robot, PluginKind::kActuator, "actuators") +
           devicesOf(robot, PluginKind::kSensor, "sensors") + "</" + controller_ + ">\n";
  }

  std::string entity(const std::string& type, const std::string& id, const std::string& position,
                     const std::string& more) {
    add("arena." + id, Registry::instance().find(PluginKind::kEntity, type)->description.parameters);
    addTag("arena." + id, "arena/*");
    return "<" + type + " id='" + id + "'><position>" + position + "</position><orientation>0,0,0</orientation>" +
           more + "</" + type + ">\n";
  }

  std::string entities() {
    const std::string size = "<size>0.4,0.4,0.4</size>";
    const std::string battery = "<battery>true</battery>";
    const std::string eyebot_place = engine_ == "dynamics3d" ? "1,3,1" : "1,3,0";
    return entity("footbot", "fb", "1,1,0", battery + "<controller>footbot_idle</controller>") +
           entity("eyebot", "eb", eyebot_place, battery + "<controller>eyebot_idle</controller>") +
           entity("handbot", "hb", "3,1,0", battery + "<controller>handbot_idle</controller>") +
           entity("cylindric_prey", "prey", "3,3,0", "<radius>0.1</radius><height>0.1</height>") +
           entity("block", "wall", "5,3,0.2", size) + entity("block", "crate", "5,1,0.2", size + "<mass>1</mass>") +
           entity("light", "lamp", "5,5,2", "") +
           "<floor_patch id='nest'><position>1,5,0</position><radius>0.4</radius></floor_patch>\n"
           "<hole id='pit'><position>9.5,9.5,0</position><radius>0.2</radius></hole>\n"
           "<floor_image><file>" +
           findShared("swarmanoid_experiments", "experiments/rough_terrain.png") +
           "</file><position>8,8,0</position><size>2,2</size></floor_image>\n"
           "<floor_paint><cell>0.5</cell><half_life>3</half_life></floor_paint>\n"
           "<distribute quantity='2' layout='grid'><minimum>7,1,0</minimum><maximum>9,2,0</maximum><cylindric_prey "
           "id='group'><radius>0.1</radius><height>0.1</height></cylindric_prey></distribute>\n";
  }

  std::string terrain() {
    if (engine_ != "dynamics3d") {
      return "";
    }
    addTag("arena.heightfield", "arena/heightfield");
    return "<heightfield><file>" + findShared("swarmanoid_experiments", "experiments/rough_terrain.png") +
           "</file><position>8,8,0</position><size>2,2</size><height>0.1</height></heightfield>\n";
  }

  std::string engine_;
  std::string controller_;
  std::string text_ =
      "<ahss-config><framework><clocktick>100</clocktick><maxclock>10</maxclock></framework>\n<controllers>\n";
  std::vector<Number> numbers_;
};

/// The value as all components, as the first only, and as the last only.
std::vector<std::string> textsOf(const Number& number, const std::string& value) {
  switch (componentsOf(number.parameter)) {
    case 2:
      return {value + "," + value, value + ",2", "2," + value};
    case 3:
      return {value + "," + value + "," + value, value + ",2,0.5", "2,2," + value};
    default:
      return {value};
  }
}

std::vector<std::string> valuesFor(const Number& number) {
  std::vector<std::string> values{"1e40", "-1e40", "1e-40", "1e-9", "1e300", "1e9",          "-1e9", "0",
                                  "-1",   "nan",   "-nan",  "inf",  "-inf",  "999999999999", "1e999"};
  // the bounds themselves, unless they would only make the run long
  const std::string name = number.path.substr(number.path.rfind('.') + 1);
  const bool makes_long = name == "quantity" || name == "threads";
  values.push_back(numberText(number.parameter.range.minimum));
  if (!makes_long) {
    const bool is_whole = number.parameter.type == Parameter::Type::kInteger;
    values.push_back(is_whole ? std::to_string(static_cast<std::int64_t>(number.parameter.range.maximum))
                              : numberText(number.parameter.range.maximum));
  }
  return values;
}

bool isWithin(const Parameter& parameter, const std::string& value) {
  try {
    if (parameter.type == Parameter::Type::kInteger) {
      parseInteger(value, "", {}, parameter.range);
    } else {
      parseNumber(value, "", {}, parameter.range);
    }
    return true;
  } catch (const ConfigError&) {
    return false;
  }
}

class NumbersTest : public testing::TestWithParam<const char*> {};

TEST_P(NumbersTest, WhateverTheyAreTheRunIsFiniteOrRefused) {
  const World world(GetParam());
  ASSERT_EQ(world.refusalOf("framework.maxclock", "10"), "");
  EXPECT_GT(world.numbers().size(), 40U);
  for (const Number& number : world.numbers()) {
    for (const std::string& value : valuesFor(number)) {
      for (const std::string& text : textsOf(number, value)) {
        const std::string refusal = world.refusalOf(number.path, text);
        const std::string what = number.path + "=" + text + ": " + refusal;
        if (!isWithin(number.parameter, value)) {
          EXPECT_EQ(refusal.rfind("--set " + number.path + ": ", 0), 0U) << what;
          EXPECT_NE(refusal.find("', allowed: "), std::string::npos) << what;
          EXPECT_NE(refusal.find(number.parameter.range.toString()), std::string::npos) << what;
        } else {
          // an allowed value may still cause an overlap, or a position outside the arena
          EXPECT_NE(refusal.rfind("stopped", 0), 0U) << what;
          EXPECT_NE(refusal.rfind("ran", 0), 0U) << what;
        }
      }
    }
  }
}

TEST_P(NumbersTest, CommandsOfAnySizeAreLimitedToWhatTheDevicesDo) {
  EXPECT_EQ(World(GetParam(), "wild").refusalOf("framework.maxclock", "50", 50), "");
}

INSTANTIATE_TEST_SUITE_P(Engines, NumbersTest, testing::Values("kinematics2d", "dynamics2d", "dynamics3d"),
                         [](const auto& engine) { return std::string(engine.param); });

TEST(NumbersTest, AllHaveBounds) {
  loadBuiltInPlugins();
  const auto check = [](const std::string& where, const Parameter& parameter) {
    if (isNumeric(parameter)) {
      EXPECT_TRUE(std::isfinite(parameter.range.minimum) && std::isfinite(parameter.range.maximum))
          << where << " " << parameter.name;
    }
  };
  for (const PluginKind kind : kPluginKinds) {
    if (kind == PluginKind::kController) {
      continue;  // their parameters are free
    }
    for (const Registry::Entry* entry : Registry::instance().all(kind)) {
      for (const Parameter& parameter : entry->description.parameters) {
        check(entry->description.label, parameter);
      }
    }
  }
  for (const ExperimentTag& tag : experimentTags()) {
    for (const Parameter& parameter : tag.values) {
      check(tag.name, parameter);
    }
    for (const ExperimentAttribute& attribute : tag.attributes) {
      check(tag.name, attribute.value);
    }
  }
}

}  // namespace
}  // namespace swarmanoid

REGISTER_CONTROLLER(swarmanoid::Idle, "idle")
REGISTER_CONTROLLER(swarmanoid::Wild, "wild")
