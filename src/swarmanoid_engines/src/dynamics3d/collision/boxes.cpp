#include "dynamics3d/collision/boxes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "dynamics3d/settings.hpp"

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Pose of the second box relative to the first one.
struct Relative {
  Relative(const PlacedSolid& a, const PlacedSolid& b)
      : turn(a.axes.transpose() * b.axes),
        cosines(turn.cwiseAbs()),
        way(a.axes.transpose() * (b.centre - a.centre)),
        way_in_b(turn.transpose() * way) {}

  Matrix3d turn;     // the axes of b, in a's frame
  Matrix3d cosines;  // between the axes, at least 0
  Vector3d way;      // from the centre of a to that of b, in a's frame [m]
  Vector3d way_in_b;
};

/// A separating axis: the normal of a face of one box, or the cross product of an edge of each.
struct Axis {
  double gap = -std::numeric_limits<double>::infinity();  // along it [m]; below 0: how deep the boxes overlap
  int of_a = -1;                                          // index of the box's axis; -1: none of this box
  int of_b = -1;
};

double sideOf(double value) { return value < 0.0 ? -1.0 : 1.0; }

/// The axis with the widest gap. Face contacts hold a box, an edge contact lets it rock: so edges need a noticeable
/// advantage. The second box's faces need it too, or small motions would swap the axis from step to step.
Axis widestGap(const PlacedSolid& a, const PlacedSolid& b, const Relative& relative, double margin) {
  constexpr double kAdvantage = 2e-5;  // m
  constexpr double kParallel = 1e-6;   // rad: nearly parallel edges define no axis
  Axis best;
  const Vector3d gaps_a = relative.way.cwiseAbs() - a.half - relative.cosines * b.half;
  best.gap = gaps_a.maxCoeff(&best.of_a);
  const Vector3d gaps_b = relative.way_in_b.cwiseAbs() - b.half - relative.cosines.transpose() * a.half;
  int face_b = 0;
  const double gap_b = gaps_b.maxCoeff(&face_b);
  if (gap_b > best.gap + kAdvantage) {
    best = {gap_b, -1, face_b};
  }
  const double widest_of_faces = std::max(best.gap, gap_b);
  if (widest_of_faces > margin) {
    best.gap = widest_of_faces;
    return best;
  }
  double needed = widest_of_faces + kAdvantage;
  for (int i = 0; i < 3; ++i) {
    const int i1 = (i + 1) % 3;
    const int i2 = (i + 2) % 3;
    for (int j = 0; j < 3; ++j) {
      const int j1 = (j + 1) % 3;
      const int j2 = (j + 2) % 3;
      // the cross product of edge i of a and edge j of b is (0, -turn(i2, j), turn(i1, j)) along i, i1, i2
      const double sine =
          std::sqrt(relative.turn(i1, j) * relative.turn(i1, j) + relative.turn(i2, j) * relative.turn(i2, j));
      const double between =
          std::abs(relative.turn(i1, j) * relative.way[i2] - relative.turn(i2, j) * relative.way[i1]);
      const double reach = a.half[i1] * relative.cosines(i2, j) + a.half[i2] * relative.cosines(i1, j) +
                           b.half[j1] * relative.cosines(i, j2) + b.half[j2] * relative.cosines(i, j1);
      if (sine > kParallel && between - reach > needed * sine) {
        needed = (between - reach) / sine;
        best = {needed, i, j};
      }
    }
  }
  return best;
}

/// Corners of a convex polygon over a face: x and y along the face's edges, z out of the face [m].
class Polygon {
 public:
  void add(const Vector3d& corner) {
    if (count_ < kRoom) {
      corners_[count_++] = corner;
    }
  }
  /// Cuts off the part where `side` times the coordinate is more than `limit`.
  void cut(int coordinate, double side, double limit) {
    const auto is_within = [&](const Vector3d& corner) { return side * corner[coordinate] <= limit; };
    if (std::all_of(corners_.begin(), corners_.begin() + count_, is_within)) {
      return;
    }
    Polygon kept;
    for (std::size_t i = 0; i < count_; ++i) {
      const Vector3d& from = corners_[i];
      const Vector3d& to = corners_[(i + 1) % count_];
      const double beyond = side * from[coordinate] - limit;
      const double beyond_next = side * to[coordinate] - limit;
      if (beyond <= 0.0) {
        kept.add(from);
      }
      if (beyond * beyond_next < 0.0) {
        kept.add(from + beyond / (beyond - beyond_next) * (to - from));
      }
    }
    *this = kept;
  }
  /// Removes the corners above a height.
  void keepBelow(double height) {
    const auto is_higher = [&](const Vector3d& corner) { return corner.z() > height; };
    count_ = static_cast<std::size_t>(std::remove_if(corners_.begin(), corners_.begin() + count_, is_higher) -
                                      corners_.begin());
  }
  /// Keeps the corner that is lowest on the slope, and of the others those farthest from each other.
  /// @param slope of the height to compare by, along x and y
  void keepSpread(std::size_t most, const Eigen::Vector2d& slope);

  const Vector3d& lowest() const {
    return *std::min_element(corners_.begin(), corners_.begin() + count_,
                             [](const Vector3d& a, const Vector3d& b) { return a.z() < b.z(); });
  }
  std::size_t size() const { return count_; }
  const Vector3d* begin() const { return corners_.data(); }
  const Vector3d* end() const { return corners_.data() + count_; }

 private:
  static constexpr std::size_t kRoom = 12;  // four corners, and one more for each cut; rounding may add some

  std::array<Vector3d, kRoom> corners_;
  std::size_t count_ = 0;
};

void Polygon::keepSpread(std::size_t most, const Eigen::Vector2d& slope) {
  constexpr double kSame = 1e-6;  // m
  const auto height = [&](const Vector3d& corner) { return corner.z() + slope.dot(corner.head<2>()); };
  const auto last = corners_.begin() + count_;
  std::swap(corners_[0], *std::min_element(corners_.begin(), last, [&](const Vector3d& a, const Vector3d& b) {
              return height(a) < height(b);
            }));
  std::array<double, kRoom> nearest;  // squared distance to the corners that are kept
  nearest.fill(std::numeric_limits<double>::infinity());
  for (std::size_t kept = 1; kept < std::min(most, count_); ++kept) {
    std::size_t farthest = kept;
    for (std::size_t i = kept; i < count_; ++i) {
      nearest[i] = std::min(nearest[i], (corners_[i] - corners_[kept - 1]).squaredNorm());
      farthest = nearest[i] > nearest[farthest] ? i : farthest;
    }
    if (nearest[farthest] < kSame * kSame) {
      count_ = kept;
      return;
    }
    std::swap(corners_[kept], corners_[farthest]);
    std::swap(nearest[kept], nearest[farthest]);
  }
  count_ = std::min(most, count_);
}

/// The face of a box that carries the contacts. Its frame: x and y along its edges, z out of the box, zero in its
/// middle.
struct BearingFace {
  BearingFace(const PlacedSolid& box, int axis, double side) {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    axes.col(0) = box.axes.col(u);
    axes.col(1) = side * box.axes.col(v);
    axes.col(2) = side * box.axes.col(axis);
    half = {box.half[u], box.half[v]};
    middle = box.centre + box.half[axis] * axes.col(2);
  }

  Matrix3d axes;         // in W
  Eigen::Vector2d half;  // [m]
  Vector3d middle;       // in W [m]
};

/// The face of a box that is most opposed to a face of another box, in the frame of that face.
Polygon faceAgainst(const BearingFace& face, const PlacedSolid& box) {
  const Matrix3d turn = face.axes.transpose() * box.axes;
  int axis = 0;
  turn.row(2).cwiseAbs().maxCoeff(&axis);
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  const Vector3d middle =
      face.axes.transpose() * (box.centre - face.middle) - sideOf(turn(2, axis)) * box.half[axis] * turn.col(axis);
  const Vector3d edge_u = box.half[u] * turn.col(u);
  const Vector3d edge_v = box.half[v] * turn.col(v);
  Polygon polygon;
  polygon.add(middle - edge_u - edge_v);
  polygon.add(middle + edge_u - edge_v);
  polygon.add(middle + edge_u + edge_v);
  polygon.add(middle - edge_u + edge_v);
  return polygon;
}

/// @param out_of_b 1: the face belongs to b; -1: to a
int touchFace(const BearingFace& face, const PlacedSolid& other, double out_of_b, double gap, SurfaceContact* found) {
  constexpr double kLookAhead = 4e-3;  // m beyond the margin, so that a rocking box keeps its contacts
  constexpr double kTilted = 1e-3;     // rad: a smaller tilt does not decide over which corner a box topples
  Polygon polygon = faceAgainst(face, other);
  const Vector3d lowest = polygon.lowest();
  for (const double side : {-1.0, 1.0}) {
    polygon.cut(0, side, face.half.x());
    polygon.cut(1, side, face.half.y());
  }
  polygon.keepBelow(kMargin + kLookAhead);
  if (polygon.size() == 0) {
    // the boxes are also beside each other: a corner at an edge
    const Eigen::Vector2d beside = lowest.head<2>().cwiseMax(-face.half).cwiseMin(face.half);
    polygon.add({beside.x(), beside.y(), gap});
  } else {
    const Eigen::Vector2d uphill = face.axes.row(2).head<2>();
    polygon.keepSpread(kMostBoxContacts, kTilted * uphill);
  }
  int count = 0;
  for (const Vector3d& corner : polygon) {
    found[count++] = {face.middle + face.axes * corner, out_of_b * face.axes.col(2), -corner.z()};
  }
  return count;
}

/// The middle of the edge along one axis of a box that is farthest in a direction.
Vector3d edgeTowards(const PlacedSolid& box, int axis, const Vector3d& direction) {
  Vector3d place = box.centre;
  for (const int other : {(axis + 1) % 3, (axis + 2) % 3}) {
    place += sideOf(box.axes.col(other).dot(direction)) * box.half[other] * box.axes.col(other);
  }
  return place;
}

SurfaceContact touchEdges(const PlacedSolid& a, const PlacedSolid& b, const Axis& axis) {
  const Vector3d along_a = a.axes.col(axis.of_a);
  const Vector3d along_b = b.axes.col(axis.of_b);
  Vector3d normal = along_a.cross(along_b).normalized();
  normal *= -sideOf(normal.dot(b.centre - a.centre));
  const Vector3d on_a = edgeTowards(a, axis.of_a, -normal);
  const Vector3d on_b = edgeTowards(b, axis.of_b, normal);
  const Vector3d way = on_b - on_a;
  const double cosine = along_a.dot(along_b);
  const double sine_squared = along_a.cross(along_b).squaredNorm();
  const double half_a = a.half[axis.of_a];
  const double half_b = b.half[axis.of_b];
  const double at_a = std::clamp((along_a.dot(way) - cosine * along_b.dot(way)) / sine_squared, -half_a, half_a);
  const double at_b = std::clamp((cosine * along_a.dot(way) - along_b.dot(way)) / sine_squared, -half_b, half_b);
  return {0.5 * (on_a + at_a * along_a + on_b + at_b * along_b), normal, -axis.gap};
}

}  // namespace

int collideBoxes(const PlacedSolid& a, const PlacedSolid& b, double margin, SurfaceContact* found) {
  const Relative relative(a, b);
  const Axis axis = widestGap(a, b, relative, margin);
  if (axis.gap > margin) {
    return 0;
  }
  if (axis.of_b < 0) {
    return touchFace(BearingFace(a, axis.of_a, sideOf(relative.way[axis.of_a])), b, -1.0, axis.gap, found);
  }
  if (axis.of_a < 0) {
    return touchFace(BearingFace(b, axis.of_b, -sideOf(relative.way_in_b[axis.of_b])), a, 1.0, axis.gap, found);
  }
  found[0] = touchEdges(a, b, axis);
  return 1;
}

int collideBoxes(dGeomID geom_a, dGeomID geom_b, dContactGeom* found) {
  if (dGeomGetClass(geom_a) != dBoxClass || dGeomGetClass(geom_b) != dBoxClass) {
    return 0;
  }
  PlacedSolid a(geom_a);
  PlacedSolid b(geom_b);
  // the growth makes contacts early, but carries no load
  a.half.array() -= kMargin / 2.0;
  b.half.array() -= kMargin / 2.0;
  std::array<SurfaceContact, kMostBoxContacts> contacts;
  const int count = collideBoxes(a, b, kMargin, contacts.data());
  for (int i = 0; i < count; ++i) {
    SurfaceContact& contact = contacts[static_cast<std::size_t>(i)];
    contact.depth += kMargin;
    found[i] = geometryOf(contact, geom_a, geom_b);
  }
  return count;
}

}  // namespace swarmanoid::dynamics3d
