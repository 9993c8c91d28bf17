// <heightfield>: the arena's rough ground, from an image.
#include <stdexcept>

#include "../images/read_terrain.hpp"
#include "reader.hpp"
#include "swarmanoid_space/models/limits.hpp"

namespace swarmanoid::experiment {

void readHeightfield(const XmlElement& element, Reader& reader) {
  ArenaDescription& arena = reader.experiment.arena;
  if (arena.terrain) {
    element.refuse("found a second <heightfield>, allowed: one");
  }
  element.allowAttributes(attributesOf("arena/heightfield"));
  const Configuration values = readParameters(element, heightfieldParameters());
  const Eigen::Vector2d size = values.vector2("size");
  const std::string file = values.text("file");
  try {
    arena.terrain = std::make_shared<const Terrain>(
        readTerrain(takeFile(file, reader), values.vector3("position"), size, values.number("height")));
  } catch (const std::runtime_error& error) {
    element.child("file")->refuse("file: found '" + file + "', which " + error.what() +
                                  "; allowed: a grey PNG image of 8 or 16 bits, 2 x 2 to 4096 x 4096 pixels");
  }
  const double least_x = limits::kLeastTerrainStep * (arena.terrain->columns() - 1);
  const double least_y = limits::kLeastTerrainStep * (arena.terrain->rows() - 1);
  if (!(size.x() >= least_x && size.y() >= least_y)) {
    element.child("size")->refuse("size: found '" + values.text("size") + "', allowed: 1 mm a pixel, here at least " +
                                  numberText(least_x) + ", " + numberText(least_y));
  }
}

}  // namespace swarmanoid::experiment
