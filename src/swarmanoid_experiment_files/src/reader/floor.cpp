// The arena's floor: patches, holes, an image, and the paint layer.
#include <stdexcept>

#include "../images/read_png.hpp"
#include "reader.hpp"

namespace swarmanoid::experiment {
namespace {

/// @return all values of the element
Configuration readArea(const XmlElement& element, const std::vector<Parameter>& table, Reader& reader,
                       FloorArea& area) {
  element.allowAttributes(attributesOf("arena/" + element.name()));
  area.location = element.location();
  area.id = element.requireAttribute("id");
  reader.takeId("entity", area.id, element);
  Configuration values = readParameters(element, table);
  area.position = values.vector3("position");
  area.radius = values.number("radius");
  area.size = values.vector2("size");
  const bool has_size = area.size != Eigen::Vector2d::Zero();
  if ((area.radius > 0.0) == has_size || (has_size && !(area.size.minCoeff() > 0.0))) {
    element.refuse(element.name() + " '" + area.id + "': found radius '" + values.text("radius") + "' and size '" +
                   values.text("size") + "', allowed: one of them greater than 0");
  }
  return values;
}

}  // namespace

void readFloorPatch(const XmlElement& element, Reader& reader) {
  FloorPatch patch;
  patch.color = readArea(element, floorPatchParameters(), reader, patch).color("color");
  reader.experiment.arena.floor.patches.push_back(patch);
}

void readHole(const XmlElement& element, Reader& reader) {
  FloorHole hole;
  readArea(element, holeParameters(), reader, hole);
  reader.experiment.arena.floor.holes.push_back(hole);
}

void readFloorImage(const XmlElement& element, Reader& reader) {
  Floor& floor = reader.experiment.arena.floor;
  if (floor.image) {
    element.refuse("found a second <floor_image>, allowed: one");
  }
  element.allowAttributes(attributesOf("arena/floor_image"));
  const Configuration values = readParameters(element, floorImageParameters());
  const std::string file = values.text("file");
  auto image = std::make_shared<FloorImage>();
  image->size = values.vector2("size");
  image->corner = values.vector3("position").head<2>() - 0.5 * image->size;
  try {
    ColorImage pixels = readColorPng(takeFile(file, reader));
    image->columns = pixels.columns;
    image->rows = pixels.rows;
    image->colors = std::move(pixels.colors);
    image->is_opaque = std::move(pixels.is_opaque);
  } catch (const std::runtime_error& error) {
    element.child("file")->refuse("file: found '" + file + "', which " + error.what() +
                                  "; allowed: a PNG image, 2 x 2 to 4096 x 4096 pixels");
  }
  floor.image = std::move(image);
}

void readFloorPaint(const XmlElement& element, Reader& reader) {
  ArenaDescription& arena = reader.experiment.arena;
  if (arena.paint) {
    element.refuse("found a second <floor_paint>, allowed: one");
  }
  element.allowAttributes(attributesOf("arena/floor_paint"));
  const Configuration values = readParameters(element, floorPaintParameters());
  arena.paint = PaintDescription{values.number("cell"), values.number("half_life")};
  const double cells = PaintLayer::cellsFor(arena.size.head<2>(), arena.paint->cell);
  if (cells > static_cast<double>(PaintLayer::kMostCells)) {
    element.child("cell").value_or(element).refuse(
        "cell: found '" + values.text("cell") + "', of which the arena has " + numberText(cells) +
        ", allowed: at most " + std::to_string(PaintLayer::kMostCells) + " cells");
  }
}

}  // namespace swarmanoid::experiment
