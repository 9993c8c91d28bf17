// Rays against a terrain, cell by cell: along a segment the height over each triangle is linear.
#include <algorithm>
#include <cmath>

#include "swarmanoid_interface/range.hpp"
#include "swarmanoid_space/rays/line_part.hpp"
#include "swarmanoid_space/rays/terrain.hpp"

namespace swarmanoid {
namespace {

LinePart clipToRectangle(const Segment& segment, const Eigen::AlignedBox3d& bounds) {
  const Eigen::Vector3d way = segment.to - segment.from;
  LinePart part;
  for (int axis = 0; axis < 2; ++axis) {
    part.clipToSlab(segment.from[axis], way[axis], bounds.min()[axis], bounds.max()[axis]);
  }
  return part;
}

/// Fraction of the segment at which a coordinate reaches a line of the grid.
double reaching(double line, double start, double way) { return way == 0.0 ? kInfinity : (line - start) / way; }

}  // namespace

/// Follows a segment, and finds the first point where it enters the ground from above.
class Terrain::Descent {
 public:
  Descent(const Terrain& terrain, const Segment& segment, double start)
      : terrain_(terrain),
        from_(segment.from),
        way_(segment.to - segment.from),
        // a ray from outside arrives through the air; one that starts in the ground does not
        is_above_(start > 0.0 || from_.z() >= terrain.heightAt(from_.x(), from_.y())) {}

  bool hasHit() const { return hit_ != kInfinity; }
  double hit() const { return hit_; }
  bool isAbove() const { return is_above_; }

  void passCell(const Eigen::Vector2i& cell, LinePart piece) {
    const Eigen::Vector2d& step = terrain_.step_;
    // side of the cell's diagonal on which the segment starts, and the fraction at which it crosses the diagonal
    const double side =
        (from_.x() - terrain_.lineX(cell.x())) * step.y() - (from_.y() - terrain_.lineY(cell.y())) * step.x();
    const double change = way_.x() * step.y() - way_.y() * step.x();
    const double crossing = change == 0.0 ? kInfinity : -side / change;
    if (crossing > piece.from && crossing < piece.to) {
      const int first = change > 0.0 ? 1 : 0;
      passTriangle(cell, first, {piece.from, crossing});
      if (!hasHit()) {
        passTriangle(cell, 1 - first, {crossing, piece.to});
      }
    } else {
      passTriangle(cell, side + 0.5 * (piece.from + piece.to) * change >= 0.0 ? 0 : 1, piece);
    }
  }

 private:
  void passTriangle(const Eigen::Vector2i& cell, int half, LinePart piece) {
    const auto heightOver = [&](double t) {
      const Eigen::Vector3d point = from_ + t * way_;
      return point.z() - terrain_.heightInCell(cell, point.x(), point.y(), half);
    };
    const double before = heightOver(piece.from);
    const double after = heightOver(piece.to);
    if (is_above_ && before < 0.0) {
      hit_ = piece.from;  // a cliff, or heights that differ by rounding
    } else if (before >= 0.0 && after < 0.0) {
      hit_ = piece.from + (piece.to - piece.from) * before / (before - after);
    }
    is_above_ = after >= 0.0;
  }

  const Terrain& terrain_;
  Eigen::Vector3d from_;
  Eigen::Vector3d way_;
  bool is_above_;
  double hit_ = kInfinity;
};

double Terrain::closestHit(const Segment& segment) const {
  const LinePart inside = clipToRectangle(segment, bounds_);
  const Eigen::Vector3d way = segment.to - segment.from;
  const auto heightOf = [&](double t) { return segment.from.z() + t * way.z(); };
  const double top = std::max(0.0, bounds_.max().z());
  if (inside.isEmpty() || std::min(heightOf(inside.from), heightOf(inside.to)) > top) {
    return kInfinity;
  }
  if (inside.from > 0.0 && heightOf(inside.from) < 0.0) {
    return inside.from;  // the segment enters through the floor
  }
  const Eigen::Vector3d first = segment.from + inside.from * way;
  Eigen::Vector2i cell = cellAt(first.x(), first.y());
  Descent descent(*this, segment, inside.from);
  double from = inside.from;
  while (true) {
    const double next_x = reaching(lineX(cell.x() + (way.x() > 0.0 ? 1 : 0)), segment.from.x(), way.x());
    const double next_y = reaching(lineY(cell.y() + (way.y() > 0.0 ? 1 : 0)), segment.from.y(), way.y());
    const double to = std::max(from, std::min({next_x, next_y, inside.to}));
    descent.passCell(cell, {from, to});
    if (descent.hasHit()) {
      return descent.hit();
    }
    const int axis = next_x <= next_y ? 0 : 1;
    cell[axis] += way[axis] > 0.0 ? 1 : -1;
    if (to >= inside.to || cell[axis] < 0 || cell[axis] >= (axis == 0 ? columns_ : rows_) - 1) {
      break;
    }
    from = to;
  }
  // next to a rim below the floor the segment meets the floor
  return inside.to < 1.0 && descent.isAbove() && heightOf(inside.to) < 0.0 ? inside.to : kInfinity;
}

bool Terrain::mayHit(const RayBundle& rays) const {
  const Eigen::Vector2d reach = Eigen::Vector2d::Constant(rays.radius);
  const Eigen::Vector2d centre = rays.centre.head<2>();
  const Cells cells = cellsIn(centre - reach, centre + reach);
  return cells.high.x() >= 0 && rays.centre.z() - rays.radius < std::max(0.0, highestIn(cells));
}

void Terrain::raycast(const RayBundle& rays, Span<RayHit> hits) const {
  for (std::size_t k = 0; k < rays.segments.size(); ++k) {
    const double fraction = closestHit(rays.segments[k]);
    if (fraction < hits[k].fraction) {
      hits[k] = {fraction, kNoRow};
    }
  }
}

}  // namespace swarmanoid
