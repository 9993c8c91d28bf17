#include "pick_and_drag.hpp"

#include <sstream>

namespace swarmanoid {

void PickAndDrag::press(int x, int y, const geometry_msgs::Point& seen) {
  letGo();
  press_ = Press{++presses_, x, y, x, y};
  Inspect::Request request;
  request.near = seen;
  request.within = kReach;
  surroundings_.inspect(request,
                        [this, number = presses_](const Inspect::Response& state) { takeHold(number, state); });
}

void PickAndDrag::takeHold(std::uint64_t press, const Inspect::Response& state) {
  if (!press_ || press_->number != press) {
    return;
  }
  if (state.success == 0) {
    surroundings_.say(state.message);
    letGo();
    return;
  }
  std::ostringstream nobody;
  nobody << "nothing within " << kReach << " m";
  surroundings_.select(state.name);
  surroundings_.say(state.name.empty() ? nobody.str() : state.name);
  const auto held = surroundings_.pointAt(press_->x, press_->y, state.pose.position.z);
  if (state.name.empty() || !held) {
    letGo();
    return;
  }
  drag_.emplace(state.pose, held->x, held->y);
  dragged_ = state.name;
  drag();  // catches up with pointer moves since the press
  if (press_->is_released) {
    finish();
  }
}

void PickAndDrag::follow(int x, int y, bool turns) {
  if (!isPressed()) {
    return;
  }
  press_->now_x = x;
  press_->now_y = y;
  press_->turns = turns;
  if (drag_) {
    drag();
  }
}

void PickAndDrag::release(int x, int y, bool turns) {
  if (!isPressed()) {
    return;
  }
  follow(x, y, turns);
  press_->is_released = true;
  if (drag_) {
    finish();
  }
}

void PickAndDrag::drag() {
  if (const auto point = surroundings_.pointAt(press_->now_x, press_->now_y, drag_->height())) {
    drag_->follow(point->x, point->y, press_->turns);
    const geometry_msgs::Pose pose = drag_->pose();
    surroundings_.preview(drag_->isMove() ? &pose : nullptr);
  }
}

void PickAndDrag::finish() {
  if (drag_->isMove()) {
    askToMove();
  }
  letGo();
}

void PickAndDrag::letGo() {
  press_.reset();
  drag_.reset();
  surroundings_.preview(nullptr);
}

void PickAndDrag::askToMove() {
  Inspect::Request where;  // the entity may have moved since the press
  where.name = dragged_;
  surroundings_.inspect(where, [this, drag = *drag_](const Inspect::Response& now) {
    if (now.success == 0) {
      surroundings_.say(now.message);
      return;
    }
    Move::Request request;
    request.entities.resize(1);
    request.entities[0].name = now.name;
    request.entities[0].pose.pose = drag.applyTo(now.pose);
    surroundings_.move(request, [this, name = now.name](const Move::Response& response) {
      surroundings_.say(response.success != 0 ? name + " moved" : response.message);
    });
  });
}

}  // namespace swarmanoid
