/// One drag from press to release of the button: finds the entity, follows the pointer, and sends requests to the
/// space. Free of Ogre and Qt.
///
/// The space answers asynchronously. When the answer to a press arrives, the drag catches up with the pointer; an
/// answer to an earlier press, or after letGo, is ignored.
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

  /// Callbacks into the window and to the space.
  struct Surroundings {
    /// The point under a pixel on the horizontal plane at that height; nothing above the horizon.
    std::function<std::optional<geometry_msgs::Point>(int x, int y, double height)> pointAt;
    std::function<void(const Inspect::Request&, std::function<void(const Inspect::Response&)>)> inspect;
    std::function<void(const Move::Request&, std::function<void(const Move::Response&)>)> move;
    std::function<void(const std::string& name)> select;
    std::function<void(const std::string& message)> say;
    /// Shows the target pose; null hides it.
    std::function<void(const geometry_msgs::Pose* pose)> preview;
  };

  /// Maximum distance from the clicked point to the origin of an entity [m].
  static constexpr double kReach = 0.4;

  explicit PickAndDrag(Surroundings surroundings) : surroundings_(std::move(surroundings)) {}

  /// @param x, y pointer [pixels] @param seen point under the pointer, in W
  void press(int x, int y, const geometry_msgs::Point& seen);
  /// @param turns see Drag::follow
  void follow(int x, int y, bool turns);
  void release(int x, int y, bool turns);
  /// Cancels the drag; the entity stays.
  void letGo();

  bool isPressed() const { return press_ && !press_->is_released; }

 private:
  struct Press {
    std::uint64_t number;
    int x, y;          ///< pointer at the press [pixels]
    int now_x, now_y;  ///< current pointer [pixels]
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
  std::optional<Drag> drag_;  // set once the space has found an entity
  std::string dragged_;       // name of the dragged entity
};

}  // namespace swarmanoid
