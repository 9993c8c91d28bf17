/// The tool "Move" of rviz (thesis 3.6.3, and what it announces): a click selects the entity under the pointer,
/// dragging moves it over the horizontal plane that it stands on, dragging with Shift turns it to the pointer. The
/// space does it between two ticks and says why if it refuses, at the bottom of the window. Other buttons and the wheel
/// move the camera.
#pragma once

#include <rviz/ogre_helpers/arrow.h>
#include <rviz/ogre_helpers/shape.h>
#include <rviz/properties/string_property.h>
#include <rviz/tool.h>
#include <swarmanoid_msgs/Inspect.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "drag.hpp"
#include "requests.hpp"
#include "selection.hpp"

namespace swarmanoid {

class MoveTool : public rviz::Tool {
  Q_OBJECT
 public:
  MoveTool();

  void onInitialize() override;
  void activate() override;
  void deactivate() override;
  int processMouseEvent(rviz::ViewportMouseEvent& event) override;

 private:
  /// From the button's way down until the space has said what is there, and then until it is up.
  struct Press {
    std::uint64_t number;
    Ogre::Viewport* viewport;
    int x, y;          ///< where the pointer took hold [pixels]
    int now_x, now_y;  ///< where it is
    bool turns = false;
    bool is_released = false;
  };

  void press(rviz::ViewportMouseEvent& event);
  void takeHold(std::uint64_t press, const swarmanoid_msgs::Inspect::Response& state);
  void follow(rviz::ViewportMouseEvent& event);
  void release(rviz::ViewportMouseEvent& event);
  void drag();
  void finish();
  void letGo();
  void showPreview();
  void askToMove();

  rviz::StringProperty* space_;  // of the layout; the property container owns it
  std::unique_ptr<Selection> selection_;
  std::uint64_t presses_ = 0;
  std::optional<Press> press_;
  std::optional<Drag> drag_;           // and the space has said what is there
  std::string dragged_;                // its name
  std::unique_ptr<rviz::Shape> disc_;  // where it would stand; null while nothing is dragged
  std::unique_ptr<rviz::Arrow> arrow_;
  Requests requests_{"/space"};  // last: answers speak of the others
};

}  // namespace swarmanoid
