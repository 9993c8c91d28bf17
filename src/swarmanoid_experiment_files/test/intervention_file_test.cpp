// Files of interventions: written interventions are read back bit by bit.
#include "swarmanoid_experiment_files/interventions/intervention_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "swarmanoid_experiment_files/testing/intervention_texts.hpp"
#include "swarmanoid_interface/orientation.hpp"

namespace swarmanoid {
namespace {

using test::fileOf;
using test::namedParts;

/// Writes an intervention and reads it back.
TakenIntervention throughAFile(const TakenIntervention& taken) {
  const std::string text = interventionsBegin("small_world", 7) + toXml(taken, 1) + interventionsEnd();
  const InterventionFile file = parseInterventions(text, "test.xml", namedParts());
  EXPECT_EQ(file.experiment, "small_world");
  EXPECT_EQ(file.seed, "7");
  EXPECT_EQ(file.interventions.size(), 1U) << text;
  const TakenIntervention& read = file.interventions.front().taken;
  EXPECT_EQ(read.what.index(), taken.what.index());
  EXPECT_EQ(read.tick, taken.tick);
  EXPECT_EQ(read.asked_by, taken.asked_by);
  EXPECT_EQ(read.after_rules, taken.after_rules);
  return read;
}

template <class What>
What throughAFile(const What& what) {
  return std::get<What>(throughAFile(TakenIntervention{what, "", 3, false}).what);
}

/// Compares bits: -0 differs from 0.
template <class Numbers>
bool areSameBits(const Numbers& a, const Numbers& b) {
  return std::memcmp(a.data(), b.data(), sizeof(double) * static_cast<std::size_t>(a.size())) == 0;
}

constexpr double kTiny = std::numeric_limits<double>::denorm_min();
const double kAwkward = std::nextafter(0.1, 1.0);

EntityDescription footbotAt(const Eigen::Vector3d& position, const Eigen::Vector3d& angles) {
  EntityDescription entity;
  entity.type = "footbot";
  entity.id = "late";
  entity.position = position;
  entity.angles = angles;
  return entity;
}

TEST(InterventionFileTest, ASpawnHasPlaceAndAnglesToTheLastBit) {
  for (const Eigen::Vector3d& angles :
       {Eigen::Vector3d(M_PI, -M_PI / 2.0, std::nextafter(M_PI, 0.0)), Eigen::Vector3d(-0.0, kTiny, 1.0 / 3.0),
        Eigen::Vector3d(1e17, -1e-300, kAwkward)}) {
    const SpawnEntity spawn{footbotAt({2.0 / 3.0, kAwkward, -0.0}, angles), {"ground", "air"}};
    const SpawnEntity read = throughAFile(spawn);
    EXPECT_TRUE(areSameBits(read.entity.position, spawn.entity.position));
    EXPECT_TRUE(areSameBits(read.entity.angles, spawn.entity.angles));
    EXPECT_EQ(read.engines, spawn.engines);
    EXPECT_EQ(read.entity.id, "late");
    EXPECT_EQ(read.entity.type, "footbot");
  }
}

TEST(InterventionFileTest, ASpawnHasItsControllerAndWhoCommandsIt) {
  SpawnEntity spawn{footbotAt({1, 1, 0}, {0, 0, 0}), {}};
  spawn.entity.controller = "drive";
  EXPECT_EQ(throughAFile(spawn).entity.controller, "drive");
  EXPECT_EQ(throughAFile(spawn).entity.source, CommandSource::kController);
  spawn.entity.source = CommandSource::kTopics;
  EXPECT_EQ(throughAFile(spawn).entity.command_timeout, kCommandTimeout);
  for (const std::int64_t timeout : {1000001L, 300000000L, 1234567891L, 3599999999999L}) {
    spawn.entity.command_timeout = std::chrono::nanoseconds(timeout);
    EXPECT_EQ(throughAFile(spawn).entity.command_timeout, spawn.entity.command_timeout);
    EXPECT_EQ(throughAFile(spawn).entity.source, CommandSource::kTopics);
  }
}

TEST(InterventionFileTest, ASpawnHasTheValuesOfItsTypeAndItsColour) {
  SpawnEntity prey{footbotAt({1, 1, 0}, {0, 0, 0}), {}};
  prey.entity.type = "cylindric_prey";
  prey.entity.parameters.set("radius", "0.10000000000000002");
  prey.entity.parameters.set("height", "0.1");
  prey.entity.parameters.set("color", "blue");
  for (const Color color : {colors::kBlue, colors::kBlack, Color{1, 2, 3}}) {
    prey.entity.color = color;
    const EntityDescription read = throughAFile(prey).entity;
    EXPECT_EQ(read.color, color);
    EXPECT_EQ(read.parameters.number("radius"), kAwkward);
    EXPECT_EQ(read.parameters.text("color"), "blue");
  }
  SpawnEntity painted{footbotAt({1, 1, 0}, {0, 0, 0}), {}};
  EXPECT_EQ(throughAFile(painted).entity.color, colors::kBlack);
  painted.entity.color = {9, 8, 7};
  EXPECT_EQ(throughAFile(painted).entity.color, (Color{9, 8, 7}));
}

TEST(InterventionFileTest, AMoveHasItsQuaternionToTheLastBitNormalisedOrNot) {
  for (const Eigen::Quaterniond& q : {Eigen::Quaterniond(kAwkward, -0.0, kTiny, 1.0 / 3.0),
                                      Eigen::Quaterniond(2, -3e10, 5e-10, 0), orientationFromAngles({0.1, 0.2, 0.3})}) {
    const MoveEntity read = throughAFile(MoveEntity{"fb_1", {{-0.0, 2.0 / 3.0, kTiny}, q}});
    EXPECT_EQ(read.entity, "fb_1");
    EXPECT_TRUE(areSameBits(read.pose.orientation.coeffs(), q.coeffs()));
    EXPECT_TRUE(areSameBits(read.pose.position, Eigen::Vector3d(-0.0, 2.0 / 3.0, kTiny)));
  }
}

TEST(InterventionFileTest, TheOtherKindsHaveTheirWords) {
  EXPECT_EQ(throughAFile(DeleteEntity{"prey"}).entity, "prey");
  EXPECT_EQ(throughAFile(HandOverEntity{"prey", "air"}).entity, "prey");
  EXPECT_EQ(throughAFile(HandOverEntity{"prey", "air"}).engine, "air");
  const NamedValues values{{"gravity", "1e-3"}, {"friction", "0.10000000000000002"}, {"text", "a < \"b\" & 'c'"}};
  EXPECT_EQ(throughAFile(SetEngineParameters{"ground", values}).engine, "ground");
  EXPECT_EQ(throughAFile(SetEngineParameters{"ground", values}).values, values);
  for (const CommandSource source :
       {CommandSource::kController, CommandSource::kRemote, CommandSource::kTopics, CommandSource::kNone}) {
    EXPECT_EQ(throughAFile(SetCommandSource{"fb_1", source}).source, source);
    EXPECT_EQ(throughAFile(SetCommandSource{"fb_1", source}).robot, "fb_1");
  }
  const SetProperty property = throughAFile(SetProperty{"lamp", "intensity", "0.30000000000000004"});
  EXPECT_EQ(property.entity, "lamp");
  EXPECT_EQ(property.property, "intensity");
  EXPECT_EQ(property.value, "0.30000000000000004");
}

TEST(InterventionFileTest, PaintHasItsDiscsToTheLastBit) {
  const PaintFloor paint{
      {{{2.0 / 3.0, kAwkward}, 0.30000000000000004, colors::kRed, 1.0 / 3.0}, {{0.0, 5.0}, 0.0, {1, 2, 3}, 1.0}}};
  const PaintFloor read = throughAFile(paint);
  ASSERT_EQ(read.discs.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_TRUE(areSameBits(read.discs[i].position, paint.discs[i].position));
    EXPECT_EQ(read.discs[i].radius, paint.discs[i].radius);
    EXPECT_EQ(read.discs[i].color, paint.discs[i].color);
    EXPECT_EQ(read.discs[i].strength, paint.discs[i].strength);
  }
  EXPECT_EQ(toXml({PaintFloor{{paint.discs[1]}}, "", 3, false}, 1),
            "  <paint tick=\"3\">\n    <disc position=\"0, 5\" radius=\"0\" color=\"1,2,3\" strength=\"1\"/>\n"
            "  </paint>\n");
}

TEST(InterventionFileTest, AFaultHasItsErrorsInTheirOrder) {
  SetFault fault{"fb_1", "footbot_proximity", {}};
  EXPECT_EQ(throughAFile(fault).robot, "fb_1");
  EXPECT_EQ(throughAFile(fault).device, "footbot_proximity");
  EXPECT_TRUE(throughAFile(fault).errors.empty());
  fault.errors.resize(2);
  fault.errors[0].kind = "stuck";
  fault.errors[0].field = "value[3]";
  fault.errors[0].from_tick = 999999999999999;
  fault.errors[1].kind = "factor";
  fault.errors[1].parameters.set("mean", "1");
  fault.errors[1].parameters.set("deviation", "0.10000000000000002");
  const std::vector<ErrorModelDescription> read = throughAFile(fault).errors;
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].kind, "stuck");
  EXPECT_EQ(read[0].field, "value[3]");
  EXPECT_EQ(read[0].from_tick, 999999999999999U);
  EXPECT_EQ(read[1].kind, "factor");
  EXPECT_EQ(read[1].field, "");
  EXPECT_EQ(read[1].parameters.number("mean"), 1.0);
  EXPECT_EQ(read[1].parameters.number("deviation"), kAwkward);
  EXPECT_EQ(toXml({fault, "", 5, false}),
            "<fault tick=\"5\" robot=\"fb_1\" device=\"footbot_proximity\">\n"
            "  <error kind=\"stuck\" field=\"value[3]\" from_tick=\"999999999999999\"/>\n"
            "  <error kind=\"factor\" deviation=\"0.10000000000000002\"/>\n"
            "</fault>\n");
}

TEST(InterventionFileTest, OfAValueThatIsSetTwiceTheLastOneStaysThere) {
  const SetEngineParameters twice{"ground", {{"gravity", "1"}, {"friction", "2"}, {"gravity", "3"}}};
  const std::string text = interventionsBegin("x", 0) + toXml({twice, "", 0, false}) + interventionsEnd();
  const InterventionFile file = parseInterventions(text, "test.xml", namedParts());
  EXPECT_EQ(std::get<SetEngineParameters>(file.interventions.front().taken.what).values,
            (NamedValues{{"friction", "2"}, {"gravity", "3"}}));
}

TEST(InterventionFileTest, WhoAskedAndWhenIsInEachElement) {
  EXPECT_EQ(toXml({DeleteEntity{"prey"}, "rule 'a & b'", 12, true}),
            "<delete tick=\"12\" after_rules=\"true\" by=\"rule 'a &amp; b'\" entity=\"prey\"/>\n");
  throughAFile(TakenIntervention{DeleteEntity{"prey"}, "rule 'a & b'", 999999999999999, true});
}

TEST(InterventionFileTest, LooksAsOnThePage) {
  SpawnEntity spawn{footbotAt({1.5, 2, 0}, {0, 0, 0.5}), {"ground", "air"}};
  spawn.entity.controller = "drive";
  EXPECT_EQ(toXml({spawn, "", 2, false}, 1),
            "  <spawn tick=\"2\" engines=\"ground air\">\n    <footbot id=\"late\">\n"
            "      <position>1.5, 2, 0</position>\n      <angles>0, 0, 0.5</angles>\n"
            "      <controller>drive</controller>\n    </footbot>\n  </spawn>\n");
  EXPECT_EQ(toXml({MoveEntity{"prey", {{1, 2, 0}, Eigen::Quaterniond::Identity()}}, "", 3, false}, 1),
            "  <move tick=\"3\" entity=\"prey\">\n    <position>1, 2, 0</position>\n"
            "    <quaternion>1, 0, 0, 0</quaternion>\n  </move>\n");
}

TEST(InterventionFileTest, PeopleMayWriteDegreesAsInExperimentFiles) {
  const InterventionFile file = parseInterventions(
      fileOf("<spawn tick='1'><eyebot id='e'><position>1,1,1</position><orientation>0, 0, 90</orientation></eyebot>"
             "</spawn><move tick='1' entity='e'><position>1,1,1</position><orientation>0, 0, 180</orientation></move>"),
      "test.xml", namedParts());
  ASSERT_EQ(file.interventions.size(), 2U);
  EXPECT_NEAR(std::get<SpawnEntity>(file.interventions[0].taken.what).entity.angles.z(), M_PI / 2.0, 1e-15);
  EXPECT_NEAR(std::get<MoveEntity>(file.interventions[1].taken.what).pose.orientation.z(), 1.0, 1e-15);
}

}  // namespace
}  // namespace swarmanoid
