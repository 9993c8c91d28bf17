/// Up to ten viewpoints that are kept and recalled by keys (thesis 3.6.2): saved views of rviz, named "camera 0" to
/// "camera 9", which the panel Views lists too and the layout keeps.
///
/// Threads  that of Qt's windows.
#pragma once

#include <rviz/view_manager.h>

namespace swarmanoid {

constexpr int kCameraPlaces = 10;

/// Keeps how the camera stands now, in the place of what had that number.
void keepCamera(rviz::ViewManager& views, int number);

/// @return whether there is one of that number; the camera stands there now
bool recallCamera(rviz::ViewManager& views, int number);

}  // namespace swarmanoid
