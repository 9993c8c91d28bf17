// The panel with a running space, without a screen: effects of its buttons, and its display.
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <rviz/tool.h>
#include <pluginlib/class_loader.hpp>

#include <QApplication>
#include <QTest>
#include <chrono>
#include <functional>
#include <memory>

#include "../src/run_panel.hpp"
#include "fake_space.hpp"

namespace swarmanoid {
namespace {

using swarmanoid_msgs::Inspect;

/// Processes events of Qt and ROS until the condition is true. @return false after a timeout that is ample on any
/// machine
bool comesTrue(const std::function<bool()>& condition) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(30);
  while (!condition() && std::chrono::steady_clock::now() < deadline) {
    QCoreApplication::processEvents(QEventLoop::AllEvents, 10);
    ros::spinOnce();
  }
  return condition();
}

class RunPanelTest : public testing::Test {
 protected:
  RunPanelTest() {
    panel_.resize(300, 600);
    panel_.show();
    EXPECT_TRUE(comesTrue([&] { return the<QToolButton>("play")->isEnabled(); })) << shown("run");
    if (shown("run").rfind("running", 0) == 0) {
      click("play");
    }
    the<QLineEdit>("seed")->setText("1");
    click("reset");
    EXPECT_TRUE(comesTrue([&] { return tickIsZero(); }));
    the<QLineEdit>("seed")->clear();
  }

  template <class Widget>
  Widget* the(const char* name) {
    return panel_.findChild<Widget*>(name);
  }
  std::string shown(const char* label) { return the<QLabel>(label)->text().toStdString(); }
  bool tickIsZero() { return shown("run").rfind("paused, tick 0,", 0) == 0; }
  void click(const char* button) { QTest::mouseClick(the<QToolButton>(button), Qt::LeftButton); }
  void select(const char* name) {
    the<QLineEdit>("name")->setText(name);
    QTest::keyClick(the<QLineEdit>("name"), Qt::Key_Return);
  }
  std::string runStart(std::size_t length) { return shown("run").substr(0, length); }

  RunPanel panel_;
};

TEST_F(RunPanelTest, StepsAPausedRun) {
  the<QSpinBox>("ticks")->setValue(7);
  click("step");
  EXPECT_TRUE(comesTrue([&] { return runStart(15) == "paused, tick 7,"; })) << shown("run");
}

TEST_F(RunPanelTest, ResumesPausesAndPaces) {
  auto* pace = the<QComboBox>("pace");
  ASSERT_EQ("as fast as possible", pace->currentText().toStdString()) << "of space.launch";
  pace->setCurrentIndex(pace->findText("0.5 x real time"));
  Q_EMIT pace->activated(pace->currentIndex());
  ASSERT_TRUE(comesTrue([&] { return shown("answer") == "0.5 simulated seconds for each real one"; }));
  click("play");
  EXPECT_TRUE(comesTrue([&] { return runStart(7) == "running"; })) << shown("run");
  EXPECT_EQ("pause", the<QToolButton>("play")->toolTip().toStdString());
  EXPECT_FALSE(the<QToolButton>("step")->isEnabled());
  EXPECT_TRUE(comesTrue([&] { return shown("run").find("x real time") != std::string::npos; }));
  click("play");
  EXPECT_TRUE(comesTrue([&] { return runStart(6) == "paused"; })) << shown("run");
  EXPECT_EQ("0.5 x real time", pace->currentText().toStdString());
  pace->setCurrentIndex(pace->findText("as fast as possible"));
  Q_EMIT pace->activated(pace->currentIndex());
  EXPECT_TRUE(comesTrue([&] { return shown("answer") == "as fast as possible"; }));
}

TEST_F(RunPanelTest, ShowsWhatTheSelectedRobotPerceivesAndDoes) {
  select("fb_1");
  ASSERT_TRUE(comesTrue([&] { return shown("entity").rfind("footbot, moved by ground\n", 0) == 0; }))
      << shown("entity");
  EXPECT_NE(std::string::npos, shown("entity").find("controller fc, commanded by controller\nat "));
  auto* devices = the<DeviceTree>("devices");
  const auto found = devices->findItems("footbot_wheels", Qt::MatchExactly);
  ASSERT_EQ(1, found.size());
  ASSERT_EQ(2, found[0]->childCount());
  EXPECT_EQ("left", found[0]->child(0)->text(0).toStdString());
  EXPECT_EQ("0", found[0]->child(0)->text(1).toStdString());
  EXPECT_EQ("rad/s", found[0]->child(0)->text(2).toStdString());
  found[0]->setExpanded(true);
  click("step");
  EXPECT_TRUE(comesTrue([&] { return found[0]->child(0)->text(1) != "0"; })) << "its wheels stand still";
  found[0]->setExpanded(true);
  select("eb");
  EXPECT_TRUE(comesTrue([&] { return shown("entity").rfind("eyebot", 0) == 0; })) << shown("entity");
  EXPECT_TRUE(devices->findItems("footbot_wheels", Qt::MatchExactly).empty());
  select("fb_2");
  ASSERT_TRUE(comesTrue([&] { return devices->findItems("footbot_wheels", Qt::MatchExactly).size() == 1; }));
  EXPECT_TRUE(devices->findItems("footbot_wheels", Qt::MatchExactly)[0]->isExpanded()) << "what was opened stays open";
  select("fb_11");
  EXPECT_TRUE(comesTrue([&] { return shown("entity") == "there is no entity 'fb_11'; did you mean 'fb_1'?"; }))
      << shown("entity");
  EXPECT_EQ(0, devices->topLevelItemCount());
  select("");
  EXPECT_TRUE(comesTrue([&] { return shown("entity").empty(); })) << shown("entity");
}

TEST_F(RunPanelTest, ResetsWithAnotherSeedAndRefusesWhatIsNone) {
  the<QLineEdit>("seed")->setText("seven");
  click("reset");
  EXPECT_EQ("seed: found 'seven', allowed: a whole number from 0", shown("answer"));
  the<QLineEdit>("seed")->setText("7");
  click("reset");
  EXPECT_TRUE(comesTrue([&] { return shown("answer") == "reset, seed 7"; })) << shown("answer");
  the<QLineEdit>("seed")->setText("0");
  click("reset");
  EXPECT_TRUE(comesTrue([&] { return shown("answer") == "reset, seed 0"; })) << shown("answer");
}

TEST_F(RunPanelTest, FollowsTheTopicOfTheSelectedEntity) {
  ros::NodeHandle own("~");
  auto publisher = own.advertise<std_msgs::String>("selected_entity", 1, true);
  std_msgs::String message;
  message.data = "fb_2";
  publisher.publish(message);
  EXPECT_TRUE(comesTrue([&] { return the<QLineEdit>("name")->text() == "fb_2"; }));
  EXPECT_TRUE(comesTrue([&] { return shown("entity").rfind("footbot", 0) == 0; })) << shown("entity");
  message.data = "";
  publisher.publish(message);
  EXPECT_TRUE(comesTrue([&] { return the<QLineEdit>("name")->text().isEmpty(); }));
}

TEST(PluginsTest, RvizFindsPanelAndTool) {
  pluginlib::ClassLoader<rviz::Panel> panels("rviz", "rviz::Panel");
  const std::unique_ptr<rviz::Panel> panel(panels.createUnmanagedInstance("swarmanoid_rviz/Run"));
  EXPECT_NE(nullptr, panel->findChild<QToolButton*>("play"));
  pluginlib::ClassLoader<rviz::Tool> tools("rviz", "rviz::Tool");
  const std::unique_ptr<rviz::Tool> tool(tools.createUnmanagedInstance("swarmanoid_rviz/Move"));
  EXPECT_EQ('e', tool->getShortcutKey());
}

rviz::Config layoutWith(const char* space) {
  rviz::Config config;
  config.mapSetValue("Space", space);
  return config;
}

/// A panel for another space than the one started by roslaunch.
class RunPanelAloneTest : public testing::Test {
 protected:
  void open(const char* space) {
    panel_.load(layoutWith(space));
    panel_.show();
  }
  std::string shown(const char* label) { return panel_.findChild<QLabel*>(label)->text().toStdString(); }

  RunPanel panel_;
};

TEST_F(RunPanelAloneTest, ANameThatIsNoneIsRefused) {
  open("/space-2");
  EXPECT_TRUE(comesTrue([&] { return shown("run").find("/space-2/inspect") != std::string::npos; })) << shown("run");
}

TEST_F(RunPanelAloneTest, ALongStepIsPaused) {
  FakeSpace space;
  Inspect::Response state;
  state.success = 1;
  state.state = "stepping";
  state.tick = 12;
  state.stamp = ros::Time(2, 200'000'000);
  space.say(state);
  open("/fake");
  EXPECT_TRUE(comesTrue([&] { return shown("run").rfind("stepping, tick 12, 2.20 s", 0) == 0; })) << shown("run");
  auto* play = panel_.findChild<QToolButton*>("play");
  EXPECT_EQ("pause", play->toolTip().toStdString());
  QTest::mouseClick(play, Qt::LeftButton);
  EXPECT_TRUE(comesTrue([&] { return space.pauses() == 1; }));
}

TEST_F(RunPanelAloneTest, ASpaceThatIsBusySaysSoAndCanBePaused) {
  FakeSpace space;
  Inspect::Response state;
  state.state = "running";
  state.message = "busy in step of robot 'fb_1'";
  space.say(state);
  open("/fake");
  EXPECT_TRUE(comesTrue([&] { return shown("run") == "running: busy in step of robot 'fb_1'"; })) << shown("run");
  EXPECT_TRUE(panel_.findChild<QToolButton*>("play")->isEnabled());
}

TEST(RequestsTest, AnAnswerToWhoIsGoneComesToNobody) {
  FakeSpace space;
  int answers = 0;
  {
    Requests requests("/fake");
    requests.call<Inspect>("inspect", {}, [&](const Inspect::Response& /*state*/) { ++answers; });
    ASSERT_TRUE(comesTrue([&] { return answers == 1; }));
    requests.call<Inspect>("inspect", {}, [&](const Inspect::Response& /*state*/) { ++answers; });
  }  // the destructor waits for the answer and drops it
  comesTrue([count = 0]() mutable { return ++count > 30; });
  EXPECT_EQ(1, answers);
}

TEST(SelectionTest, WhoComesLateGetsTheNameThatWasChosenLast) {
  Selection first([] {});
  Selection second([] {});
  first.choose("a");
  ASSERT_TRUE(comesTrue([&] { return second.name() == "a"; }));
  second.choose("b");
  ASSERT_TRUE(comesTrue([&] { return first.name() == "b"; }));
  first.choose("c");
  ASSERT_TRUE(comesTrue([&] { return second.name() == "c"; }));
  ros::NodeHandle own("~");
  std::vector<std::string> heard;
  const auto subscriber = own.subscribe<std_msgs::String>(
      "selected_entity", 10, [&](const std_msgs::String::ConstPtr& message) { heard.push_back(message->data); });
  EXPECT_TRUE(comesTrue([&] { return !heard.empty(); }));
  comesTrue([count = 0]() mutable { return ++count > 10; });
  EXPECT_EQ(std::vector<std::string>{"c"}, heard);
}

TEST_F(RunPanelAloneTest, SaysThatThereIsNoSpace) {
  open("/nowhere");
  EXPECT_TRUE(comesTrue([&] { return shown("run") == "no answer from /nowhere/inspect"; })) << shown("run");
  EXPECT_FALSE(panel_.findChild<QToolButton*>("play")->isEnabled());
  rviz::Config saved;
  panel_.save(saved);
  QString space;
  EXPECT_TRUE(saved.mapGetString("Space", &space));
  EXPECT_EQ("/nowhere", space.toStdString());
}

}  // namespace
}  // namespace swarmanoid

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "panel_test");
  const ros::NodeHandle node;  // keeps ROS running
  const QApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
