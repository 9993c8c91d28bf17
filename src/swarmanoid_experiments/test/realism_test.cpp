// Presets of devices: one word in the file selects them, the file's own values take precedence, and a record contains
// them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_experiment_files/realism.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/eyebot_pressure.hpp"
#include "swarmanoid_recording/records/run_record.hpp"
#include "swarmanoid_space/experiment/experiment.hpp"
#include "test_world.hpp"

namespace swarmanoid::test {
namespace {

class Idle final : public Controller {
 public:
  void init(Robot&, const Configuration&) override {}
  void step(Time, Duration) override {}
};

/// An eyebot at 1 m, with the parts of a file that may select a preset.
struct EyebotFile {
  std::string framework = {};
  std::string controller = {};
  std::string pressure = {};
  std::string more = {};

  std::string xml() const {
    return "<ahss-config><framework><clocktick>100</clocktick><maxclock>5000</maxclock>" + framework +
           "</framework><controllers><realism_idle id='c' library='swarmanoid_devices'>" + controller +
           "<sensors><eyebot_pressure>\n" + pressure + "</eyebot_pressure>" + more +
           "</sensors><parameters/></realism_idle></controllers>"
           "<arena size='10,10,4' optimization='2D'><eyebot id='eb'><position>5,5,1</position>"
           "<orientation>0,0,0</orientation><controller>c</controller></eyebot></arena>"
           "<engines><kinematics2d id='sky'><distance>1</distance></kinematics2d></engines>"
           "<arena_physics><engine id='sky'><entity id='eb'/></engine></arena_physics></ahss-config>";
  }
  Experiment read(const std::vector<Override>& overrides = {}) const {
    loadBuiltInPlugins();
    return parseExperiment(xml(), "eyebot.xml", overrides);
  }
};

/// Kinds of errors of the pressure sensor, such as "gaussian quantisation".
std::string errorsOf(const Experiment& experiment) {
  std::string kinds;
  for (const ErrorModelDescription& error : experiment.controllers.at(0).sensors.at(0).errors) {
    kinds += (kinds.empty() ? "" : " ") + error.kind;
  }
  return kinds;
}

std::string messageOf(const EyebotFile& file, const std::vector<Override>& overrides = {}) {
  try {
    file.read(overrides);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

constexpr const char* kTypical = "<realism>typical</realism>";
constexpr const char* kIdeal = "<realism>ideal</realism>";

TEST(RealismTest, TheInnermostElementThatSaysSoChooses) {
  EXPECT_EQ(errorsOf(EyebotFile{}.read()), "") << "ideal, where nothing is said";
  EXPECT_EQ(errorsOf(EyebotFile{kTypical}.read()), "gaussian quantisation");
  EXPECT_EQ(errorsOf(EyebotFile{kTypical, kIdeal}.read()), "");
  EXPECT_EQ(errorsOf(EyebotFile{"", kTypical}.read()), "gaussian quantisation");
  EXPECT_EQ(errorsOf(EyebotFile{kTypical, kIdeal, kTypical}.read()), "gaussian quantisation");
  EXPECT_EQ(errorsOf(EyebotFile{kTypical, "", kIdeal}.read()), "");
}

TEST(RealismTest, OneOverrideChoosesForARow) {
  EXPECT_EQ(errorsOf(EyebotFile{}.read({{"framework.realism", "typical"}})), "gaussian quantisation");
  EXPECT_EQ(errorsOf(EyebotFile{kTypical}.read({{"framework.realism", "ideal"}})), "");
  EXPECT_EQ(errorsOf(EyebotFile{}.read({{"controllers.c.realism", "typical"}})), "gaussian quantisation");
}

TEST(RealismTest, ErrorsOfTheFileReplaceThoseOfThePreset) {
  const Experiment experiment = EyebotFile{kTypical, "", "<error kind='bias' offset='3'/>"}.read();
  EXPECT_EQ(errorsOf(experiment), "bias");
}

TEST(RealismTest, ANameThatNoPresetHasIsRefusedWhereItStands) {
  EXPECT_EQ(messageOf({"<realism>typcal</realism>"})
                .rfind("eyebot.xml:1: realism: found the value 'typcal', allowed: "
                       "ideal, ",
                       0),
            0U)
      << messageOf({"<realism>typcal</realism>"});
  EXPECT_NE(messageOf({"", "", "\n\n<realism>none</realism>"}).find("eyebot.xml:4: realism: found the value 'none'"),
            std::string::npos)
      << messageOf({"", "", "\n\n<realism>none</realism>"});
  EXPECT_NE(messageOf({}, {{"framework.realism", "real"}}).find("--set framework.realism: "), std::string::npos);
  EXPECT_NE(messageOf({std::string(kTypical) + kTypical}).find("found a second <realism>"), std::string::npos);
  EXPECT_NE(messageOf({"", std::string(kTypical) + kTypical}).find("found a second <realism>"), std::string::npos);
  EXPECT_NE(messageOf({"", "", std::string(kTypical) + kTypical}).find("found a second <realism>"), std::string::npos);
}

/// A record contains the preset's values: it stays the same run when the installed presets change.
TEST(RealismTest, ARecordSpellsThePresetOut) {
  const Experiment experiment = EyebotFile{kTypical}.read();
  const RunRecord record = recordOf(experiment, "1.2.3");
  EXPECT_NE(record.text.find("<error kind=\"gaussian\" deviation=\"5\"/>"), std::string::npos) << record.text;
  EXPECT_NE(record.text.find("<realism>ideal</realism>"), std::string::npos) << record.text;
  EXPECT_EQ(record.text.find("<realism>typical"), std::string::npos);
  const Experiment again = parseExperiment(record.text, "again.xml");
  EXPECT_EQ(errorsOf(again), "gaussian quantisation");
  const auto run = [](const Experiment& described) {
    Simulation simulation(described);
    simulation.start();
    std::vector<std::uint64_t> hashes;
    for (int tick = 0; tick < 20; ++tick) {
      simulation.tick();
      hashes.push_back(deepHash(simulation.space()));
    }
    return hashes;
  };
  EXPECT_EQ(run(experiment), run(again));
}

/// From the data sheet: 0.05 hPa RMS, in steps of 0.01 hPa, which add a rounding error of 1 Pa / sqrt(12).
TEST(RealismTest, TheTypicalBarometerIsAsItsDataSheetSays) {
  Simulation simulation(EyebotFile{kTypical}.read());
  simulation.start();
  const Space& space = simulation.space();
  std::vector<double> readings;
  constexpr int kTicks = 4000;
  for (int tick = 0; tick < kTicks; ++tick) {
    simulation.tick();
    readings.push_back(space.readings.find<EyebotPressure>(space.entities.find("eb"))->difference);
    EXPECT_NEAR(readings.back(), std::round(readings.back()), 1e-9);
  }
  double mean = 0.0;
  double squares = 0.0;
  for (const double reading : readings) {
    mean += reading / kTicks;
    squares += reading * reading / kTicks;
  }
  EXPECT_NEAR(mean, 0.0, 4.0 * 5.0 / std::sqrt(kTicks)) << "it stays at the height where it was put";
  EXPECT_NEAR(std::sqrt(squares), std::sqrt(25.0 + 1.0 / 12.0), 4.0 * 5.0 / std::sqrt(2.0 * kTicks));
}

/// Applies only to robots with a battery, distributed or not, and not if the file sets the value.
TEST(RealismTest, AFootbotsMotorsDrawByLoad) {
  loadBuiltInPlugins();
  const auto stallOf = [](const std::string& realism, const std::string& values, bool is_distributed) {
    const std::string footbot =
        std::string("<footbot id='fb'>") + (is_distributed ? "" : "<position>1,1,0</position>") + values + "</footbot>";
    const std::string group =
        "<distribute quantity='2' layout='uniform'><minimum>0.5,0.5,0</minimum>"
        "<maximum>2,2,0</maximum>" +
        footbot + "</distribute>";
    const Experiment experiment =
        parseExperiment("<ahss-config><framework><clocktick>100</clocktick><maxclock>1</maxclock>" + realism +
                            "</framework><arena size='3,3,1' optimization='2D'>" + (is_distributed ? group : footbot) +
                            "</arena></ahss-config>",
                        "footbot.xml");
    Simulation simulation(experiment);
    simulation.start();
    const Space& space = simulation.space();
    const EntityModel& model = *space.entities.model[space.entities.find(is_distributed ? "fb_2" : "fb")];
    return model.battery ? model.battery->stall : -1.0;
  };
  const std::string battery = "<battery>true</battery>";
  for (const bool is_distributed : {false, true}) {
    EXPECT_EQ(stallOf(kTypical, battery, is_distributed), 20.0);
    EXPECT_EQ(stallOf(kTypical, battery + "<battery_stall>7</battery_stall>", is_distributed), 7.0);
    EXPECT_EQ(stallOf("", battery, is_distributed), 0.0);
    EXPECT_EQ(stallOf(kTypical, "", is_distributed), -1.0);
    EXPECT_EQ(stallOf(kTypical, "<battery>false</battery>", is_distributed), -1.0);
  }
}

/// Each installed preset alone must be valid for its devices.
TEST(RealismTest, AllInstalledPresetsAreAsTheirDevicesNeedThem) {
  loadBuiltInPlugins();
  const std::vector<RealismPreset> presets = realismPresets();
  ASSERT_FALSE(presets.empty());
  for (const RealismPreset& preset : presets) {
    if (preset.kind == PluginKind::kEntity) {
      EXPECT_EQ(preset.device, "footbot") << "AFootbotsMotorsDrawByLoad tests no other";
      continue;
    }
    const bool is_sensor = preset.kind == PluginKind::kSensor;
    const std::string section = is_sensor ? "sensors" : "actuators";
    const std::string text = "<ahss-config><framework><clocktick>100</clocktick><maxclock>1</maxclock><realism>" +
                             preset.name +
                             "</realism></framework><controllers><realism_idle id='c' library='swarmanoid_devices'><" +
                             section + "><" + preset.device + "/></" + section +
                             "></realism_idle></controllers><arena size='1,1,1' optimization='2D'/></ahss-config>";
    Experiment experiment;
    ASSERT_NO_THROW(experiment = parseExperiment(text, "preset.xml")) << preset.file;
    const ControllerDescription& controller = experiment.controllers.at(0);
    const DeviceDescription& device = (is_sensor ? controller.sensors : controller.actuators).at(0);
    const auto count = std::count(preset.content.begin(), preset.content.end(), '\n') + 1;
    EXPECT_GT(count, 0) << preset.file;
    EXPECT_EQ(device.errors.empty(), preset.content.find("<error") == std::string::npos) << preset.file;
    EXPECT_GT(preset.source.size(), 20U) << preset.file << " says where its numbers are from";
  }
}

}  // namespace
}  // namespace swarmanoid::test

REGISTER_CONTROLLER(swarmanoid::test::Idle, "realism_idle")
