#include "swarmanoid_interface/attachment_point.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <thread>

namespace swarmanoid {
namespace {

using std::chrono::milliseconds;

std::shared_ptr<AttachmentPoint> openWithTwo(const std::string& space) {
  return openAttachmentPoint(
      space, {{PluginKind::kEngine, "ground", "kinematics2d", {}}, {PluginKind::kController, "fc", "diffusion", {}}});
}

std::string messageOf(const std::function<void()>& call) {
  try {
    call();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(AttachmentPointTest, IsFoundByNameWhileSomebodyHoldsIt) {
  auto point = openWithTwo("/space");
  EXPECT_EQ(point, findAttachmentPoint("/space"));
  EXPECT_EQ(nullptr, findAttachmentPoint("/other"));
  point.reset();
  EXPECT_EQ(nullptr, findAttachmentPoint("/space"));
}

TEST(AttachmentPointTest, WaitsUntilTheLastPartIsThere) {
  const auto point = openWithTwo("/space");
  const auto part = std::make_shared<int>(7);
  std::thread nodelets([&] {
    point->attach(PluginKind::kController, "fc", std::make_shared<int>(8));
    std::this_thread::sleep_for(milliseconds(20));
    point->attach(PluginKind::kEngine, "ground", part);
  });
  EXPECT_NO_THROW(point->waitForAll(milliseconds(5000)));
  nodelets.join();
  EXPECT_EQ(part, point->part(PluginKind::kEngine, "ground"));
}

TEST(AttachmentPointTest, NamesWhoIsMissing) {
  const auto point = openWithTwo("/space");
  point->attach(PluginKind::kEngine, "ground", std::make_shared<int>(7));
  EXPECT_EQ("still missing after 0.02 s: controller 'fc'", messageOf([&] { point->waitForAll(milliseconds(20)); }));
}

TEST(AttachmentPointTest, PartsMayComeAndGoWhileItRuns) {
  const auto point = openWithTwo("/space");
  const auto part = std::make_shared<int>(7);
  EXPECT_NE("", messageOf([&] { point->attach(PluginKind::kObserver, "fb_9", part); }));
  point->expect({PluginKind::kObserver, "fb_9", "device_topics", {}});
  point->expect({PluginKind::kObserver, "fb_9", "something_else", {}});
  EXPECT_EQ("device_topics", point->request(PluginKind::kObserver, "fb_9").label);
  point->attach(PluginKind::kObserver, "fb_9", part);
  EXPECT_EQ(part, point->part(PluginKind::kObserver, "fb_9"));
  point->detach(PluginKind::kObserver, "fb_9");
  point->forget(PluginKind::kObserver, "fb_9");
  EXPECT_NE("", messageOf([&] { point->request(PluginKind::kObserver, "fb_9"); }));
  point->detach(PluginKind::kObserver, "fb_9");  // a late detach is allowed
}

TEST(AttachmentPointTest, NamesWhoWasRefusedAndWhy) {
  const auto point = openWithTwo("/space");
  point->refuse(PluginKind::kController, "fc", "its library is broken");
  EXPECT_EQ("controller 'fc' cannot take part: its library is broken",
            messageOf([&] { point->waitForAll(milliseconds(5000)); }));
}

TEST(AttachmentPointTest, TakesNothingTwiceAndNothingThatIsNotNeeded) {
  const auto point = openWithTwo("/space");
  point->attach(PluginKind::kEngine, "ground", std::make_shared<int>(7));
  EXPECT_EQ("engine 'ground' is attached already",
            messageOf([&] { point->attach(PluginKind::kEngine, "ground", std::make_shared<int>(7)); }));
  EXPECT_EQ("the experiment has no engine 'sky'; there are: controller 'fc', engine 'ground'",
            messageOf([&] { point->request(PluginKind::kEngine, "sky"); }));
}

TEST(AttachmentPointTest, DoesNotLoadAPartThatIsAttached) {
  const auto point = openWithTwo("/space");
  const AttachmentPoint::Request ground = point->request(PluginKind::kEngine, "ground");
  const AttachmentPoint::Request controller = point->request(PluginKind::kController, "fc");
  point->attach(PluginKind::kEngine, "ground", std::make_shared<int>(7));
  const auto fail = [](const AttachmentPoint::Request&) { return std::string("it does not load"); };
  EXPECT_TRUE(point->bring(ground, fail));
  // another nodelet attaches it during the load
  const auto be_late = [&](const AttachmentPoint::Request& part) {
    point->attach(part.kind, part.id, std::make_shared<int>(8));
    return messageOf([&] { point->attach(part.kind, part.id, std::make_shared<int>(9)); });
  };
  EXPECT_TRUE(point->bring(controller, be_late));
  EXPECT_NO_THROW(point->waitForAll(milliseconds(0)));
}

TEST(AttachmentPointTest, WhatCannotBeBroughtEndsTheWaiting) {
  const auto point = openWithTwo("/space");
  EXPECT_FALSE(point->bring(point->request(PluginKind::kEngine, "ground"),
                            [](const AttachmentPoint::Request& part) { return part.id + " does not load"; }));
  EXPECT_EQ("engine 'ground' cannot take part: ground does not load",
            messageOf([&] { point->waitForAll(milliseconds(5000)); }));
}

TEST(AttachmentPointTest, KeepsAPartUntilTheSpaceHasStoppedUsingIt) {
  const auto point = openWithTwo("/space");
  point->attach(PluginKind::kEngine, "ground", std::make_shared<int>(7));
  std::string lost;
  std::shared_ptr<void> seen_by_handler;
  point->setLossHandler([&](PluginKind kind, const std::string& id) {
    lost = std::string(toString(kind)) + " " + id;
    seen_by_handler = point->part(PluginKind::kEngine, "ground");
  });
  point->detach(PluginKind::kEngine, "ground");
  EXPECT_EQ("engine ground", lost);
  EXPECT_NE(nullptr, seen_by_handler);
  EXPECT_EQ(nullptr, point->part(PluginKind::kEngine, "ground"));
}

TEST(AttachmentPointTest, DetachingWhatIsNotThereTellsNobody) {
  const auto point = openWithTwo("/space");
  bool is_reported = false;
  point->setLossHandler([&](PluginKind, const std::string&) { is_reported = true; });
  point->detach(PluginKind::kEngine, "ground");
  EXPECT_FALSE(is_reported);
}

}  // namespace
}  // namespace swarmanoid
