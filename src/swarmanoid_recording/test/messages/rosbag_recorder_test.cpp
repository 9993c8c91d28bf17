// A recorded run: every state is in the bag, in simulated time, without a master.
#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <rosgraph_msgs/Clock.h>
#include <std_msgs/String.h>
#include <swarmanoid_msgs/Intervention.h>
#include <swarmanoid_msgs/RunRecord.h>
#include <swarmanoid_msgs/WorldState.h>
#include <tf2_msgs/TFMessage.h>

#include <filesystem>

#include "swarmanoid_experiment_files/testing/small_world.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "swarmanoid_interface/process/math_library.hpp"
#include "swarmanoid_interface/process/temporary_folder.hpp"
#include "swarmanoid_recording/output/out_folder.hpp"

namespace swarmanoid {
namespace {

class RosbagRecorderTest : public testing::Test {
 protected:
  void SetUp() override { loadPluginLibrary("swarmanoid_recording", {}, {}); }

  void record(Simulation& simulation, const std::string& every = "1") {
    auto recorder = makePlugin<Observer>(*Registry::instance().find(PluginKind::kObserver, "rosbag_recorder"));
    Configuration parameters("rosbag_recorder", "", {});
    parameters.set("file", "run.bag");
    parameters.set("every", every);
    RunContext context;
    context.out = std::make_shared<OutFolder>(folder_.string(), "--", OutFolder::Rules{});
    context.experiment = &simulation.experiment();
    recorder->configure("recorder", parameters, context);
    simulation.addObserver(recorder);
    context.out->keep();
  }

  template <class Message>
  std::vector<typename Message::ConstPtr> read(const std::string& topic) const {
    rosbag::Bag bag((folder_ / "run.bag").string(), rosbag::bagmode::Read);
    rosbag::View view(bag, rosbag::TopicQuery(topic));
    std::vector<typename Message::ConstPtr> messages;
    for (const rosbag::MessageInstance& instance : view) {
      messages.push_back(instance.instantiate<Message>());
    }
    return messages;
  }

  const TemporaryFolder owner_{"rosbag_recorder_test"};
  const std::filesystem::path& folder_ = owner_.path();
};

void runToEnd(Simulation& simulation) {
  while (!simulation.isFinished()) {
    simulation.tick();
  }
}

TEST_F(RosbagRecorderTest, HoldsEveryTick) {
  const auto simulation = test::smallWorld(50);
  record(*simulation);
  simulation->start();
  runToEnd(*simulation);
  simulation->finish();

  const auto states = read<swarmanoid_msgs::WorldState>("/space/world_state");
  ASSERT_EQ(51U, states.size());
  for (std::size_t i = 0; i < states.size(); ++i) {
    EXPECT_EQ(i, states[i]->tick);
  }
  EXPECT_EQ(simulation->stateHash(), states.back()->state_hash);
  EXPECT_EQ(51U, read<rosgraph_msgs::Clock>("/clock").size());
  EXPECT_EQ(51U, read<tf2_msgs::TFMessage>("/tf").size());
  EXPECT_EQ(1U, read<tf2_msgs::TFMessage>("/tf_static").size());
}

TEST_F(RosbagRecorderTest, BagTimeIsSimulatedTime) {
  const auto simulation = test::smallWorld(10);
  record(*simulation);
  simulation->start();
  runToEnd(*simulation);
  simulation->finish();
  rosbag::Bag bag((folder_ / "run.bag").string(), rosbag::bagmode::Read);
  rosbag::View view(bag);
  EXPECT_EQ(ros::Time(1, 0), view.getBeginTime());
  EXPECT_EQ(ros::Time(2, 0), view.getEndTime());
}

TEST_F(RosbagRecorderTest, SaysWhichMathematicsTheRunWasCalculatedWith) {
  const auto simulation = test::smallWorld(1);
  record(*simulation);
  simulation->start();
  runToEnd(*simulation);
  simulation->finish();
  const auto texts = read<std_msgs::String>("/space/math_library");
  ASSERT_EQ(1U, texts.size());
  EXPECT_EQ(mathLibrary(), texts[0]->data);
}

TEST_F(RosbagRecorderTest, HoldsWhatWasDoneToTheRunWhateverTheTicksThatItRecords) {
  const auto simulation = test::smallWorld(10);
  record(*simulation, "5");
  simulation->start();
  simulation->tick();
  simulation->apply(DeleteEntity{"prey"});
  simulation->apply(MoveEntity{"fb_1", {{4.0, 1.0, 0.0}, Eigen::Quaterniond::Identity()}});
  runToEnd(*simulation);
  simulation->finish();
  const auto messages = read<swarmanoid_msgs::Intervention>("/space/interventions");
  ASSERT_EQ(2U, messages.size());
  EXPECT_EQ("delete", messages[0]->kind);
  EXPECT_EQ(1U, messages[0]->tick);
  EXPECT_EQ(0U, messages[0]->run);
  EXPECT_EQ("", messages[0]->by);
  EXPECT_EQ("<delete tick=\"1\" entity=\"prey\"/>\n", messages[0]->text);
  EXPECT_EQ(ros::Time(1, 200000000), messages[0]->header.stamp);  // the run begins at 1 s; end of tick 1
  EXPECT_EQ("move", messages[1]->kind);
  EXPECT_EQ(0U, messages[1]->text.rfind("<move tick=\"1\" entity=\"fb_1\">\n", 0));
}

TEST_F(RosbagRecorderTest, RecordsEverySoManyTicks) {
  const auto simulation = test::smallWorld(50);
  record(*simulation, "10");
  simulation->start();
  runToEnd(*simulation);
  simulation->finish();
  EXPECT_EQ(6U, read<swarmanoid_msgs::WorldState>("/space/world_state").size());
}

TEST_F(RosbagRecorderTest, GoesOnAfterAReset) {
  const auto simulation = test::smallWorld(10);
  record(*simulation);
  simulation->start();
  runToEnd(*simulation);
  simulation->finish();
  simulation->reset(18446744073709551615U);
  runToEnd(*simulation);
  simulation->finish();
  const auto states = read<swarmanoid_msgs::WorldState>("/space/world_state");
  ASSERT_EQ(22U, states.size());
  EXPECT_EQ(1U, states.back()->run);
  EXPECT_GT(states[11]->header.stamp, states[10]->header.stamp);
  const auto records = read<swarmanoid_msgs::RunRecord>("/space/record");
  ASSERT_EQ(2U, records.size()) << "one a run";
  EXPECT_EQ(1U, records[1]->run);
  ASSERT_EQ(2U, records[1]->files.size());
  EXPECT_EQ("record.xml", records[1]->files[0].name);
  const auto& content = records[1]->files[0].content;
  EXPECT_NE(std::string(content.begin(), content.end()).find("seed=\"18446744073709551615\""), std::string::npos);
  EXPECT_EQ("experiment.xml", records[1]->files[1].name);
}

TEST_F(RosbagRecorderTest, SaysWhenItCannotWrite) {
  const auto simulation = test::smallWorld(10);
  std::filesystem::create_directory(folder_ / "run.bag");
  EXPECT_THROW(record(*simulation), ConfigError);
}

}  // namespace
}  // namespace swarmanoid
