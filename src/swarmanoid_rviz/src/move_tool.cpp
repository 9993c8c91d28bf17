#include "move_tool.hpp"

#include <OgreRay.h>
#include <OgreVector3.h>
#include <OgreViewport.h>
#include <rviz/display_context.h>
#include <rviz/geometry.h>
#include <rviz/render_panel.h>
#include <rviz/selection/selection_manager.h>
#include <rviz/view_controller.h>
#include <rviz/viewport_mouse_event.h>
#include <swarmanoid_msgs/Move.h>
#include <pluginlib/class_list_macros.hpp>

namespace swarmanoid {
namespace {

constexpr double kReach = 0.4;  // from what is clicked on to the origin of an entity [m]

std::optional<Ogre::Vector3> pointAt(Ogre::Viewport* viewport, int x, int y, double height) {
  Ogre::Plane plane(Ogre::Vector3::UNIT_Z, static_cast<Ogre::Real>(height));
  Ogre::Vector3 point;
  return rviz::getPointOnPlaneFromWindowXY(viewport, plane, x, y, point) ? std::optional<Ogre::Vector3>(point)
                                                                         : std::nullopt;
}

}  // namespace

MoveTool::MoveTool() { shortcut_key_ = 'e'; }

void MoveTool::onInitialize() {
  setName("Move");
  space_ = new rviz::StringProperty("Space", "/space", "The name of the space's node.", getPropertyContainer());
  selection_ = std::make_unique<Selection>([] {});
}

void MoveTool::activate() { setStatus("Click: select. Drag: move. Shift and drag: turn towards the pointer."); }

void MoveTool::deactivate() { letGo(); }

int MoveTool::processMouseEvent(rviz::ViewportMouseEvent& event) {
  const bool is_second_of_a_double_click =
      event.type == QEvent::MouseButtonDblClick && event.acting_button == Qt::LeftButton;
  if (event.leftDown() || is_second_of_a_double_click) {
    press(event);
  } else if (event.leftUp()) {
    release(event);
  } else if (press_) {
    follow(event);
  } else if (event.panel->getViewController() != nullptr) {
    event.panel->getViewController()->handleMouseEvent(event);
  }
  return Render;
}

void MoveTool::press(rviz::ViewportMouseEvent& event) {
  letGo();
  Ogre::Vector3 seen;
  if (!context_->getSelectionManager()->get3DPoint(event.viewport, event.x, event.y, seen)) {
    const auto on_floor = pointAt(event.viewport, event.x, event.y, 0.0);
    if (!on_floor) {
      return;
    }
    seen = *on_floor;
  }
  press_ = Press{++presses_, event.viewport, event.x, event.y, event.x, event.y};
  swarmanoid_msgs::Inspect::Request request;
  request.near.x = seen.x;
  request.near.y = seen.y;
  request.near.z = seen.z;
  request.within = kReach;
  requests_.setSpace(space_->getStdString());
  requests_.call<swarmanoid_msgs::Inspect>(
      "inspect", request,
      [this, number = presses_](const swarmanoid_msgs::Inspect::Response& state) { takeHold(number, state); });
}

void MoveTool::takeHold(std::uint64_t press, const swarmanoid_msgs::Inspect::Response& state) {
  if (!press_ || press_->number != press) {
    return;  // the answer comes late: the pointer has taken hold of something else
  }
  if (state.success == 0) {
    setStatus(QString::fromStdString(state.message));
    letGo();
    return;
  }
  selection_->choose(state.name);
  setStatus(state.name.empty() ? QString("nothing within %1 m").arg(kReach) : QString::fromStdString(state.name));
  const auto held = pointAt(press_->viewport, press_->x, press_->y, state.pose.position.z);
  if (state.name.empty() || !held) {
    letGo();
    return;
  }
  drag_.emplace(state.pose, held->x, held->y);
  dragged_ = state.name;
  drag();  // what the pointer has done meanwhile
  if (press_->is_released) {
    finish();
  }
}

void MoveTool::follow(rviz::ViewportMouseEvent& event) {
  if (press_->is_released) {
    return;
  }
  press_->now_x = event.x;
  press_->now_y = event.y;
  press_->turns = event.shift();
  if (drag_) {
    drag();
  }
}

void MoveTool::release(rviz::ViewportMouseEvent& event) {
  if (!press_) {
    return;
  }
  follow(event);
  press_->is_released = true;
  if (drag_) {
    finish();
  }
}

void MoveTool::drag() {
  if (const auto point = pointAt(press_->viewport, press_->now_x, press_->now_y, drag_->height())) {
    drag_->follow(point->x, point->y, press_->turns);
    showPreview();
  }
}

void MoveTool::finish() {
  if (drag_->isMove()) {
    askToMove();
  }
  letGo();
}

void MoveTool::showPreview() {
  if (!drag_->isMove()) {
    disc_.reset();
    arrow_.reset();
    return;
  }
  if (!disc_) {
    disc_ = std::make_unique<rviz::Shape>(rviz::Shape::Cylinder, scene_manager_);
    disc_->setColor(0.1F, 0.4F, 0.9F, 0.5F);
    disc_->setScale(Ogre::Vector3(0.2F, 0.02F, 0.2F));  // its axis is y
    disc_->setOrientation(Ogre::Quaternion(Ogre::Degree(90), Ogre::Vector3::UNIT_X));
    arrow_ = std::make_unique<rviz::Arrow>(scene_manager_, nullptr, 0.24F, 0.03F, 0.08F, 0.07F);
    arrow_->setColor(0.1F, 0.4F, 0.9F, 0.9F);
  }
  const geometry_msgs::Pose& pose = drag_->pose();
  const auto real = [](double value) { return static_cast<Ogre::Real>(value); };
  const Ogre::Vector3 place(real(pose.position.x), real(pose.position.y), real(pose.position.z));
  const Ogre::Quaternion turn(real(pose.orientation.w), real(pose.orientation.x), real(pose.orientation.y),
                              real(pose.orientation.z));
  disc_->setPosition(place);
  arrow_->setPosition(place + Ogre::Vector3(0, 0, 0.16F));  // above the bodies of robots
  arrow_->setDirection(turn * Ogre::Vector3::UNIT_X);
}

void MoveTool::letGo() {
  press_.reset();
  drag_.reset();
  disc_.reset();
  arrow_.reset();
}

void MoveTool::askToMove() {
  swarmanoid_msgs::Inspect::Request where;
  where.name = dragged_;
  const auto put = [this, drag = *drag_,
                    frame = context_->getFixedFrame()](const swarmanoid_msgs::Inspect::Response& now) {
    if (now.success == 0) {
      setStatus(QString::fromStdString(now.message));
      return;
    }
    swarmanoid_msgs::Move::Request request;
    request.entities.resize(1);
    request.entities[0].name = now.name;
    request.entities[0].pose.header.frame_id = frame.toStdString();
    request.entities[0].pose.pose = drag.applyTo(now.pose);
    requests_.call<swarmanoid_msgs::Move>("move", request, [this, name = now.name](const auto& response) {
      setStatus(QString::fromStdString(response.success != 0 ? name + " moved" : response.message));
    });
  };
  requests_.call<swarmanoid_msgs::Inspect>("inspect", where, put);  // it may have driven on since the press
}

}  // namespace swarmanoid

PLUGINLIB_EXPORT_CLASS(swarmanoid::MoveTool, rviz::Tool)
