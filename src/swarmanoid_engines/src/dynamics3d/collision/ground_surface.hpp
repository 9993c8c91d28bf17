/// Ground that is not level, for contacts: a terrain, the level ground around it, and the cliffs between them.
///
/// The level ground ends at the terrain's rectangle, so lower terrain is a hole. Below the surface the ground is solid
/// all the way down. Frame W.
#pragma once

#include <memory>
#include <optional>

#include "swarmanoid_space/rays/terrain.hpp"

namespace swarmanoid::dynamics3d {

class GroundSurface {
 public:
  using Triangle = Terrain::Triangle;

  /// The ground above or below a point.
  struct Column {
    double height;
    Eigen::Vector3d normal;
  };
  /// A convex edge between two parts of the surface.
  struct Ridge {
    Eigen::Vector3d from;
    Eigen::Vector3d to;
    Eigen::Vector3d out;  ///< out of the ground, midway between the normals of both parts
  };

  GroundSurface() = default;
  /// @param level height of the level ground; nullopt: there is none
  GroundSurface(std::shared_ptr<const Terrain> terrain, std::optional<double> level)
      : terrain_(std::move(terrain)), level_(level) {}

  /// Whether any part of the box is above or below the terrain's rectangle; otherwise only the level ground counts.
  bool isRoughAt(const Eigen::AlignedBox3d& box) const {
    return terrain_ != nullptr && terrain_->cellsIn(box.min().head<2>(), box.max().head<2>()).high.x() >= 0;
  }
  /// The largest height of the ground above or below the box. @pre isRoughAt(box)
  double highestAt(const Eigen::AlignedBox3d& box) const;
  /// Nullopt where there is no ground.
  std::optional<Column> columnAt(const Eigen::Vector3d& point) const;
  /// Height of the level ground above or below a point; nullopt where there is none.
  std::optional<double> levelAt(const Eigen::Vector3d& point) const {
    return terrain_->contains(point.x(), point.y()) ? std::nullopt : level_;
  }

  // Visits those that the box may touch. @pre isRoughAt(box)
  template <class Visit>  // void visit(const Triangle&)
  void visitTriangles(const Eigen::AlignedBox3d& box, Visit visit) const;
  template <class Visit>  // void visit(const Triangle&): of cliffs; normals towards the lower ground
  void visitCliffs(const Eigen::AlignedBox3d& box, Visit visit) const;
  template <class Visit>  // void visit(const Ridge&)
  void visitRidges(const Eigen::AlignedBox3d& box, Visit visit) const;

 private:
  /// An edge between two vertices on the terrain's rim.
  struct RimEdge {
    Eigen::Vector3d from;
    Eigen::Vector3d to;
    Eigen::Vector3d outwards;  ///< along x or y
    Triangle inside;           ///< triangle of the terrain
  };

  Terrain::Cells cellsIn(const Eigen::AlignedBox3d& box) const {
    return terrain_->cellsIn(box.min().head<2>(), box.max().head<2>());
  }
  /// Height at which cliffs meet the level ground; without level ground, a height below the whole terrain.
  double foot() const;
  template <class Visit>  // void visit(const RimEdge&)
  void visitRim(const Eigen::AlignedBox3d& box, Visit visit) const;
  template <class Visit>
  static void visitIfRidge(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Triangle& a, const Triangle& b,
                           Visit visit);

  std::shared_ptr<const Terrain> terrain_;
  std::optional<double> level_;
};

template <class Visit>
void GroundSurface::visitTriangles(const Eigen::AlignedBox3d& box, Visit visit) const {
  const Terrain::Cells cells = cellsIn(box);
  for (int j = cells.low.y(); j <= cells.high.y(); ++j) {
    for (int i = cells.low.x(); i <= cells.high.x(); ++i) {
      visit(terrain_->triangle(i, j, 0));
      visit(terrain_->triangle(i, j, 1));
    }
  }
}

template <class Visit>
void GroundSurface::visitRim(const Eigen::AlignedBox3d& box, Visit visit) const {
  const Terrain& terrain = *terrain_;
  const Terrain::Cells cells = cellsIn(box);
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX();
  const Eigen::Vector3d y = Eigen::Vector3d::UnitY();
  const int right = terrain.columns() - 1;
  const int top = terrain.rows() - 1;
  for (int i = cells.low.x(); i <= cells.high.x(); ++i) {
    if (cells.low.y() == 0) {
      visit(RimEdge{terrain.vertex(i, 0), terrain.vertex(i + 1, 0), -y, terrain.triangle(i, 0, 0)});
    }
    if (cells.high.y() == top - 1) {
      visit(RimEdge{terrain.vertex(i, top), terrain.vertex(i + 1, top), y, terrain.triangle(i, top - 1, 1)});
    }
  }
  for (int j = cells.low.y(); j <= cells.high.y(); ++j) {
    if (cells.low.x() == 0) {
      visit(RimEdge{terrain.vertex(0, j), terrain.vertex(0, j + 1), -x, terrain.triangle(0, j, 1)});
    }
    if (cells.high.x() == right - 1) {
      visit(RimEdge{terrain.vertex(right, j), terrain.vertex(right, j + 1), x, terrain.triangle(right - 1, j, 0)});
    }
  }
}

template <class Visit>
void GroundSurface::visitCliffs(const Eigen::AlignedBox3d& box, Visit visit) const {
  constexpr double kLeast = 1e-9;  // m: lower steps are no cliffs
  const double foot = this->foot();
  visitRim(box, [&](const RimEdge& edge) {
    const double from = edge.from.z() - foot;
    const double to = edge.to.z() - foot;
    if (std::abs(from) < kLeast && std::abs(to) < kLeast) {
      return;
    }
    const Eigen::Vector3d normal = from + to < 0.0 ? Eigen::Vector3d(-edge.outwards) : edge.outwards;
    const Eigen::Vector3d foot_from(edge.from.x(), edge.from.y(), foot);
    const Eigen::Vector3d foot_to(edge.to.x(), edge.to.y(), foot);
    visit(Triangle{{edge.from, edge.to, foot_to}, normal});
    visit(Triangle{{edge.from, foot_to, foot_from}, normal});
  });
}

template <class Visit>
void GroundSurface::visitIfRidge(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Triangle& a,
                                 const Triangle& b, Visit visit) {
  constexpr double kFlat = 1e-9;  // m: depth of the second triangle below the plane of the first one
  double rise = 0.0;
  for (const Eigen::Vector3d& corner : b.corners) {
    rise = std::min(rise, a.normal.dot(corner - from));
  }
  if (rise < -kFlat) {
    visit(Ridge{from, to, (a.normal + b.normal).normalized()});
  }
}

template <class Visit>
void GroundSurface::visitRidges(const Eigen::AlignedBox3d& box, Visit visit) const {
  const Terrain& terrain = *terrain_;
  const Terrain::Cells cells = cellsIn(box);
  for (int j = cells.low.y(); j <= cells.high.y(); ++j) {
    for (int i = cells.low.x(); i <= cells.high.x(); ++i) {
      const Triangle lower = terrain.triangle(i, j, 0);
      const Triangle upper = terrain.triangle(i, j, 1);
      visitIfRidge(lower.corners[0], lower.corners[2], lower, upper, visit);
      if (j > 0) {
        visitIfRidge(lower.corners[0], lower.corners[1], lower, terrain.triangle(i, j - 1, 1), visit);
      }
      if (i > 0) {
        visitIfRidge(upper.corners[0], upper.corners[2], upper, terrain.triangle(i - 1, j, 0), visit);
      }
    }
  }
  visitRim(box, [&](const RimEdge& edge) {
    const double rise = 0.5 * (edge.from.z() + edge.to.z()) - foot();
    if (rise > 0.0) {
      visit(Ridge{edge.from, edge.to, (edge.inside.normal + edge.outwards).normalized()});
    } else if (rise < 0.0) {
      const Eigen::Vector3d from(edge.from.x(), edge.from.y(), foot());
      const Eigen::Vector3d to(edge.to.x(), edge.to.y(), foot());
      visit(Ridge{from, to, (Eigen::Vector3d::UnitZ() - edge.outwards).normalized()});
    }
  });
}

}  // namespace swarmanoid::dynamics3d
