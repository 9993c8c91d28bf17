// The table of tags, and look-ups in it.
#include "tags.hpp"

#include <algorithm>
#include <map>
#include <mutex>
#include <stdexcept>

#include "swarmanoid_space/error_models/error_model.hpp"
#include "swarmanoid_space/experiment/entity_parameters.hpp"
#include "swarmanoid_space/state/floor.hpp"

namespace swarmanoid {
namespace experiment {
namespace {

using Type = Parameter::Type;
using Attribute = ExperimentAttribute;

Attribute id(const std::string& name, bool is_required, const std::string& description) {
  Attribute attribute{makeParameter(name, Type::kText, "", std::nullopt, {}, description), true};
  if (!is_required) {
    attribute.value.value = "";
  }
  return attribute;
}

Attribute text(const std::string& name, std::optional<std::string> value, const std::string& description) {
  return {makeParameter(name, Type::kText, "", std::move(value), {}, description)};
}

Attribute choice(const std::string& name, const std::vector<std::string>& choices, std::optional<std::string> value,
                 const std::string& description) {
  Attribute attribute{makeParameter(name, Type::kChoice, "", std::move(value), {}, description)};
  attribute.value.choices = choices;
  return attribute;
}

Attribute libraryAttribute() {
  return text("library", "", "The name x of a file libx.so, or a path; needed for plugins from outside the suite.");
}

std::vector<Attribute> pluginAttributes() { return {id("id", true, "Its name in this file."), libraryAttribute()}; }

/// Attributes of plugins that may also be written in Python.
std::vector<Attribute> scriptAttributes() {
  std::vector<Attribute> attributes = pluginAttributes();
  attributes.push_back(choice("source", codeLanguages(), codeLanguages().front(), "Its programming language."));
  attributes.push_back(text("file", "", "With python: the file that has it, under the name of the tag."));
  return attributes;
}

ExperimentTag device(const std::string& section, const std::string& heading) {
  return {"controllers/*/" + section,
          "*",
          heading,
          "In <" + section + ">.",
          {text("library", "", "As for controllers.")},
          {makeParameter("implementation", Type::kText, "", "", {}, "In brackets below; else the type's default."),
           realismParameter()}};
}

/// <error> in a device. It has the attributes of all kinds; `readErrors` checks which of them a kind has.
ExperimentTag errorTag() {
  std::vector<Attribute> attributes{
      choice("kind", errorKindNames(), std::nullopt, "Kind of the error."),
      id("id", false, "Its name, for the command line."),
      text("field", "",
           "Field that it acts on, such as value, value[3], left or blobs[].distance; else all suitable fields."),
      {makeParameter("from_tick", Type::kInteger, "ticks", "0", limits::kTick, "The first tick in which it acts.")}};
  for (const ErrorKind* kind : errorKinds()) {
    for (Parameter parameter : kind->description.parameters) {
      const auto is_known = [&](const Attribute& known) { return known.value.name == parameter.name; };
      if (std::none_of(attributes.begin(), attributes.end(), is_known)) {
        parameter.value = "";  // not required: other kinds do not have it
        attributes.push_back({parameter});
      }
    }
  }
  return {"controllers/*/sensors/*",
          "error",
          "error",
          "In a sensor or an actuator, as often as needed: one of its errors. Numbers are in the field's unit.",
          std::move(attributes),
          {}};
}

ExperimentTag rule(const std::string& name, const std::string& summary, std::vector<Attribute> attributes,
                   const std::vector<Parameter>& values) {
  return {"arena_physics/handover", name, "arena_physics", "In <handover>: " + summary, std::move(attributes), values};
}

std::vector<ExperimentTag> arenaTags() {
  return {{"",
           "arena",
           "arena",
           "The section: entities with their positions, and these.",
           {{makeParameter("size", Type::kVector3, "m", std::nullopt, limits::kArenaSide,
                           "Of the arena, along x, y and z.")},
            {makeParameter("center", Type::kVector3, "m", "", limits::kCoordinate,
                           "Of the arena; else its corner is the origin.")},
            choice("optimization", optimizations(), std::nullopt, "Which engines the search for neighbours favours."),
            {makeParameter("bounded", Type::kBoolean, "", "false", {}, "Walls along the four sides.")},
            {makeParameter("floor", Type::kColor, "", toString(Floor{}.bare), {},
                           "Of the bare floor, as ground sensors read it.")}},
           {}},
          {"arena",
           "floor_patch",
           "arena",
           "A coloured disc or rectangle on the floor, visible to cameras, without collisions.",
           {id("id", true, "Its name.")},
           floorPatchParameters()},
          {"arena",
           "hole",
           "arena",
           "A disc or rectangle without floor: ground sensors get no reflection, bodies there fall.",
           {id("id", true, "Its name.")},
           holeParameters()},
          {"arena",
           "floor_image",
           "arena",
           "A picture on the floor, at most one, below the patches; ground sensors read it, cameras do not see it.",
           {},
           floorImageParameters()},
          {"arena",
           "floor_paint",
           "arena",
           "The floor takes paint while the experiment runs, which may fade; at most one.",
           {},
           floorPaintParameters()},
          {"arena",
           "heightfield",
           "arena",
           "Rough ground, at most one, where dynamics3d moves entities.",
           {},
           heightfieldParameters()},
          {"arena",
           "distribute",
           "arena",
           "Places copies of the one entity in it, which has no position.",
           {{makeParameter("quantity", Type::kInteger, "", std::nullopt, kQuantityRange, "How many.")},
            choice("layout", layouts(), layouts().front(),
                   "At random, or at even distances: in rows at the height of minimum, around a ring, along a line."),
            choice("area", areas(), areas().front(), "Where the origins are.")},
           distributeParameters()},
          {"arena",
           "*",
           "entity",
           "In <arena>.",
           {id("id", true, "Its name."), libraryAttribute()},
           placementParameters(false)},
          {"arena/*",
           "controller",
           "entity",
           "In a robot: the id of its controller.",
           {choice("source", commandSources(), commandSources().front(), "Source of the robot's commands."),
            {makeParameter("timeout", Type::kNumber, "s", "0.5", kCommandTimeoutRange,
                           "With topics: the robot stops when no command has come for so long.")}},
           {}}};
}

std::vector<ExperimentTag> physicsTags() {
  const Attribute end = choice("as", gripEnds(), "", "Only that end of a grip counts.");
  return {
      {"", "arena_physics", "arena_physics", "The section: assignment of entities to engines.", {}, {}},
      {"arena_physics",
       "engine",
       "arena_physics",
       "The entities of an engine.",
       {id("id", true, "Of one in <engines>.")},
       {}},
      {"arena_physics/engine",
       "entity",
       "arena_physics",
       "In <engine>: an entity, or all of a distribution.",
       {id("id", true, "Of one in <arena>."),
        choice("role", roles(), "", "Else the first engine that lists it moves it, the others have a mirror.")},
       {}},
      {"arena_physics",
       "handover",
       "arena_physics",
       "An engine takes the entity over when the condition becomes true.",
       {id("id", false, "Its name, for the command line."), id("entity", true, "Or a distribution: each of them."),
        id("to", true, "The engine.")},
       {}},
      // in the order of HandoverDescription::Condition
      rule("inside", "its origin is in the box.", {}, boxParameters()),
      rule("outside", "its origin is not in the box.", {}, boxParameters()),
      rule("attached", "it holds something, or is held.", {end}, {}),
      rule("released", "it does not.", {end}, {}),
      rule("debug", "a debug value of its controller is the text.", {text("key", std::nullopt, "Of the value.")}, {}),
  };
}

std::vector<ExperimentTag> makeTags() {
  std::vector<ExperimentTag> tags{
      {"", "framework", "framework", "The section: settings of the whole run.", {}, frameworkParameters()},
      {"", "controllers", "controller", "The section: controllers with their devices.", {}, {}},
      {"controllers", "*", "controller", "In <controllers>, by its label.", scriptAttributes(), {realismParameter()}},
      {"controllers/*", "actuators", "controller", "In a controller: the actuators that it uses.", {}, {}},
      {"controllers/*", "sensors", "controller", "In a controller: the sensors that it uses.", {}, {}},
      {"controllers/*", "parameters", "controller", "In a controller: its parameters.", {}, {}},
      device("sensors", "sensor"),
      device("actuators", "actuator"),
      errorTag()};
  const auto append = [&tags](const std::vector<ExperimentTag>& more) {
    tags.insert(tags.end(), more.begin(), more.end());
  };
  append(arenaTags());
  append({{"", "engines", "engine", "The section: engines, which move entities.", {}, {}},
          {"engines", "*", "engine", "In <engines>.", pluginAttributes(), {}}});
  append(physicsTags());
  append({{"", "rules", "rule", "The section: rules, which act on the world beside robots and engines.", {}, {}},
          {"rules", "*", "rule", "In <rules>.", scriptAttributes(), {}}});
  append({{"", "visualisations", "visualisation", "The section: visualisations, which observe the run.", {}, {}},
          {"", "visualizations", "visualisation", "The same, in another spelling.", {}, {}},
          {"visualisations", "*", "visualisation", "In <visualisations>.", pluginAttributes(), {}}});
  return tags;
}

}  // namespace

const ExperimentTag& tagAt(const std::string& path) {
  for (const ExperimentTag& tag : experimentTags()) {
    if ((tag.in.empty() ? tag.name : tag.in + "/" + tag.name) == path) {
      return tag;
    }
  }
  throw std::logic_error("the table of tags has no " + path);
}

std::string pathOf(PluginKind kind) { return std::string(toString(kind)) + "s/*"; }

std::vector<std::string> attributesOf(const std::string& path) {
  std::vector<std::string> names;
  for (const Attribute& attribute : tagAt(path).attributes) {
    names.push_back(attribute.value.name);
  }
  return names;
}

std::vector<std::string> valuesOf(const std::string& path) {
  std::vector<std::string> names;
  for (const Parameter& parameter : tagAt(path).values) {
    names.push_back(parameter.name);
  }
  return names;
}

std::vector<std::string> tagsIn(const std::string& path) {
  std::vector<std::string> names;
  for (const ExperimentTag& tag : experimentTags()) {
    if (tag.in == path && tag.name != "*") {
      names.push_back(tag.name);
    }
  }
  return names;
}

}  // namespace experiment

const std::vector<ExperimentTag>& experimentTags() {
  static std::mutex mutex;
  static std::map<std::size_t, std::vector<ExperimentTag>> tables;  // kept, because callers hold references to them
  const std::lock_guard<std::mutex> lock(mutex);
  const std::size_t kinds = errorKinds().size();
  const auto known = tables.find(kinds);
  return known != tables.end() ? known->second : tables.emplace(kinds, experiment::makeTags()).first->second;
}

}  // namespace swarmanoid
