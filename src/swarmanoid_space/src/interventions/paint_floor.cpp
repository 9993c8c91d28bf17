// Paint on the floor: trails of robots, signs of rules.
#include "carry_out.hpp"
#include "swarmanoid_interface/readable_number.hpp"

namespace swarmanoid {
namespace {

/// Returns "disc 2: ", or "" for a single disc.
std::string describeDisc(const PaintFloor& intervention, std::size_t disc) {
  return intervention.discs.size() == 1 ? "" : "disc " + std::to_string(disc + 1) + ": ";
}

void requireIn(const Range& range, double value, const std::string& what) {
  if (!range.contains(value)) {
    throw ConfigError({}, what + ": found " + numberText(value) + ", allowed: " + range.toString());
  }
}

std::string textOf(const Eigen::Vector2d& v) { return readableNumber(v.x()) + ", " + readableNumber(v.y()); }

void check(const PaintDisc& disc, const std::string& what, const Space& space) {
  const Eigen::Vector2d& at = disc.position;
  const Eigen::Vector2d least = space.corner.head<2>();
  const Eigen::Vector2d most = space.farCorner().head<2>();
  if (!((at.array() >= least.array()).all() && (at.array() <= most.array()).all())) {
    throw ConfigError({}, what + "position: found " + textOf(at) + ", allowed: in the arena, from " + textOf(least) +
                              " to " + textOf(most));
  }
  requireIn(PaintFloor::kRadius, disc.radius, what + "radius");
  requireIn(PaintFloor::kStrength, disc.strength, what + "strength");
}

}  // namespace

void PaintFloor::requireFewCells(std::size_t cells) {
  if (cells > kMostCells) {
    throw ConfigError({}, "found " + std::to_string(cells) +
                              " cells in the squares around the discs, allowed: at most " + std::to_string(kMostCells) +
                              " in one call");
  }
}

bool carryOut(World& world, const PaintFloor& intervention) {
  PaintLayer& paint = world.space.floor.paint;
  if (!paint.exists()) {
    throw ConfigError({}, "found paint for the floor, allowed: in an arena with <floor_paint>");
  }
  if (intervention.discs.empty()) {
    throw ConfigError({}, "found no disc to paint, allowed: one or more");
  }
  std::size_t cells = 0;
  for (std::size_t i = 0; i < intervention.discs.size(); ++i) {
    check(intervention.discs[i], describeDisc(intervention, i), world.space);
    cells += paint.cellsAround(intervention.discs[i]);
  }
  PaintFloor::requireFewCells(cells);
  for (const PaintDisc& disc : intervention.discs) {
    paint.paint(disc, world.space.tick);
  }
  const PaintDisc& first = intervention.discs.front();
  const std::size_t count = intervention.discs.size();
  world.pending_events.push_back({Event::Kind::kIntervention, "", "",
                                  "paint at " + numberText(first.position.x()) + ", " + numberText(first.position.y()) +
                                      (count == 1 ? "" : " and " + std::to_string(count - 1) + " more discs")});
  return true;
}

}  // namespace swarmanoid
