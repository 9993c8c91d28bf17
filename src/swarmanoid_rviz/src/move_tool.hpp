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
  /// Where the pointer took hold, in pixels.
  struct Press {
    Ogre::Viewport* viewport;
    int x, y;
  };

  void press(rviz::ViewportMouseEvent& event);
  void takeHold(const swarmanoid_msgs::Inspect::Response& state);
  void follow(rviz::ViewportMouseEvent& event);
  void release();
  void letGo();
  void showPreview();
  void askToMove();

  rviz::StringProperty* space_;  // of the layout; the property container owns it
  std::unique_ptr<Selection> selection_;
  std::optional<Press> press_;         // the button is down
  std::optional<Drag> drag_;           // and the space has said what is there
  std::string dragged_;                // its name
  std::unique_ptr<rviz::Shape> disc_;  // where it would stand; null while nothing is dragged
  std::unique_ptr<rviz::Arrow> arrow_;
  Requests requests_{"/space"};  // last: it waits for answers, which speak of the others
};

}  // namespace swarmanoid
