#include "spawn_form.hpp"

#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <sstream>

#include "../reader/reader.hpp"

namespace swarmanoid {

std::string requireEngineId(const experiment::XmlElement& element, const char* attribute, const std::string& id,
                            const Experiment& experiment) {
  std::vector<std::string> known;
  for (const EngineDescription& engine : experiment.engines) {
    known.push_back(engine.id);
    if (engine.id == id) {
      return id;
    }
  }
  throw ConfigError(element.attributeLocation(attribute), unknownName("the engine", id, known));
}

namespace {

std::string vectorText(const Eigen::Vector3d& v) { return numbersText(std::array<double, 3>{v.x(), v.y(), v.z()}); }

/// Returns a text in seconds that is read back as the same number of nanoseconds; the reader truncates.
std::string secondsText(Duration duration) {
  using Seconds = std::chrono::duration<double>;
  double seconds = Seconds(duration).count();
  while (std::chrono::duration_cast<Duration>(Seconds(seconds)) < duration) {
    seconds = std::nextafter(seconds, std::numeric_limits<double>::infinity());
  }
  return numberText(seconds);
}

/// Returns the colour that the reader of entities derives from the parameters.
Color colorInParameters(const EntityDescription& entity) {
  if (entity.parameters.has("color")) {
    return entity.parameters.color("color");
  }
  if (const Registry::Entry* type = Registry::instance().find(PluginKind::kEntity, entity.type)) {
    for (const Parameter& parameter : type->description.parameters) {
      if (parameter.name == "color" && parameter.value) {
        return parseColorOrThrow(*parameter.value, parameter.name, {});
      }
    }
  }
  return colors::kBlack;
}

}  // namespace

SpawnEntity readSpawn(const experiment::XmlElement& element, const Experiment& experiment) {
  element.refuseText();
  const std::vector<experiment::XmlElement> children = element.children();
  if (children.size() != 1) {
    element.refuse("found " + std::to_string(children.size()) + " entities in <spawn>, allowed: one");
  }
  SpawnEntity result{experiment::readSpawnedEntity(children.front(), experiment), {}};
  std::istringstream engines(element.attribute("engines").value_or(""));
  for (std::string engine; engines >> engine;) {
    result.engines.push_back(requireEngineId(element, "engines", engine, experiment));
  }
  if (const auto color = element.attribute("color")) {
    result.entity.color = parseColorOrThrow(*color, "color", element.attributeLocation("color"));
  }
  return result;
}

void writeSpawn(const SpawnEntity& what, ElementText& text) {
  const EntityDescription& entity = what.entity;
  std::string engines;
  for (const std::string& engine : what.engines) {
    engines += (engines.empty() ? "" : " ") + engine;
  }
  if (!engines.empty()) {
    text.attribute("engines", engines);
  }
  if (entity.color != colorInParameters(entity)) {
    text.attribute("color", toString(entity.color));
  }
  text.begin(entity.type);
  text.attribute("id", entity.id);
  text.value("position", vectorText(entity.position));
  text.value("angles", vectorText(entity.angles));
  for (const Configuration& value : entity.parameters.children()) {
    if (value.name() != "position" && value.name() != "orientation") {  // possible for entities of files
      text.value(value.name(), value.text());
    }
  }
  if (!entity.controller.empty()) {
    text.begin("controller");
    if (entity.source != CommandSource::kController) {
      text.attribute("source", toString(entity.source));
    }
    if (entity.source == CommandSource::kTopics && entity.command_timeout != kCommandTimeout) {
      text.attribute("timeout", secondsText(entity.command_timeout));
    }
    text.end(entity.controller);
  }
  text.end();
}

}  // namespace swarmanoid
