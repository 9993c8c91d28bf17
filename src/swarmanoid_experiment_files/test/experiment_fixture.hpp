/// An experiment file without the suite's plugins, with test controllers, devices, engines and visualisations.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/registry.hpp"
#include "swarmanoid_space/experiment/experiment.hpp"

namespace swarmanoid::test {

inline Parameter parameter(const std::string& name, Parameter::Type type, std::optional<std::string> value,
                           Range range = {}) {
  return makeParameter(name, type, "", std::move(value), range, "");
}

inline void add(PluginKind kind, const std::string& label, const std::string& implementation,
                const std::vector<Parameter>& parameters, const std::vector<std::string>& label_aliases = {},
                const std::vector<std::string>& implementation_aliases = {}) {
  PluginDescription description;
  description.label = label;
  description.implementation = implementation;
  description.parameters = parameters;
  description.label_aliases = label_aliases;
  description.implementation_aliases = implementation_aliases;
  const bool is_device = kind == PluginKind::kSensor || kind == PluginKind::kActuator;
  description.robots = is_device ? std::vector<std::string>{"footbot"} : std::vector<std::string>{};
  Registry::instance().add(kind, description, [] { return std::shared_ptr<void>(); });
}

inline const char* const kFile = R"(<ahss-config>
  <framework>
    <clocktick>12.5</clocktick>
    <maxclock><!-- ticks -->500</maxclock>
  </framework>
  <controllers>
    <wander id="slow">
      <actuators><wheels/></actuators>
      <sensors>
        <eye><implementation> old_eye </implementation><range>2</range></eye>
      </sensors>
      <parameters shy="true"><speed>0.5</speed><![CDATA[ ]]></parameters>
    </wander>
  </controllers>
  <arena size="10,9,3" optimization="3D">
    <footbot id="fb">
      <position>9, 8, 0</position>
      <orientation>0, 0, 90</orientation>
      <controller>slow</controller>
    </footbot>
    <floor_patch id="nest"><position>1, 1, 0</position><size>2, 1</size><color>1,2,3</color></floor_patch>
    <distribute quantity="3">
      <minimum>0, 0, 0</minimum>
      <maximum>1, 1, 0</maximum>
      <cylindric_prey id="prey"><radius>0.1</radius><height>0.2</height></cylindric_prey>
    </distribute>
  </arena>
  <engines>
    <old_plane id="ground"/>
    <plane id="sky"><height>1e0</height></plane>
  </engines>
  <arena_physics>
    <engine id="ground"><entity id="prey"/><entity id="fb" role="mirror"/></engine>
    <engine id="sky"><entity id="fb" role="move"/></engine>
  </arena_physics>
  <visualizations>
    <table id="t"/>
  </visualizations>
</ahss-config>
)";

class ExperimentTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    using Type = Parameter::Type;
    add(PluginKind::kController, "wander", "", {});
    add(PluginKind::kActuator, "wheels", "default", {parameter("noise", Type::kNumber, "0", {0.0, 1.0})});
    add(PluginKind::kSensor, "eye", "blobs", {parameter("range", Type::kNumber, "1", {0.0, 9.0})}, {"pie"},
        {"old_eye"});
    add(PluginKind::kSensor, "eye", "pixels", {parameter("width", Type::kInteger, std::nullopt, {1.0, 4096.0})});
    add(PluginKind::kSensor, "sonar", "default", {parameter("error", Type::kNumber, "0")});
    add(PluginKind::kEngine, "plane", "", {parameter("height", Type::kNumber, "0")}, {"old_plane"});
    add(PluginKind::kObserver, "table", "", {parameter("file", Type::kText, "")});
  }

  static Experiment parse(const std::vector<Override>& overrides = {}) {
    return parseExperiment(kFile, "folder/some.xml", overrides);
  }

  static std::string refusal(const std::vector<Override>& overrides, const std::string& text = kFile) {
    try {
      parseExperiment(text, "some.xml", overrides);
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "(accepted)";
  }
};

}  // namespace swarmanoid::test
