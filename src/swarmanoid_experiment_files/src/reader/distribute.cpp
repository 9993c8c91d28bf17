// <distribute> in <arena>: many entities of one kind, distributed over an area.
#include <algorithm>

#include "reader.hpp"
#include "swarmanoid_interface/contains.hpp"

namespace swarmanoid::experiment {
namespace {

/// Reads the area of the entities' origins.
void readPlaces(const XmlElement& element, const Configuration& values, Distribution& distribution) {
  using Area = Distribution::Area;
  if (distribution.area == Area::kLine) {
    distribution.from = values.vector3("from");
    distribution.to = values.vector3("to");
    return;
  }
  if (distribution.area == Area::kBox) {
    distribution.minimum = values.vector3("minimum");
    distribution.maximum = values.vector3("maximum");
    if (!((distribution.maximum - distribution.minimum).minCoeff() >= 0.0)) {
      element.child("maximum")->refuse("maximum: found '" + values.text("maximum") +
                                       "', allowed: nothing below minimum, '" + values.text("minimum") + "'");
    }
    return;
  }
  distribution.center = values.vector3("center");
  distribution.radius = values.number("radius");
  if (distribution.area == Area::kRing) {
    distribution.inner_radius = values.number("inner_radius");
    if (distribution.inner_radius > distribution.radius) {
      element.child("inner_radius")
          ->refuse("inner_radius: found '" + values.text("inner_radius") + "', allowed: at most radius, '" +
                   values.text("radius") + "'");
    }
  } else if (distribution.layout == Distribution::Layout::kGrid) {
    throw ConfigError(element.attributeLocation("layout"), "layout: found 'grid' with area=\"disc\", allowed: uniform");
  }
}

/// Returns the entity at the centre of the area; it is placed first.
std::string readAround(const XmlElement& element, const Configuration& values, const Reader& reader) {
  std::string around = values.text("around");
  if (around.empty()) {
    return around;
  }
  std::vector<std::string> known;
  for (const EntityDescription& entity : reader.experiment.arena.entities) {
    if (!entity.distribution) {
      known.push_back(entity.id);
    }
  }
  if (!contains(known, around) && reader.groupOf(around) == nullptr) {
    element.child("around")->refuse("around: found '" + around +
                                    "', allowed: an entity that stands before this <distribute>" +
                                    didYouMean(around, known));
  }
  return around;
}

}  // namespace

void readDistribute(const XmlElement& element, Reader& reader) {
  element.allowAttributes(attributesOf("arena/distribute"));
  const std::vector<std::string> entity_tags = entityTagsIn(element);
  Distribution distribution;
  const std::string area = readChoice(element, "area", areas(), areas().front());
  distribution.area =
      static_cast<Distribution::Area>(std::find(areas().begin(), areas().end(), area) - areas().begin());
  const bool is_around = element.child("around").has_value();
  const Configuration values = readParameters(element, distributeParameters(distribution.area, is_around), entity_tags);
  distribution.quantity = static_cast<std::size_t>(parseInteger(element.requireAttribute("quantity"), "quantity",
                                                                element.attributeLocation("quantity"), kQuantityRange));
  const bool is_grid = readChoice(element, "layout", layouts(), layouts().front()) == "grid";
  distribution.layout = is_grid ? Distribution::Layout::kGrid : Distribution::Layout::kUniform;
  distribution.location = element.location();
  readPlaces(element, values, distribution);
  distribution.around = readAround(element, values, reader);
  distribution.random_heading = values.boolean("random_heading");
  distribution.max_trials = static_cast<int>(values.integer("max_trials"));

  std::vector<EntityDescription> prototypes;
  for (const XmlElement& child : element.children()) {
    if (contains(entity_tags, child.name())) {
      prototypes.push_back(readDistributedEntity(child, reader));
    }
  }
  if (prototypes.size() != 1) {
    element.refuse("found " + std::to_string(prototypes.size()) + " entities in <distribute>, allowed: one");
  }
  if (distribution.random_heading && prototypes[0].angles.z() != 0.0) {
    const Configuration& orientation = *prototypes[0].parameters.find("orientation");
    throw ConfigError(orientation.location(), "orientation: found '" + orientation.text() +
                                                  "' while random_heading is true, allowed: a third angle of 0");
  }
  prototypes[0].distribution = distribution;
  reader.takeNumberedIds(prototypes[0].id, distribution.quantity, element);
  reader.experiment.arena.entities.push_back(std::move(prototypes[0]));
}

}  // namespace swarmanoid::experiment
