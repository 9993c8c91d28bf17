/// Up to ten viewpoints, stored and recalled by keys (thesis 3.6.2). They are saved views of rviz, named "camera 0" to
/// "camera 9", so the panel Views lists them and the layout stores them.
///
/// Threads  Qt's GUI thread only.
#pragma once

#include <rviz/view_manager.h>

namespace swarmanoid {

constexpr int kCameraPlaces = 10;

/// Stores the current view under that number, and replaces a view stored there.
void keepCamera(rviz::ViewManager& views, int number);

/// Moves the camera to the stored view. @return false if none is stored under that number
bool recallCamera(rviz::ViewManager& views, int number);

}  // namespace swarmanoid
