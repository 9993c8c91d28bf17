// Names and states of robots, as text above them that overlaps neither other text nor other robots.
#include <algorithm>
#include <cmath>

#include "marker.hpp"
#include "swarmanoid_recording/messages/world_state.hpp"

namespace swarmanoid {
namespace {

using Eigen::Vector3d;
using visualization_msgs::Marker;

/// Overlaps are avoided in the picture of a camera that looks from the south and down by kPitch, the initial view of
/// view.py; in other views texts may overlap.
constexpr double kPitch = 0.85;  // rad
Vector3d upInPicture() { return {0.0, std::sin(kPitch), std::cos(kPitch)}; }
Vector3d towardsCamera() { return {0.0, -std::cos(kPitch), std::sin(kPitch)}; }

constexpr double kAntenna = 0.2;  // m; maximum height of antennas above the shapes

/// Part of the picture [m]: x to the right, y up.
using Area = Eigen::AlignedBox2d;

Area areaAround(const Vector3d& place, double width, double height) {
  const Eigen::Vector2d middle(place.x(), upInPicture().dot(place));
  const Eigen::Vector2d half(0.5 * width, 0.5 * height);
  return {middle - half, middle + half};
}

bool overlap(const Area& a, const Area& b) {
  constexpr double kTouching = 1e-6;  // m; no overlap yet
  return (a.min().array() + kTouching < b.max().array()).all() && (b.min().array() + kTouching < a.max().array()).all();
}

/// The label of one robot.
struct Label {
  Marker marker;
  Vector3d place;   // middle of the text when the place is free
  Vector3d anchor;  // the robot's top
  double width = 0.0;
  double height = 0.0;
};

/// Returns the text height [m], a fixed fraction of the arena's size in the picture, because users look at the whole
/// arena.
double textHeight(const Space& space) {
  const Vector3d up = upInPicture();
  constexpr double kPart = 0.032;
  constexpr double kAspect = 1.5;  // of the picture: the camera is closer to a wide arena than to a deep one
  const double height = std::min(space.farCorner().z(), space.size.head<2>().maxCoeff());
  return kPart * std::max(space.size.x() / kAspect, up.y() * space.size.y() + up.z() * height);
}

/// Returns the area of a robot, up to the tips of its antennas.
Area bodyArea(const EntityModel& model, const Pose& pose) {
  const double radius = model.shapes.empty() ? 0.1 : model.shapes.front().half_extent.head<2>().maxCoeff();
  Area area =
      areaAround(pose.position + Vector3d(0.0, 0.0, model.lowest), 2.0 * radius, 2.0 * radius * upInPicture().y());
  area.extend(Eigen::Vector2d(pose.position.x(),
                              upInPicture().dot(pose.position + Vector3d(0.0, 0.0, model.highest + kAntenna))));
  return area;
}

Label labelOf(const Space& space, Row row, const std_msgs::Header& header) {
  constexpr double kLine = 1.15;      // height of a line, as a multiple of the text height
  constexpr double kCharacter = 0.5;  // upper bound of the mean width of characters, same unit
  const double text_height = textHeight(space);
  Label label;
  label.marker = makeMarker(header, "labels", static_cast<int>(space.entities.number[row]), Marker::TEXT_VIEW_FACING,
                            {0.0, 0.0, text_height}, rgba(0.05F, 0.07F, 0.1F, 1.0F));
  std::string& text = label.marker.text;
  text = space.entities.name[row];
  std::size_t lines = 1;
  std::size_t longest = text.size();
  if (const auto& robot = space.robots[row]) {
    for (const auto& [key, value] : robot->debugValues()) {
      text += "\n" + value;
      longest = std::max(longest, value.size());
      ++lines;
    }
  }
  label.width = kCharacter * text_height * static_cast<double>(longest);
  label.height = kLine * text_height * static_cast<double>(lines);
  const Pose& pose = space.entities.pose[row];
  label.anchor = pose.toWorld(Vector3d(0.0, 0.0, space.entities.model[row]->highest));
  label.place = pose.toWorld(Vector3d(0.0, 0.0, space.entities.model[row]->highest + kAntenna));
  label.place.z() += 0.5 * label.height / upInPicture().z();
  return label;
}

/// Returns the lowest place at or above this one where the label does not overlap any taken area.
Vector3d freePlaceAbove(Vector3d place, const Label& label, const std::vector<Area>& taken) {
  // areas below the label cannot overlap it again
  for (std::size_t tries = taken.size(); tries > 0; --tries) {
    const Area area = areaAround(place, label.width, label.height);
    const auto other = std::find_if(taken.begin(), taken.end(), [&](const Area& one) { return overlap(area, one); });
    if (other == taken.end()) {
      break;
    }
    place.z() += (other->max().y() - area.min().y()) / upInPicture().z();
  }
  return place;
}

/// Returns whether a fixed entity hides this place from the camera.
bool isHidden(const Space& space, const Vector3d& place) {
  for (const Row row : space.entities.order) {
    if (space.entities.model[row]->is_movable || isBoundary(space, row)) {
      continue;
    }
    const Pose& pose = space.entities.pose[row];
    for (const CollisionShape& shape : space.entities.model[row]->shapes) {
      // for each axis of the shape the ray towards the camera is between the two faces over an interval of distances
      const Eigen::Quaterniond turn = (pose.orientation * shape.orientation).conjugate();
      const Vector3d from = turn * (place - pose.position - pose.orientation * shape.position);
      const Eigen::Array3d direction = turn * towardsCamera();
      const Eigen::Array3d a = (shape.half_extent - from).array() / direction;
      const Eigen::Array3d b = (-shape.half_extent - from).array() / direction;
      if (std::max(0.0, a.min(b).maxCoeff()) <= a.max(b).minCoeff() && !isOverhead(space, row, shape)) {
        return true;
      }
    }
  }
  return false;
}

/// Returns the best of the free places above the label's own place and above the places to its left and right: if all
/// labels rose, those of a crowd would leave the picture. No label leaves the arena sideways.
Vector3d freePlace(const Space& space, const Label& label, const std::vector<Area>& taken) {
  const auto badness = [&](const Vector3d& place) {
    constexpr double kHidden = 1e3;  // m
    const Eigen::Vector2d away(place.x() - label.place.x(), upInPicture().dot(place - label.place));
    double sum = away.norm();
    for (const double part : {-0.5, -0.25, 0.0, 0.25, 0.5}) {
      sum += isHidden(space, place + Vector3d(part * label.width, 0.0, 0.0)) ? kHidden : 0.0;
    }
    return sum;
  };
  constexpr double kBetter = 0.01;  // m; minimum gain, so that rounding does not alternate between equally good places
  Vector3d best = freePlaceAbove(label.place, label, taken);
  double least = badness(best);
  for (const double column : {-0.5, 0.5, -1.0, 1.0}) {
    const Vector3d beside = label.place + Vector3d(column * label.width, 0.0, 0.0);
    const Vector3d place = freePlaceAbove(beside, label, taken);
    const double margin = 0.5 * label.width;
    const bool is_inside = place.x() > space.corner.x() + margin && place.x() < space.farCorner().x() - margin;
    if (is_inside && badness(place) < least - kBetter) {
      best = place;
      least = badness(place);
    }
  }
  return best;
}

}  // namespace

void addLabels(const Space& space, const std_msgs::Header& header, visualization_msgs::MarkerArray& markers) {
  std::vector<Area> taken;
  std::vector<Label> labels;
  for (const Row row : space.entities.order) {
    if (space.entities.model[row]->is_robot) {
      taken.push_back(bodyArea(*space.entities.model[row], space.entities.pose[row]));
      labels.push_back(labelOf(space, row, header));
    }
  }
  // from bottom to top: labels that are moved rise above those in their own place
  std::stable_sort(labels.begin(), labels.end(), [](const Label& a, const Label& b) {
    return upInPicture().dot(a.place) < upInPicture().dot(b.place);
  });
  constexpr double kLineWidth = 0.06;  // as a fraction of the text height
  Marker lines = makeMarker(header, "label_lines", 0, Marker::LINE_LIST, {kLineWidth * textHeight(space), 0.0, 0.0},
                            rgba(0.05F, 0.07F, 0.1F, 0.5F));
  for (Label& label : labels) {
    const Vector3d place = freePlace(space, label, taken);
    taken.push_back(areaAround(place, label.width, label.height));
    lines.points.push_back(toMessage(label.anchor));
    lines.points.push_back(toMessage(Vector3d(place - Vector3d(0.0, 0.0, 0.5 * label.height / upInPicture().z()))));
    label.marker.pose.position = toMessage(place);
    markers.markers.push_back(std::move(label.marker));
  }
  if (!lines.points.empty()) {
    markers.markers.push_back(std::move(lines));
  }
}

}  // namespace swarmanoid
