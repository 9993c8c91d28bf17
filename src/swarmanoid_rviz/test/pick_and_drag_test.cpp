// Pick and drag with a fake space that answers on demand of the test: late, in another order, or with an error.
#include "../src/pick_and_drag.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace swarmanoid {
namespace {

using Inspect = PickAndDrag::Inspect;
using Move = PickAndDrag::Move;

constexpr double kPixel = 0.01;  // [m], of a camera that looks straight down

/// Fake window and space; stores requests until the test answers them.
struct Stage {
  struct Question {
    Inspect::Request request;
    std::function<void(const Inspect::Response&)> then;
  };
  std::vector<Question> asked;
  std::vector<Move::Request> moves;
  std::function<void(const Move::Response&)> moved;
  std::string selected = "-";
  std::string said;
  std::optional<geometry_msgs::Pose> shown;
  bool is_floor_in_sight = true;
  PickAndDrag pick{surroundings()};

  PickAndDrag::Surroundings surroundings() {
    PickAndDrag::Surroundings result;
    result.pointAt = [this](int x, int y, double height) {
      return is_floor_in_sight ? std::optional<geometry_msgs::Point>(at(x, y, height)) : std::nullopt;
    };
    result.inspect = [this](const Inspect::Request& request, auto then) { asked.push_back({request, then}); };
    result.move = [this](const Move::Request& request, auto then) {
      moves.push_back(request);
      moved = then;
    };
    result.select = [this](const std::string& name) { selected = name; };
    result.say = [this](const std::string& message) { said = message; };
    result.preview = [this](const geometry_msgs::Pose* pose) {
      shown = pose == nullptr ? std::nullopt : std::optional<geometry_msgs::Pose>(*pose);
    };
    return result;
  }

  static geometry_msgs::Point at(int x, int y, double height) {
    geometry_msgs::Point point;
    point.x = x * kPixel;
    point.y = y * kPixel;
    point.z = height;
    return point;
  }
  void press(int x, int y) { pick.press(x, y, at(x, y, 0.1)); }
  void answer(std::size_t question, const std::string& name, double x = 0.0, double y = 0.0) {
    Inspect::Response response;
    response.success = 1;
    response.name = name;
    response.pose.position = at(0, 0, 0.3);
    response.pose.position.x = x;
    response.pose.position.y = y;
    response.pose.orientation.w = 1.0;
    asked.at(question).then(response);
  }
};

TEST(PickAndDragTest, AClickSelects) {
  Stage stage;
  stage.press(100, 200);
  EXPECT_EQ(1.0, stage.asked.at(0).request.near.x);
  EXPECT_EQ(PickAndDrag::kReach, stage.asked[0].request.within);
  stage.pick.release(100, 200, false);
  stage.answer(0, "fb_1", 1.02, 2.0);
  EXPECT_EQ("fb_1", stage.selected);
  EXPECT_EQ("fb_1", stage.said);
  EXPECT_EQ(1U, stage.asked.size()) << "nothing is moved";
}

TEST(PickAndDragTest, ADragMovesByWhatThePointerHasGone) {
  Stage stage;
  stage.press(100, 200);
  stage.answer(0, "fb_1", 1.02, 2.03);
  EXPECT_FALSE(stage.shown);
  stage.pick.follow(150, 180, false);
  ASSERT_TRUE(stage.shown);
  EXPECT_NEAR(1.52, stage.shown->position.x, 1e-12);
  EXPECT_NEAR(1.83, stage.shown->position.y, 1e-12);
  stage.pick.release(160, 180, false);
  EXPECT_FALSE(stage.shown);
  ASSERT_EQ(2U, stage.asked.size());
  EXPECT_EQ("fb_1", stage.asked[1].request.name) << "where is it now?";
  stage.answer(1, "fb_1", 1.3, 2.1);
  ASSERT_EQ(1U, stage.moves.size());
  EXPECT_EQ("fb_1", stage.moves[0].entities[0].name);
  EXPECT_NEAR(1.62, stage.moves[0].entities[0].pose.pose.position.x, 1e-12);
  EXPECT_NEAR(1.83, stage.moves[0].entities[0].pose.pose.position.y, 1e-12);
  EXPECT_DOUBLE_EQ(0.3, stage.moves[0].entities[0].pose.pose.position.z);
  Move::Response refused;
  refused.message = "overlaps 'wall'";
  stage.moved(refused);
  EXPECT_EQ("overlaps 'wall'", stage.said);
}

TEST(PickAndDragTest, AHandThatIsFasterThanTheSpaceLosesNothing) {
  Stage stage;
  stage.press(100, 200);
  stage.pick.follow(130, 200, false);
  stage.pick.release(140, 220, false);
  EXPECT_FALSE(stage.pick.isPressed());
  stage.pick.follow(500, 500, false);  // the pointer moves on after the release
  stage.answer(0, "fb_1", 1.0, 2.0);
  ASSERT_EQ(2U, stage.asked.size());
  stage.answer(1, "fb_1", 1.0, 2.0);
  EXPECT_NEAR(1.4, stage.moves.at(0).entities[0].pose.pose.position.x, 1e-12);
  EXPECT_NEAR(2.2, stage.moves[0].entities[0].pose.pose.position.y, 1e-12);
}

TEST(PickAndDragTest, TheAnswerToAPressThatIsOverTakesHoldOfNothing) {
  Stage stage;
  stage.press(100, 200);
  stage.pick.release(100, 200, false);
  stage.press(300, 300);
  stage.answer(1, "fb_2", 3.0, 3.0);
  stage.answer(0, "fb_1", 1.0, 2.0);  // the second answer belongs to the first press
  EXPECT_EQ("fb_2", stage.selected);
  stage.pick.release(350, 300, false);
  ASSERT_EQ(3U, stage.asked.size());
  EXPECT_EQ("fb_2", stage.asked[2].request.name);
  stage.press(100, 200);
  stage.pick.letGo();  // as when another tool is chosen
  stage.answer(3, "fb_1", 1.0, 2.0);
  EXPECT_EQ("fb_2", stage.selected);
  EXPECT_FALSE(stage.shown);
}

TEST(PickAndDragTest, WhereNothingIsNothingIsDragged) {
  Stage stage;
  stage.press(100, 200);
  stage.answer(0, "");
  EXPECT_EQ("", stage.selected);
  EXPECT_EQ("nothing within 0.4 m", stage.said);
  stage.pick.follow(200, 200, false);
  stage.pick.release(200, 200, false);
  stage.press(100, 200);
  Inspect::Response busy;
  busy.message = "busy in step of robot 'fb_1'";
  stage.asked.at(1).then(busy);
  EXPECT_EQ("busy in step of robot 'fb_1'", stage.said);
  stage.pick.release(200, 200, false);
  stage.press(100, 200);
  stage.is_floor_in_sight = false;  // the pointer is above the horizon
  stage.answer(2, "fb_1", 1.0, 2.0);
  stage.pick.release(200, 200, false);
  EXPECT_EQ(3U, stage.asked.size());
  EXPECT_TRUE(stage.moves.empty());
}

TEST(PickAndDragTest, ShiftTurnsToWhereThePointerIsWhenItIsLetGo) {
  Stage stage;
  stage.press(100, 200);
  stage.answer(0, "fb_1", 1.0, 2.0);
  stage.pick.follow(150, 200, false);
  stage.pick.release(100, 260, true);
  stage.answer(1, "fb_1", 0.4, 2.0);  // the entity has moved
  const geometry_msgs::Pose& pose = stage.moves.at(0).entities[0].pose.pose;
  EXPECT_DOUBLE_EQ(0.4, pose.position.x);
  EXPECT_NEAR(std::sin(M_PI / 8), pose.orientation.z, 1e-12) << "0.6 m ahead, 0.6 m to the left: 45 degrees";
}

TEST(PickAndDragTest, WhoIsGoneWhenItIsLetGoIsNotMoved) {
  Stage stage;
  stage.press(100, 200);
  stage.answer(0, "fb_1", 1.0, 2.0);
  stage.pick.release(200, 200, false);
  Inspect::Response gone;
  gone.message = "there is no entity 'fb_1'";
  stage.asked.at(1).then(gone);
  EXPECT_EQ("there is no entity 'fb_1'", stage.said);
  EXPECT_TRUE(stage.moves.empty());
}

}  // namespace
}  // namespace swarmanoid
