#include "swarmanoid_interface/plain_text.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid {
namespace {

/// Visits a colour only if it has changed: others follow from the experiment file, and recordings have all of them
/// anyway.
void visitChangedColor(const Space& space, StateVisitor& visitor, Row row) {
  const Color& color = space.entities.color[row];
  if (!visitor.wantsDetail() && color != space.entities.first_color[row]) {
    visitor.colors({space.entities.color.info().name}, Span<const Color>(&color, 1));
  }
}

void visitLaserSpots(const Space& space, StateVisitor& visitor) {
  for (std::size_t i = 0; i < space.laser_spots.size(); ++i) {
    const LaserSpot& spot = space.laser_spots[i];
    const int index = static_cast<int>(i);
    visitor.entity({"laser_spot", {}, "owner", index}, space.entities.find(spot.owner));
    visitor.vector({"laser_spot", {}, "position", index}, spot.position);
  }
}

void visitPaint(const Space& space, StateVisitor& visitor) {
  const PaintLayer& paint = space.floor.paint;
  if (!paint.exists()) {
    return;
  }
  if (visitor.wantsDetail()) {
    visitor.number({"floor", "painted_cells"}, static_cast<double>(paint.spotCount()));
    visitor.text({"floor", "paint"}, hashText(paint.digest()));
  } else {
    visitor.ordinal(paint.digest());
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
    visitChangedColor(space, visitor, row);
  }
  visitor.beginWorld();
  visitLaserSpots(space, visitor);
  visitPaint(space, visitor);
}

}  // namespace swarmanoid
