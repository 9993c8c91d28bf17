#include "swarmanoid_space/space.hpp"

namespace swarmanoid {
namespace {

void visitLaserSpots(const Space& space, StateVisitor& visitor) {
  for (std::size_t i = 0; i < space.laser_spots.size(); ++i) {
    const LaserSpot& spot = space.laser_spots[i];
    const int index = static_cast<int>(i);
    visitor.entity({"laser_spot", {}, "owner", index}, space.entities.find(spot.owner));
    visitor.vector({"laser_spot", {}, "position", index}, spot.position);
  }
}

}  // namespace

void visitCell(StateVisitor& visitor, const char* name, const CellOwner& owner, const Engine* mover) {
  if (owner.model.is_movable) {
    visitor.text({name}, mover == nullptr ? std::string_view() : std::string_view(mover->id()));
  }
}

void visitState(const Space& space, StateVisitor& visitor) {
  for (const Row row : space.entities.order) {
    visitor.beginEntity(row);
    space.entities.columns.visit(visitor, {row, *space.entities.model[row]});
  }
  visitor.beginWorld();
  visitLaserSpots(space, visitor);
}

}  // namespace swarmanoid
