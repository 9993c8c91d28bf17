// Markers of the floor: an image, patches, holes, paint. Each is a little higher than the one that it covers, to avoid
// flicker in rviz.
#include <algorithm>
#include <array>
#include <cmath>

#include "marker.hpp"
#include "swarmanoid_recording/messages/world_state.hpp"

namespace swarmanoid {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr double kThickness = 0.001;
constexpr double kImageHeight = -0.0012;  // of the middle, m
constexpr double kPaintHeight = 0.0016;

/// @param middle of the area [m]
Marker areaMarker(const FloorArea& area, const Eigen::Vector3d& middle, double thickness, Color color,
                  const std_msgs::Header& header, const char* name, int id) {
  const bool is_disc = area.radius > 0.0;
  const Eigen::Vector3d scale = is_disc ? Eigen::Vector3d(2.0 * area.radius, 2.0 * area.radius, thickness)
                                        : Eigen::Vector3d(area.size.x(), area.size.y(), thickness);
  Marker marker = makeMarker(header, name, id, is_disc ? Marker::CYLINDER : Marker::CUBE, scale, opaque(color));
  marker.pose.position = toMessage(middle);
  return marker;
}

void addPatches(const Space& space, const std_msgs::Header& header, MarkerArray& markers) {
  constexpr double kPatchThickness = 0.002;
  int id = 0;
  for (const FloorPatch& patch : space.floor.patches) {
    markers.markers.push_back(
        areaMarker(patch, patch.position, kPatchThickness, patch.color, header, "floor_patches", id++));
  }
}

void addHoles(const Space& space, const std_msgs::Header& header, MarkerArray& markers) {
  constexpr double kHoleHeight = 0.002;
  int id = 0;
  for (const FloorHole& hole : space.floor.holes) {
    const Eigen::Vector3d middle(hole.position.x(), hole.position.y(), kHoleHeight);
    markers.markers.push_back(areaMarker(hole, middle, kThickness, colors::kBlack, header, "floor_holes", id++));
  }
}

/// A rectangle of pixels; the ends are exclusive.
struct Block {
  int first_column, end_column, first_row, end_row;
};

/// Mean colour of a block. @return false if most of it is transparent
bool meanColor(const FloorImage& image, const Block& block, std_msgs::ColorRGBA& mean) {
  std::array<int, 3> sum{};
  int count = 0;
  for (int row = block.first_row; row < block.end_row; ++row) {
    for (int column = block.first_column; column < block.end_column; ++column) {
      const auto pixel = static_cast<std::size_t>(row * image.columns + column);
      if (image.is_opaque[pixel] != 0) {
        sum[0] += image.colors[pixel].red;
        sum[1] += image.colors[pixel].green;
        sum[2] += image.colors[pixel].blue;
        ++count;
      }
    }
  }
  const int pixels = (block.end_row - block.first_row) * (block.end_column - block.first_column);
  if (2 * count < pixels) {
    return false;
  }
  const auto channel = [&](int value) { return static_cast<float>(value) / (255.0F * static_cast<float>(count)); };
  mean = rgba(channel(sum[0]), channel(sum[1]), channel(sum[2]), 1.0F);
  return true;
}

/// Marker of at most kMost x kMost squares, for any number of pixels.
Marker imageMarker(const FloorImage& image, const std_msgs::Header& header) {
  constexpr int kMost = 128;
  const int step = (std::max(image.columns, image.rows) + kMost - 1) / kMost;
  const Eigen::Vector2d pixel(image.size.x() / image.columns, image.size.y() / image.rows);
  Marker marker = makeMarker(header, "floor_image", 0, Marker::CUBE_LIST,
                             {step * pixel.x(), step * pixel.y(), kThickness}, rgba(1.0F, 1.0F, 1.0F, 1.0F));
  for (int row = 0; row < image.rows; row += step) {
    for (int column = 0; column < image.columns; column += step) {
      // all squares have one size: those at the right and lower edge are moved inwards
      const Block block{std::max(0, std::min(column, image.columns - step)), std::min(column + step, image.columns),
                        std::max(0, std::min(row, image.rows - step)), std::min(row + step, image.rows)};
      std_msgs::ColorRGBA mean;
      if (meanColor(image, block, mean)) {
        const double x = image.corner.x() + (block.first_column + 0.5 * step) * pixel.x();
        const double y = image.corner.y() + image.size.y() - (block.first_row + 0.5 * step) * pixel.y();
        marker.points.push_back(toMessage(Eigen::Vector3d(x, y, kImageHeight)));
        marker.colors.push_back(mean);
      }
    }
  }
  return marker;
}

}  // namespace

void addFloorColors(const Space& space, const std_msgs::Header& header, MarkerArray& markers) {
  if (space.floor.image) {
    Marker image = imageMarker(*space.floor.image, header);
    if (!image.points.empty()) {
      markers.markers.push_back(std::move(image));
    }
  }
  addPatches(space, header, markers);
  addHoles(space, header, markers);
}

Marker paintMarker(const Space& space, const std_msgs::Header& header) {
  constexpr double kMostSquares = 20000.0;
  const PaintLayer& paint = space.floor.paint;
  const int step =
      std::max(1, static_cast<int>(std::ceil(std::sqrt(static_cast<double>(paint.spotCount()) / kMostSquares))));
  const double side = step * paint.cellSize();
  Marker marker =
      makeMarker(header, "paint", 0, Marker::CUBE_LIST, {side, side, kThickness}, rgba(1.0F, 1.0F, 1.0F, 1.0F));
  for (std::size_t i = 0; i < paint.spotCount(); ++i) {
    if (paint.columnOf(i) % step != 0 || paint.rowOf(i) % step != 0) {
      continue;
    }
    const PaintLayer::Spot spot = paint.spot(i, space.tick);
    if (spot.strength > 0.0) {
      marker.points.push_back(toMessage(Eigen::Vector3d(spot.position.x(), spot.position.y(), kPaintHeight)));
      std_msgs::ColorRGBA color = opaque(spot.color);
      color.a = static_cast<float>(spot.strength);
      marker.colors.push_back(color);
    }
  }
  return marker;
}

}  // namespace swarmanoid
