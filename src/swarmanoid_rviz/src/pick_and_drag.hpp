/// From a press of the button to its release: what is there, where it is dragged, and what the space is asked for. No
/// Ogre and no Qt here.
///
/// The space answers when it can, and a hand is faster: what the pointer has done meanwhile is made up for, and the
/// answer to a press that is over takes hold of nothing.
#pragma once

#include <geometry_msgs/Point.h>
#include <swarmanoid_msgs/Inspect.h>
#include <swarmanoid_msgs/Move.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "drag.hpp"

namespace swarmanoid {

class PickAndDrag {
 public:
  using Inspect = swarmanoid_msgs::Inspect;
  using Move = swarmanoid_msgs::Move;

  /// Those who have a window and a space.
  struct Surroundings {
    /// The point of the horizontal plane of that height under a pixel; nothing above the horizon.
    std::function<std::optional<geometry_msgs::Point>(int x, int y, double height)> pointAt;
    std::function<void(const Inspect::Request&, std::function<void(const Inspect::Response&)>)> inspect;
    std::function<void(const Move::Request&, std::function<void(const Move::Response&)>)> move;
    std::function<void(const std::string& name)> select;
    std::function<void(const std::string& message)> say;
    /// Shows where it would stand; null: nothing is dragged any more.
    std::function<void(const geometry_msgs::Pose* pose)> preview;
  };

  /// From what is clicked on to the origin of an entity, at most [m].
  static constexpr double kReach = 0.4;

  explicit PickAndDrag(Surroundings surroundings) : surroundings_(std::move(surroundings)) {}

  /// @param x, y where the pointer is [pixels] @param seen what it points at, in the world
  void press(int x, int y, const geometry_msgs::Point& seen);
  /// @param turns see Drag::follow
  void follow(int x, int y, bool turns);
  void release(int x, int y, bool turns);
  /// Nothing is moved.
  void letGo();

  bool isPressed() const { return press_ && !press_->is_released; }

 private:
  struct Press {
    std::uint64_t number;
    int x, y;          ///< where the pointer took hold
    int now_x, now_y;  ///< where it is
    bool turns = false;
    bool is_released = false;
  };

  void takeHold(std::uint64_t press, const Inspect::Response& state);
  void drag();
  void finish();
  void askToMove();

  Surroundings surroundings_;
  std::uint64_t presses_ = 0;
  std::optional<Press> press_;
  std::optional<Drag> drag_;  // the space has said what is there
  std::string dragged_;       // its name
};

}  // namespace swarmanoid
