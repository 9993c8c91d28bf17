// Grid lines with the length and width of the floor: rviz's own grid is always square.
#include <algorithm>
#include <cmath>

#include "marker.hpp"
#include "swarmanoid_recording/messages/world_state.hpp"

namespace swarmanoid {
namespace {

/// Returns the smallest of 0.1, 0.2, 0.5, 1, 2, 5, ... that divides a side into few enough cells [m].
double cellLength(double side) {
  constexpr double kMostCells = 13.0;
  for (double decade = 0.1;; decade *= 10.0) {
    for (const double digit : {1.0, 2.0, 5.0}) {
      if (side <= kMostCells * digit * decade) {
        return digit * decade;
      }
    }
  }
}

}  // namespace

visualization_msgs::Marker gridMarker(const std_msgs::Header& header, const Eigen::Vector2d& size,
                                      const std::vector<Eigen::AlignedBox2d>& parts) {
  constexpr double kWidth = 0.0015;  // of lines, as a fraction of the longer side: visible when the whole floor is
  constexpr double kHeight = 0.002;  // m; above patches, to avoid flicker in rviz
  const double side = size.maxCoeff();
  const double cell = cellLength(side);
  visualization_msgs::Marker grid = makeMarker(header, "grid", 0, visualization_msgs::Marker::LINE_LIST,
                                               {kWidth * side, 0.0, 0.0}, rgba(0.47F, 0.5F, 0.55F, 0.5F));
  for (const Eigen::AlignedBox2d& part : parts) {
    for (const int along : {0, 1}) {
      const int across = 1 - along;
      constexpr double kRounding = 1e-9;
      const double first = std::ceil(part.min()[across] / cell - kRounding);
      for (double count = first; count * cell <= part.max()[across] + kRounding; count += 1.0) {
        for (const double end : {part.min()[along], part.max()[along]}) {
          Eigen::Vector3d point(0.0, 0.0, kHeight);
          point[along] = end;
          point[across] = count * cell;
          grid.points.push_back(toMessage(point));
        }
      }
    }
  }
  return grid;
}

}  // namespace swarmanoid
