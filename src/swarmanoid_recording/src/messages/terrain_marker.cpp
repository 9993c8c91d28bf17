// The terrain, as triangles coloured by their height, and the cliffs at its rim.
#include <algorithm>
#include <array>

#include "marker.hpp"
#include "swarmanoid_recording/messages/world_state.hpp"

namespace swarmanoid {
namespace {

using Eigen::Vector3d;

/// Returns a colour from dark green at the bottom over ochre to nearly white at the top. @param level 0 to 1
Vector3d colorOf(double level) {
  static const std::array<Vector3d, 4> colors{Vector3d(0.20, 0.32, 0.24), Vector3d(0.45, 0.55, 0.33),
                                              Vector3d(0.76, 0.66, 0.46), Vector3d(0.95, 0.94, 0.90)};
  const double place = level * static_cast<double>(colors.size() - 1);
  const std::size_t first = std::min(static_cast<std::size_t>(place), colors.size() - 2);
  const double part = place - static_cast<double>(first);
  return (1.0 - part) * colors[first] + part * colors[first + 1];
}

class TerrainDrawing {
 public:
  TerrainDrawing(const Terrain& terrain, visualization_msgs::Marker& marker) : terrain_(terrain), marker_(marker) {
    for (int i = 0; i < terrain.columns() - 1; i += stride()) {
      columns_.push_back(i);
    }
    for (int j = 0; j < terrain.rows() - 1; j += stride()) {
      rows_.push_back(j);
    }
    columns_.push_back(terrain.columns() - 1);
    rows_.push_back(terrain.rows() - 1);
  }

  void drawSurface() {
    for (std::size_t j = 0; j + 1 < rows_.size(); ++j) {
      for (std::size_t i = 0; i + 1 < columns_.size(); ++i) {
        drawTriangle(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
        drawTriangle(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
      }
    }
  }
  void drawCliffs() {
    const std::size_t right = columns_.size() - 1;
    const std::size_t top = rows_.size() - 1;
    for (std::size_t i = 0; i < right; ++i) {
      drawCliff(vertex(i, 0), vertex(i + 1, 0));
      drawCliff(vertex(i + 1, top), vertex(i, top));
    }
    for (std::size_t j = 0; j < top; ++j) {
      drawCliff(vertex(0, j + 1), vertex(0, j));
      drawCliff(vertex(right, j), vertex(right, j + 1));
    }
  }

 private:
  /// Step between drawn vertices: large terrains are thinned out, because a message must not be too long for rviz.
  int stride() const {
    constexpr int kMostCells = 256;  // along a side
    return (std::max(terrain_.columns(), terrain_.rows()) - 2) / kMostCells + 1;
  }
  Vector3d vertex(std::size_t i, std::size_t j) const { return terrain_.vertex(columns_[i], rows_[j]); }

  void drawCliff(const Vector3d& a, const Vector3d& b) {
    if (a.z() == 0.0 && b.z() == 0.0) {
      return;
    }
    const Vector3d foot_a(a.x(), a.y(), 0.0);
    const Vector3d foot_b(b.x(), b.y(), 0.0);
    drawTriangle(foot_a, foot_b, b);
    drawTriangle(foot_a, b, a);
  }
  /// Adds a triangle, shaded as in sunlight, because rviz does not shade lists; level ground keeps its colour.
  void drawTriangle(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    static const Vector3d sun = Vector3d(-0.5, 0.35, 0.8);
    constexpr double kShade = 0.35;
    const Vector3d across = (b - a).cross(c - a);
    const double length = across.norm();
    const double light = length > 0.0 ? std::max(kShade, across.dot(sun) / (length * sun.z())) : 1.0;
    const double low = terrain_.bounds().min().z();
    const double range = std::max(terrain_.bounds().max().z() - low, 1e-9);
    for (const Vector3d& corner : {a, b, c}) {
      const Vector3d color = (light * colorOf(std::clamp((corner.z() - low) / range, 0.0, 1.0))).cwiseMin(1.0);
      marker_.points.push_back(toMessage(corner));
      marker_.colors.push_back(
          rgba(static_cast<float>(color.x()), static_cast<float>(color.y()), static_cast<float>(color.z()), 1.0F));
    }
  }

  const Terrain& terrain_;
  visualization_msgs::Marker& marker_;
  std::vector<int> columns_;  // drawn ones
  std::vector<int> rows_;
};

}  // namespace

visualization_msgs::Marker terrainMarker(const std_msgs::Header& header, const Terrain& terrain) {
  visualization_msgs::Marker marker = makeMarker(header, "terrain", 0, visualization_msgs::Marker::TRIANGLE_LIST,
                                                 Vector3d::Ones(), rgba(1.0F, 1.0F, 1.0F, 1.0F));
  TerrainDrawing drawing(terrain, marker);
  drawing.drawSurface();
  drawing.drawCliffs();
  return marker;
}

}  // namespace swarmanoid
