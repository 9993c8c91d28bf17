#include "swarmanoid_interface/list_sectors.hpp"

#include <sstream>

namespace swarmanoid {
namespace {

/// The direction of an element: its first angle that wraps around. @return null if it has none
const FieldPlaces* directionIn(const DeviceType& type, const ListPlaces& list) {
  const auto& fields = list.elements.fields;
  const auto found = std::find_if(fields.begin(), fields.end(), [&](const FieldPlaces& field) {
    return type.fields[field.description].wraps && field.shape.empty();
  });
  return found == fields.end() ? nullptr : &*found;
}

NumberPlace placeIn(const DeviceType& type, const FieldPlaces& field) {
  const FieldDescription& description = type.fields[field.description];
  return {field.offsets[0], field.type, description.wraps, description.is_distance, description.range};
}

}  // namespace

Range scalingBoundsOf(const FieldDescription& field) {
  if (field.wraps) {
    return {-M_PI, M_PI};
  }
  const bool is_bounded = std::isfinite(field.range.minimum) || std::isfinite(field.range.maximum);
  if (field.type == "b1") {
    return {0.0, 1.0};
  }
  if (field.type == "u1" && !is_bounded) {
    return {0.0, 255.0};
  }
  if (field.type == "i1" && !is_bounded) {
    return {-128.0, 127.0};
  }
  return field.range;
}

std::vector<Color> colorsIn(const Configuration& parameters, std::string_view key) {
  std::vector<Color> colors;
  const Configuration* element = parameters.find(key);
  std::istringstream names(element == nullptr ? "" : element->text());
  for (std::string name; std::getline(names >> std::ws, name, ',');) {
    colors.push_back(parseColorOrThrow(name, std::string(key), element->location()));
  }
  return colors;
}

std::string ListSectors::reasonAgainst(const DeviceType& type, const ListPlaces& list, const FieldPlaces& field,
                                       bool has_colors) {
  if (directionIn(type, list) == nullptr || !field.shape.empty()) {
    return "a single number beside a direction all around";
  }
  return has_colors && list.elements.findField("color.red") == nullptr ? "without colors, which its elements lack" : "";
}

FirstElements::FirstElements(const ListPlaces& list, const FieldPlaces& field, std::size_t count, Range range,
                             bool is_near)
    : elements_(count), range_(range), is_near_(is_near), offset_(list.offset), access_(list.access) {
  for (const std::size_t offset : field.offsets) {
    places_.push_back({offset, field.type, false, false, {}});
  }
}

ListSectors::ListSectors(const DeviceType& type, const ListPlaces& list, const FieldPlaces& field,
                         const Options& options)
    : options_(options),
      offset_(list.offset),
      access_(list.access),
      direction_(placeIn(type, *directionIn(type, list))),
      value_(placeIn(type, field)) {
  if (!options_.colors.empty()) {
    red_ = list.elements.findField("color.red")->offsets[0];
    green_ = list.elements.findField("color.green")->offsets[0];
    blue_ = list.elements.findField("color.blue")->offsets[0];
  }
}

}  // namespace swarmanoid
