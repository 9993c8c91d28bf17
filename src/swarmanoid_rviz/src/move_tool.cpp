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
  if (event.leftDown()) {
    press(event);
  } else if (event.leftUp()) {
    release();
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
  press_ = Press{event.viewport, event.x, event.y};
  swarmanoid_msgs::Inspect::Request request;
  request.near.x = seen.x;
  request.near.y = seen.y;
  request.near.z = seen.z;
  request.within = kReach;
  requests_.setSpace(space_->getStdString());
  requests_.call<swarmanoid_msgs::Inspect>(
      "inspect", request, [this](const swarmanoid_msgs::Inspect::Response& state) { takeHold(state); });
}

void MoveTool::takeHold(const swarmanoid_msgs::Inspect::Response& state) {
  if (state.success == 0) {
    setStatus(QString::fromStdString(state.message));
    return;
  }
  selection_->choose(state.name);
  setStatus(state.name.empty() ? QString("nothing within %1 m").arg(kReach) : QString::fromStdString(state.name));
  if (state.name.empty() || !press_) {  // the button is up again: it was a click
    return;
  }
  if (const auto held = pointAt(press_->viewport, press_->x, press_->y, state.pose.position.z)) {
    drag_.emplace(state.pose, held->x, held->y);
    dragged_ = state.name;
  }
}

void MoveTool::follow(rviz::ViewportMouseEvent& event) {
  if (!drag_) {
    return;
  }
  const auto point = pointAt(event.viewport, event.x, event.y, drag_->height());
  if (!point) {
    return;
  }
  if (event.shift()) {
    drag_->turnTo(point->x, point->y);
  } else {
    drag_->moveTo(point->x, point->y);
  }
  showPreview();
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

void MoveTool::release() {
  if (drag_ && drag_->isMove()) {
    askToMove();
  }
  letGo();
}

void MoveTool::letGo() {
  press_.reset();
  drag_.reset();
  disc_.reset();
  arrow_.reset();
}

void MoveTool::askToMove() {
  swarmanoid_msgs::Move::Request request;
  request.entities.resize(1);
  request.entities[0].name = dragged_;
  request.entities[0].pose.header.frame_id = context_->getFixedFrame().toStdString();
  request.entities[0].pose.pose = drag_->pose();
  requests_.call<swarmanoid_msgs::Move>(
      "move", request, [this, name = dragged_](const swarmanoid_msgs::Move::Response& response) {
        setStatus(QString::fromStdString(response.success != 0 ? name + " moved" : response.message));
      });
}

}  // namespace swarmanoid

PLUGINLIB_EXPORT_CLASS(swarmanoid::MoveTool, rviz::Tool)
