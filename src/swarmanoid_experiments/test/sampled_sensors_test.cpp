// Tables of ideal sensors reproduce the ideal readings: at their points, and between them within bounds that are
// computed here. Also tables in experiment files and records.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <memory>

#include "../src/program/sample_world.hpp"
#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_experiment_files/samples/sample_table.hpp"
#include "swarmanoid_interface/process/temporary_folder.hpp"
#include "swarmanoid_recording/records/run_record.hpp"
#include "swarmanoid_space/experiment/experiment.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid::test {
namespace {

constexpr double kDegree = M_PI / 180.0;

struct Case {
  const char* device;
  const char* robot;
  std::size_t sensor;
  double first;
  double step;
  int count;          // of distances
  double angle_step;  // deg
  int angle_count;    // from 0
};

// The ideal sensors read nothing beyond their reach, where the largest distances end. Distances start in the measurable
// range, so that all readings are finite.
constexpr Case kCases[] = {{"proximity", "footbot", 5, 0.0, 0.1 / 17, 18, 37.0, 3},
                           {"footbot_proximity", "footbot", 11, 0.0, 0.1 / 17, 18, 37.0, 3},
                           {"distances", "handbot", 3, 0.13, 0.67 / 9, 10, 37.0, 3},
                           {"eyebot_distance", "eyebot", 17, 0.23, 1.27 / 9, 10, 37.0, 3},
                           {"handbot_distance", "handbot", 7, 0.05, 0.25 / 9, 10, 37.0, 3},
                           {"light", "footbot", 2, 0.27, 1.73 / 40, 41, 7.5, 12},
                           {"ground", "footbot", 1, 0.0, 0.05 / 7, 8, 29.0, 3},
                           {"footbot_ground", "footbot", 6, 0.0, 0.05 / 7, 8, 29.0, 3},
                           {"footbot_base_ground", "footbot", 2, 0.0, 0.05 / 7, 8, 29.0, 3}};

/// Maximum difference between the bilinear and the ideal reading, in the cell that starts at a distance: for each side,
/// a quarter of half the squared length times the largest second derivative along it.
double boundOf(const Case& tested, double distance) {
  const double rounding = 2e-7 * std::max(1.0, distance);  // readings are floats
  const std::string device = tested.device;
  if (device.find("proximity") != std::string::npos) {
    return rounding + 0.125 * std::pow(tested.step, 2) * 6.0 / std::pow(0.1, 2);  // for (1 - s / 0.1 m)^3
  }
  if (device == "light") {  // for cos(a) (0.1 m / s)^2
    const double along = 6.0 * 0.01 / std::pow(distance, 4);
    const double around = 0.01 / std::pow(distance, 2);
    return rounding + 0.125 * (std::pow(tested.step, 2) * along + std::pow(tested.angle_step * kDegree, 2) * around);
  }
  return rounding;  // linear, or constant
}

class SampledSensorsTest : public testing::TestWithParam<Case> {
 protected:
  SampledSensorsTest() { loadBuiltInPlugins(); }

  static std::shared_ptr<Sensor> make(const std::string& device) {
    return makePlugin<Sensor>(*Registry::instance().find(PluginKind::kSensor, device, "sampled"));
  }

  /// A sensor that follows the ideal law.
  static std::shared_ptr<Sensor> makeIdeal(const std::string& device) {
    Configuration parameters(device, "", {});
    for (const Parameter& parameter : Registry::instance().find(PluginKind::kSensor, device)->description.parameters) {
      parameters.set(parameter.name, *parameter.value);
    }
    auto sensor = make(device);
    dynamic_cast<SampledSensor&>(*sensor).configureIdeal(parameters);
    return sensor;
  }

  /// A sensor that reads from this table.
  std::shared_ptr<Sensor> makeSampled(const std::string& device, const std::vector<Sample>& samples) const {
    const std::string file = (folder_.path() / "table.csv").string();
    std::ofstream(file) << sampleTableText(samples, "of a test");
    Configuration parameters(device, "", {});
    parameters.set("file", file);
    auto sensor = make(device);
    sensor->configure(parameters);
    return sensor;
  }

  const TemporaryFolder folder_{"sampled_sensors_test"};
};

TEST_P(SampledSensorsTest, GiveIdealReadingsBack) {
  const Case& tested = GetParam();
  program::SampleWorld ideal(makeIdeal(tested.device), tested.robot, tested.sensor);
  std::vector<Sample> samples;
  for (int i = 0; i < tested.count; ++i) {
    for (int k = 0; k < tested.angle_count; ++k) {
      const double distance = i + 1 < tested.count ? tested.first + i * tested.step : ideal.reach();
      const double angle = k * tested.angle_step;
      samples.push_back({distance, angle, ideal.read(distance, angle * kDegree)});
      EXPECT_TRUE(std::isfinite(samples.back().reading)) << distance;
    }
  }
  program::SampleWorld sampled(makeSampled(tested.device, samples), tested.robot, tested.sensor);
  for (const Sample& sample : samples) {
    EXPECT_NEAR(sampled.read(sample.distance, sample.angle * kDegree), sample.reading, 1e-6)
        << sample.distance << " m, " << sample.angle << " degrees";
  }
  double largest = 0.0;
  for (int i = 0; i + 1 < tested.count; ++i) {
    for (const double part : {0.13, 0.5, 0.71}) {
      const double distance = tested.first + (i + part) * tested.step;
      for (const double angle : {0.0, 3.7, 41.3, 66.0}) {
        if (angle <= (tested.angle_count - 1) * tested.angle_step) {
          const double reading = ideal.read(distance, angle * kDegree);
          largest = std::max(largest, reading);
          EXPECT_NEAR(sampled.read(distance, angle * kDegree), reading, boundOf(tested, tested.first + i * tested.step))
              << distance << " m, " << angle << " degrees";
        }
      }
    }
  }
  EXPECT_GT(largest, 0.1) << "it felt something";
}

TEST_P(SampledSensorsTest, FeelNothingBeyondTheTable) {
  const Case& tested = GetParam();
  const double nothing = std::string(tested.device).find("dist") != std::string::npos ? kInfinity : 0.0;
  program::SampleWorld sampled(makeSampled(tested.device, {{0.02, 0.0, 0.75}, {0.04, 0.0, 0.25}}), tested.robot,
                               tested.sensor);
  EXPECT_NEAR(sampled.read(0.035, 0.0), 0.375, 1e-6);
  EXPECT_NEAR(sampled.read(0.035, 50.0 * kDegree), 0.375, 1e-6) << "whatever the angle";
  EXPECT_EQ(sampled.read(0.0401, 0.0), nothing);
}

INSTANTIATE_TEST_SUITE_P(Devices, SampledSensorsTest, testing::ValuesIn(kCases),
                         [](const auto& tested) { return tested.param.device; });

/// A footbot in front of a wall, and its table next to the experiment file.
class SampledExperimentTest : public testing::Test {
 protected:
  void SetUp() override {
    loadBuiltInPlugins();
    std::filesystem::create_directory(folder_.path() / "tables");
    write("tables/wall.csv", "distance,angle,reading\n0,0,0.9\n0,0,0.7\n0.2,0,0.1\n0.2,0,0.3\n");
  }

  void write(const std::string& name, const std::string& text) const { std::ofstream(folder_.path() / name) << text; }

  std::string file(const std::string& table) const {
    write("world.xml",
          "<ahss-config>\n<framework><clocktick>100</clocktick><maxclock>50</maxclock><random_seed>5</random_seed>\n"
          "</framework><controllers><diffusion id='dc' library='diffusion'><actuators><footbot_wheels/></actuators>\n"
          "<sensors><footbot_proximity><implementation>sampled</implementation>\n<file>" +
              table +
              "</file></footbot_proximity></sensors></diffusion></controllers>\n<arena size='3,3,1' optimization='2D' "
              "bounded='true'>"
              "<distribute quantity='30'><minimum>0.3,0.3,0</minimum><maximum>2.7,2.7,0</maximum>"
              "<footbot id='fb'><controller>dc</controller></footbot></distribute></arena>"
              "<engines><kinematics2d id='ground'/></engines><arena_physics><engine id='ground'><entity id='fb'/>"
              "</engine></arena_physics></ahss-config>");
    return (folder_.path() / "world.xml").string();
  }

  std::string refusalOf(const std::string& table) const {
    try {
      Simulation simulation(readExperiment(file(table)));
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "";
  }

  static std::uint64_t hashAfter(Experiment experiment) {
    Simulation simulation(std::move(experiment));
    simulation.start();
    for (int i = 0; i < 50; ++i) {
      simulation.tick();
    }
    return simulation.stateHash();
  }

  const TemporaryFolder folder_{"sampled_experiment_test"};
};

TEST_F(SampledExperimentTest, TheRecordHoldsTheTable) {
  const Experiment experiment = readExperiment(file("tables/wall.csv"));
  const RunRecord record = recordOf(experiment, "");
  ASSERT_EQ(record.files.size(), 1U);
  EXPECT_EQ(record.files[0].name, "files/1_wall.csv");
  EXPECT_EQ(record.files[0].content.substr(0, 30), "distance,angle,reading\n0,0,0.9");
  EXPECT_NE(record.text.find("<file>files/1_wall.csv</file>"), std::string::npos) << record.text;

  std::filesystem::create_directories(folder_.path() / "again/files");
  write("again/files/1_wall.csv", record.files[0].content);
  write("again/world.xml", record.text);
  const std::uint64_t expected = hashAfter(experiment);
  EXPECT_EQ(hashAfter(readExperiment((folder_.path() / "again/world.xml").string())), expected);
  write("tables/wall.csv", "distance,angle,reading\n0,0,0.2\n0.2,0,0\n");
  EXPECT_NE(hashAfter(readExperiment(file("tables/wall.csv"))), expected) << "the table counts";
}

TEST_F(SampledExperimentTest, FilesThatAreNotThereOrWrongAreRefused) {
  EXPECT_EQ(refusalOf("tables/wall.csv"), "");
  const std::string world = (folder_.path() / "world.xml").string();
  EXPECT_EQ(refusalOf("tables/none.csv"), world +
                                              ":5: file: found 'tables/none.csv', which is no file, allowed: the "
                                              "name of a file that is there");
  EXPECT_EQ(refusalOf("tables"), world +
                                     ":5: file: found 'tables', which is no file, allowed: the name of a file that "
                                     "is there");
  write("tables/wall.csv", "distance,angle,reading\n0,0,0.9\n0.2,0,3\n");
  EXPECT_EQ(refusalOf("tables/wall.csv"),
            (folder_.path() / "tables/wall.csv").string() + ":3: reading: found '3', allowed: a number from 0 to 1");
}

}  // namespace
}  // namespace swarmanoid::test
