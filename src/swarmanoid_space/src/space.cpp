#include "swarmanoid_space/space.hpp"

#include <algorithm>

namespace swarmanoid {

std::optional<double> Space::property(Row row, std::string_view name) const {
  const int found = entities.model[row]->findProperty(name);
  return found < 0 ? std::nullopt : std::optional<double>(properties[row][static_cast<std::size_t>(found)]);
}

Color Space::ownColor(Row row) const {
  return property(row, kIntensity).value_or(1.0) > 0.0 ? entities.color[row] : colors::kBlack;
}

bool Space::mayHit(const RayBundle& rays) const {
  return (terrain && terrain->mayHit(rays)) ||
         std::any_of(engines.begin(), engines.end(), [&](const Engine* engine) { return engine->mayHit(rays); }) ||
         entities_without_engine.mayHit(rays);
}

Obstacles Space::findObstacles(const RayBundle& rays) const {
  Obstacles found;
  if (terrain && terrain->mayHit(rays)) {
    found.addAnywhere();
  }
  for (const Engine* engine : engines) {
    engine->findObstacles(rays, found);
  }
  if (!entities_without_engine.isEmpty()) {
    entities_without_engine.findObstacles(rays, found);
  }
  return found;
}

void Space::raycast(const RayBundle& rays, Span<RayHit> hits) const {
  for (RayHit& hit : hits) {
    hit = RayHit{};
  }
  if (terrain) {
    terrain->raycast(rays, hits);
  }
  for (const Engine* engine : engines) {
    engine->raycast(rays, hits);
  }
  entities_without_engine.raycast(entities, rays, hits);
}

RayHit Space::castRay(const Segment& segment, Row ignored, Row also_ignored) const {
  RayBundle bundle;
  bundle.segments = Span<const Segment>(&segment, 1);
  bundle.centre = 0.5 * (segment.from + segment.to);
  bundle.radius = 0.5 * (segment.to - segment.from).norm();
  bundle.ignored = ignored;
  bundle.also_ignored = also_ignored;
  RayHit hit;
  raycast(bundle, Span<RayHit>(&hit, 1));
  return hit;
}

bool Space::isOccluded(const Segment& segment, Row from, Row to) const { return castRay(segment, from, to).isHit(); }

}  // namespace swarmanoid
