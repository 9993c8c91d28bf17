#include "camera_places.hpp"

#include <rviz/view_controller.h>

namespace swarmanoid {
namespace {

QString nameOf(int number) { return QString("camera %1").arg(number); }

rviz::ViewController* findView(const rviz::ViewManager& views, const QString& name) {
  for (int i = 0; i < views.getNumViews(); ++i) {
    if (views.getViewAt(i)->getName() == name) {
      return views.getViewAt(i);
    }
  }
  return nullptr;
}

}  // namespace

void keepCamera(rviz::ViewManager& views, int number) {
  if (rviz::ViewController* replaced = findView(views, nameOf(number))) {
    delete views.take(replaced);
  }
  rviz::ViewController* kept = views.copy(views.getCurrent());
  kept->setName(nameOf(number));
  views.add(kept);
}

bool recallCamera(rviz::ViewManager& views, int number) {
  rviz::ViewController* found = findView(views, nameOf(number));
  if (found != nullptr) {
    views.setCurrentFrom(found);
  }
  return found != nullptr;
}

}  // namespace swarmanoid
