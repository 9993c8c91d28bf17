// <arena>: entities, floor and terrain.
#include <algorithm>
#include <cmath>

#include "reader.hpp"
#include "swarmanoid_interface/contains.hpp"
#include "swarmanoid_space/experiment/entity_parameters.hpp"
#include "swarmanoid_space/experiment/entity_validation.hpp"
#include "swarmanoid_space/models/entity_type.hpp"
#include "swarmanoid_space/models/limits.hpp"

namespace swarmanoid::experiment {
namespace {

constexpr double kRadPerDeg = M_PI / 180.0;

std::vector<std::string> childrenOfArena(const XmlElement& section) {
  std::vector<std::string> tags = entityTagsIn(section);
  for (const std::string& other : tagsIn("arena")) {
    if (!contains(tags, other)) {
      tags.push_back(other);
    }
  }
  return tags;
}

enum class EntityPlace {
  kFixed,        ///< with position and orientation
  kDistributed,  ///< no position
  kSpawned       ///< as kFixed, or with exact angles; the id may be that of a deleted entity
};

void takeEntityId(const XmlElement& element, const std::string& id, EntityPlace place, Reader& reader) {
  if (place == EntityPlace::kSpawned) {
    TakenIds none;
    takeId("entity", id, element, none);
  } else {
    reader.takeId("entity", id, element);
  }
}

/// Reads <angles> in radians, an alternative to <orientation>: not every number of radians has an exact value in
/// degrees.
std::optional<Eigen::Vector3d> readExactAngles(const XmlElement& element, std::vector<Parameter>& table) {
  const auto angles = element.child("angles");
  if (!angles) {
    return std::nullopt;
  }
  if (const auto orientation = element.child("orientation")) {
    orientation->refuse("found <orientation> beside <angles> in <" + element.name() + ">, allowed: one of them");
  }
  table.erase(std::remove_if(table.begin(), table.end(),
                             [](const Parameter& parameter) { return parameter.name == "orientation"; }),
              table.end());
  angles->allowAttributes({});
  const std::vector<double> numbers = parseNumbers(angles->text(), 3, "angles", angles->location());
  return Eigen::Vector3d(numbers[0], numbers[1], numbers[2]);
}

EntityDescription readEntity(const XmlElement& element, EntityPlace place, Reader& reader) {
  element.allowAttributes(attributesOf("arena/*"));
  const Registry::Entry& entry =
      reader.requirePlugin(PluginKind::kEntity, element, element.attribute("library").value_or(""));
  EntityDescription entity;
  entity.location = element.location();
  entity.type = entry.description.label;
  entity.id = element.requireAttribute("id");
  takeEntityId(element, entity.id, place, reader);

  if (entry.make == nullptr) {  // its library is not loaded
    entity.parameters = element.toConfiguration();
    return entity;
  }
  const bool is_distributed = place == EntityPlace::kDistributed;
  std::vector<Parameter> table = entityParameters(entry.description, is_distributed);
  std::vector<std::string> others;
  if (makePlugin<EntityType>(entry)->isRobot()) {
    others.emplace_back("controller");
  }
  std::optional<Eigen::Vector3d> exact_angles;
  if (place == EntityPlace::kSpawned) {
    exact_angles = readExactAngles(element, table);
    others.emplace_back("angles");
  }
  entity.parameters = readParameters(element, table, others);
  entity.position = is_distributed ? Eigen::Vector3d(0, 0, 0) : entity.parameters.vector3("position");
  entity.angles = exact_angles ? *exact_angles : entity.parameters.vector3("orientation") * kRadPerDeg;
  entity.color = entity.parameters.color("color", colors::kBlack);
  if (const auto controller = element.child("controller")) {
    controller->allowAttributes(attributesOf("arena/*/controller"));
    entity.source = *parseCommandSource(readChoice(*controller, "source", commandSources(), commandSources().front()));
    if (const auto timeout = controller->attribute("timeout")) {
      const SourceLocation location = controller->attributeLocation("timeout");
      const double seconds = parseNumber(*timeout, "timeout", location, kCommandTimeoutRange);
      if (entity.source != CommandSource::kTopics) {
        throw ConfigError(location, "found timeout with source=\"" + std::string(toString(entity.source)) +
                                        "\", allowed: with source=\"topics\"");
      }
      entity.command_timeout = std::chrono::duration_cast<Duration>(std::chrono::duration<double>(seconds));
    }
    entity.controller = controller->text();
    entity.controller_location = controller->location();
    if (entity.controller.empty()) {
      controller->refuse("controller: found '', allowed: the id of a controller");
    }
  }
  return entity;
}

/// Reads the place of the arena: its corner at the origin, or its middle at `center`. The ground is inside.
void readCenter(const XmlElement& section, ArenaDescription& arena) {
  const auto center = section.attribute("center");
  if (!center) {
    return;
  }
  const SourceLocation location = section.attributeLocation("center");
  const std::vector<double> middle = parseNumbers(*center, 3, "center", location, limits::kCoordinate);
  arena.corner = Eigen::Vector3d(middle[0], middle[1], middle[2]) - 0.5 * arena.size;
  const double half = 0.5 * arena.size.z();
  if (std::abs(middle[2]) > half) {
    throw ConfigError(location, "center: found '" + *center + "', allowed: a height from " + numberText(-half) +
                                    " to " + numberText(half) + ", so that the ground, z = 0, is in the arena");
  }
  const Eigen::Vector3d most = arena.farCorner();
  if (!limits::kCoordinate.contains(arena.corner.minCoeff()) || !limits::kCoordinate.contains(most.maxCoeff())) {
    throw ConfigError(location, "center: found '" + *center + "', allowed: an arena whose coordinates are " +
                                    limits::kCoordinate.toString());
  }
}

}  // namespace

std::vector<std::string> entityTagsIn(const XmlElement& parent) {
  std::vector<std::string> tags = Registry::instance().labels(PluginKind::kEntity);
  for (const XmlElement& child : parent.children()) {
    if (child.attribute("library") && !contains(tags, child.name())) {
      tags.push_back(child.name());
    }
  }
  return tags;
}

EntityDescription readDistributedEntity(const XmlElement& element, Reader& reader) {
  return readEntity(element, EntityPlace::kDistributed, reader);
}

EntityDescription readSpawnedEntity(const XmlElement& element, const Experiment& experiment) {
  Reader reader;
  reader.experiment.framework.controller_path = experiment.framework.controller_path;  // folders of libraries
  EntityDescription entity = readEntity(element, EntityPlace::kSpawned, reader);
  validation::check(entity, experiment);
  return entity;
}

void readArena(const XmlElement& section, Reader& reader) {
  section.allowAttributes(attributesOf("arena"));
  ArenaDescription& arena = reader.experiment.arena;
  arena.location = section.location();
  const std::string size = section.requireAttribute("size");
  const std::vector<double> lengths =
      parseNumbers(size, 3, "size", section.attributeLocation("size"), limits::kArenaSide);
  arena.size = {lengths[0], lengths[1], lengths[2]};
  readCenter(section, arena);
  const bool is_3d = readChoice(section, "optimization", optimizations(), std::nullopt) == "3D";
  arena.optimization = is_3d ? PositionalIndex::Optimization::k3D : PositionalIndex::Optimization::k2D;
  arena.bounded =
      parseBoolean(section.attribute("bounded").value_or("false"), "bounded", section.attributeLocation("bounded"));
  if (const auto floor = section.attribute("floor")) {
    arena.floor.bare = parseColorOrThrow(*floor, "floor", section.attributeLocation("floor"));
  }

  section.allowChildren(childrenOfArena(section));
  for (const XmlElement& element : section.children()) {
    if (element.name() == "distribute") {
      readDistribute(element, reader);
    } else if (element.name() == "floor_patch") {
      readFloorPatch(element, reader);
    } else if (element.name() == "hole") {
      readHole(element, reader);
    } else if (element.name() == "floor_image") {
      readFloorImage(element, reader);
    } else if (element.name() == "floor_paint") {
      readFloorPaint(element, reader);
    } else if (element.name() == "heightfield") {
      readHeightfield(element, reader);
    } else {
      arena.entities.push_back(readEntity(element, EntityPlace::kFixed, reader));
    }
  }
  // the same checks as when the space is built, so that a mistake is reported before anything is built
  for (const EntityDescription& entity : arena.entities) {
    if (reader.loads_libraries || Registry::instance().find(PluginKind::kEntity, entity.type) != nullptr) {
      validation::check(entity, reader.experiment);
    }
  }
}

}  // namespace swarmanoid::experiment
