#include "move_tool.hpp"

#include <OgrePlane.h>
#include <OgreVector3.h>
#include <OgreViewport.h>
#include <rviz/display_context.h>
#include <rviz/geometry.h>
#include <rviz/render_panel.h>
#include <rviz/selection/selection_manager.h>
#include <rviz/view_controller.h>
#include <rviz/viewport_mouse_event.h>

#include <pluginlib/class_list_macros.hpp>

namespace swarmanoid {
namespace {

geometry_msgs::Point toMessage(const Ogre::Vector3& vector) {
  geometry_msgs::Point point;
  point.x = vector.x;
  point.y = vector.y;
  point.z = vector.z;
  return point;
}

std::optional<geometry_msgs::Point> pointAt(Ogre::Viewport* viewport, int x, int y, double height) {
  Ogre::Plane plane(Ogre::Vector3::UNIT_Z, static_cast<Ogre::Real>(height));
  Ogre::Vector3 point;
  return rviz::getPointOnPlaneFromWindowXY(viewport, plane, x, y, point)
             ? std::optional<geometry_msgs::Point>(toMessage(point))
             : std::nullopt;
}

}  // namespace

MoveTool::MoveTool() : pick_(surroundings()) { shortcut_key_ = 'e'; }

PickAndDrag::Surroundings MoveTool::surroundings() {
  using Inspect = PickAndDrag::Inspect;
  using Move = PickAndDrag::Move;
  PickAndDrag::Surroundings result;
  result.pointAt = [this](int x, int y, double height) { return pointAt(viewport_, x, y, height); };
  result.inspect = [this](const Inspect::Request& request, auto then) {
    requests_.call<Inspect>("inspect", request, std::move(then));
  };
  result.move = [this](Move::Request request, auto then) {
    request.entities[0].pose.header.frame_id = context_->getFixedFrame().toStdString();
    requests_.call<Move>("move", request, std::move(then));
  };
  result.select = [this](const std::string& name) { selection_->choose(name); };
  result.say = [this](const std::string& message) { setStatus(QString::fromStdString(message)); };
  result.preview = [this](const geometry_msgs::Pose* pose) { showPreview(pose); };
  return result;
}

void MoveTool::onInitialize() {
  setName("Move");
  space_ = new rviz::StringProperty("Space", "/space", "The name of the space's node.", getPropertyContainer());
  selection_ = std::make_unique<Selection>([] {});
}

void MoveTool::activate() { setStatus("Click: select. Drag: move. Shift and drag: turn towards the pointer."); }

void MoveTool::deactivate() { pick_.letGo(); }

int MoveTool::processMouseEvent(rviz::ViewportMouseEvent& event) {
  const bool is_second_of_a_double_click =
      event.type == QEvent::MouseButtonDblClick && event.acting_button == Qt::LeftButton;
  if (event.leftDown() || is_second_of_a_double_click) {
    press(event);
  } else if (event.leftUp()) {
    pick_.release(event.x, event.y, event.shift());
  } else if (pick_.isPressed()) {
    pick_.follow(event.x, event.y, event.shift());
  } else if (event.panel->getViewController() != nullptr) {
    event.panel->getViewController()->handleMouseEvent(event);
  }
  return Render;
}

void MoveTool::press(rviz::ViewportMouseEvent& event) {
  viewport_ = event.viewport;
  requests_.setSpace(space_->getStdString());
  Ogre::Vector3 seen;
  if (context_->getSelectionManager()->get3DPoint(event.viewport, event.x, event.y, seen)) {
    pick_.press(event.x, event.y, toMessage(seen));
  } else if (const auto on_floor = pointAt(event.viewport, event.x, event.y, 0.0)) {
    pick_.press(event.x, event.y, *on_floor);
  }
}

void MoveTool::showPreview(const geometry_msgs::Pose* pose) {
  if (pose == nullptr) {
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
  const auto real = [](double value) { return static_cast<Ogre::Real>(value); };
  const Ogre::Vector3 place(real(pose->position.x), real(pose->position.y), real(pose->position.z));
  const Ogre::Quaternion turn(real(pose->orientation.w), real(pose->orientation.x), real(pose->orientation.y),
                              real(pose->orientation.z));
  disc_->setPosition(place);
  arrow_->setPosition(place + Ogre::Vector3(0, 0, 0.16F));  // above the bodies of robots
  arrow_->setDirection(turn * Ogre::Vector3::UNIT_X);
}

}  // namespace swarmanoid

PLUGINLIB_EXPORT_CLASS(swarmanoid::MoveTool, rviz::Tool)
