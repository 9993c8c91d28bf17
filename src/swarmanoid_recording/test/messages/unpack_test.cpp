// Extracts the record of a run from a bag: the chosen run, its files, hashes, interventions and result.
#include "../../src/unpack/unpack.hpp"

#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <std_msgs/String.h>
#include <swarmanoid_msgs/Intervention.h>
#include <swarmanoid_msgs/RunRecord.h>
#include <swarmanoid_msgs/RunResult.h>
#include <swarmanoid_msgs/WorldState.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/process/temporary_folder.hpp"

namespace swarmanoid::unpack {
namespace {

namespace fs = std::filesystem;

class UnpackTest : public testing::Test {
 protected:
  UnpackTest() { bag.open(file, rosbag::bagmode::Write); }

  void writeState(double time, std::uint64_t run, std::uint64_t tick, std::uint64_t hash) {
    swarmanoid_msgs::WorldState message;
    message.run = run;
    message.tick = tick;
    message.state_hash = hash;
    bag.write("/space/world_state", ros::Time(time), message);
  }
  void writeRecord(double time, std::uint64_t run, const std::string& name, const std::string& content) {
    swarmanoid_msgs::RunRecord message;
    message.run = run;
    message.files.resize(1);
    message.files[0].name = name;
    message.files[0].content.assign(content.begin(), content.end());
    bag.write("/space/record", ros::Time(time), message);
  }
  void writeIntervention(double time, std::uint64_t run, const std::string& text) {
    swarmanoid_msgs::Intervention message;
    message.run = run;
    message.text = text;
    bag.write("/space/interventions", ros::Time(time), message);
  }

  std::string refusal(const Choice& choice = {}) {
    bag.close();
    try {
      unpack(file, folder, choice);
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "";
  }

  std::string text(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(fs::path(folder) / name).rdbuf();
    return text.str();
  }

  const TemporaryFolder owner{"unpack_test"};
  const TemporaryFolder target{"unpack_test_record"};
  const std::string file = owner.path() / "run.bag";
  const std::string folder = target.path();
  rosbag::Bag bag;
};

TEST_F(UnpackTest, TheLastRunThatMadeATickIsTakenWhole) {
  writeRecord(1.0, 0, "record.xml", "first");
  writeState(1.0, 0, 0, 17);
  writeState(1.1, 0, 1, 18);
  writeRecord(1.3, 1, "files/1_a.png", std::string("a\0b", 3));
  writeState(1.3, 1, 0, 255);
  writeState(1.4, 1, 1, 0xfedcba9876543210U);
  writeIntervention(1.4, 1, "<delete tick=\"0\" entity=\"b\"/>\n");
  writeIntervention(1.4, 1, "<delete tick=\"0\" entity=\"a\"/>\n");
  swarmanoid_msgs::RunResult result;
  result.run = 1;
  result.experiment = "a & \"b\"";
  result.seed = 18446744073709551615U;
  result.ticks = 1;
  result.finished = true;
  bag.write("/space/result", ros::Time(1.4), result);
  writeRecord(1.6, 2, "record.xml", "third");
  writeState(1.6, 2, 0, 19);
  EXPECT_EQ(refusal(), "");
  EXPECT_EQ(text("files/1_a.png"), std::string("a\0b", 3));
  EXPECT_EQ(text("hashes.txt"), "0 00000000000000ff\n1 fedcba9876543210\n");
  EXPECT_EQ(text("interventions.xml"),
            "<interventions experiment=\"a &amp; &quot;b&quot;\" seed=\"18446744073709551615\">\n"
            "<delete tick=\"0\" entity=\"b\"/>\n<delete tick=\"0\" entity=\"a\"/>\n</interventions>\n");
  EXPECT_EQ(text("result.json"), "{\"seed\":18446744073709551615,\"ticks\":1,\"finished\":true}\n");
  EXPECT_FALSE(fs::exists(fs::path(folder) / "record.xml"));
}

TEST_F(UnpackTest, AnotherRunIsTakenIfItIsNamed) {
  writeRecord(1.0, 0, "record.xml", "first");
  writeState(1.0, 0, 0, 17);
  writeRecord(1.3, 1, "record.xml", "second");
  writeState(1.4, 1, 1, 18);
  Choice choice;
  choice.run = 0;
  EXPECT_EQ(refusal(choice), "");
  EXPECT_EQ(text("record.xml"), "first");
  EXPECT_FALSE(fs::exists(fs::path(folder) / "result.json"));
  choice.run = 7;
  EXPECT_EQ(refusal(choice), file + ": found no run 7, allowed: 0, 1");
}

TEST_F(UnpackTest, ABagWithoutARecordHasInterventionsAllTheSame) {
  writeState(1.0, 0, 0, 17);
  writeState(1.1, 0, 1, 18);
  writeIntervention(1.1, 0, "<delete tick=\"0\" entity=\"a\"/>\n");
  Choice choice;
  choice.only_interventions = true;
  EXPECT_EQ(refusal(choice), "");
  EXPECT_EQ(text("interventions.xml"), "<interventions>\n<delete tick=\"0\" entity=\"a\"/>\n</interventions>\n");
  EXPECT_EQ(refusal(),
            file + ": found no record of the run, allowed: a bag that this version of the suite has recorded");
}

TEST_F(UnpackTest, NamesLeadNowhereButIntoTheFolder) {
  writeRecord(1.0, 0, "../" + target.path().filename().string() + "_evil", "x");
  writeState(1.1, 0, 1, 18);
  EXPECT_EQ(refusal(), file + ": found a file '../" + target.path().filename().string() +
                           "_evil' in the record, allowed: a name inside the record");
}

TEST_F(UnpackTest, BagsOfTwoSpacesAndOthersAreRefused) {
  writeState(1.0, 0, 1, 17);
  bag.write("/other/world_state", ros::Time(1.0), swarmanoid_msgs::WorldState());
  EXPECT_EQ(refusal(), file +
                           ": found swarmanoid_msgs/WorldState on /other/world_state, /space/world_state, allowed: a "
                           "bag of one space");
}

TEST_F(UnpackTest, ABagWithoutAStateIsRefused) {
  bag.write("/chatter", ros::Time(1.0), std_msgs::String());
  EXPECT_EQ(refusal(),
            file + ": found no run that made a tick, allowed: a bag of `swarmanoid run --bag`, or of the space");
}

}  // namespace
}  // namespace swarmanoid::unpack
