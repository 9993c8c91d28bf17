/// The tool "Move" of rviz (thesis 3.6.3 and its outlook). A click selects the entity under the pointer, dragging moves
/// it over the horizontal plane through its origin, dragging with Shift turns it to the pointer. The space applies the
/// move between two ticks; if it rejects the move, the status bar of the window shows the reason. Other buttons and the
/// wheel move the camera.
#pragma once

#include <rviz/ogre_helpers/arrow.h>
#include <rviz/ogre_helpers/shape.h>
#include <rviz/properties/string_property.h>
#include <rviz/tool.h>

#include <memory>

#include "pick_and_drag.hpp"
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
  PickAndDrag::Surroundings surroundings();
  void press(rviz::ViewportMouseEvent& event);
  /// @param pose target pose; null hides the preview
  void showPreview(const geometry_msgs::Pose* pose);

  rviz::StringProperty* space_ = nullptr;  // saved in the layout; the property container owns it
  Ogre::Viewport* viewport_ = nullptr;     // of the last press
  std::unique_ptr<Selection> selection_;
  std::unique_ptr<rviz::Shape> disc_;  // preview of the target; null while nothing is dragged
  std::unique_ptr<rviz::Arrow> arrow_;
  PickAndDrag pick_;
  Requests requests_{"/space"};  // last: its answers use the other members
};

}  // namespace swarmanoid
