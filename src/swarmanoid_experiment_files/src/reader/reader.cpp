// Reads an Experiment from a file or a text.
#include "reader.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <map>

#include "realism_presets.hpp"
#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_experiment_files/unchecked_experiment.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "swarmanoid_interface/read_file.hpp"
#include "swarmanoid_space/experiment/entity_validation.hpp"
#include "swarmanoid_space/models/limits.hpp"

namespace swarmanoid {
namespace experiment {
namespace {

std::vector<std::string>& pendingWarnings() {
  thread_local std::vector<std::string> warnings;
  return warnings;
}

/// Returns 12 for "x_12"; 0 if the name does not have this form.
std::size_t numberOf(const std::string& name, const std::string& prefix) {
  const char* first = name.data() + prefix.size() + 1;
  const char* end = name.data() + name.size();
  std::size_t number = 0;
  const bool has_prefix = name.size() > prefix.size() + 1 && name.compare(0, prefix.size() + 1, prefix + "_") == 0;
  const bool is_written_so = has_prefix && *first != '0' && std::from_chars(first, end, number).ptr == end;
  return is_written_so ? number : 0;
}

[[noreturn]] void refuseTaken(const std::string& kind, const std::string& id, const SourceLocation& by,
                              const XmlElement& element) {
  throw ConfigError(element.attributeLocation("id"),
                    "the " + kind + " id '" + id + "' is taken already, in " + by.toString());
}

}  // namespace

void takeId(const std::string& kind, const std::string& id, const XmlElement& element, TakenIds& taken) {
  if (!validation::isName(id)) {
    throw ConfigError(element.attributeLocation("id"), "id: found '" + id + "', allowed: " + validation::kNamesAllowed);
  }
  const auto [known, is_new] = taken.emplace(kind + " " + id, element.location());
  if (!is_new) {
    refuseTaken(kind, id, known->second, element);
  }
}

void Reader::takeId(const std::string& kind, const std::string& id, const XmlElement& element) {
  experiment::takeId(kind, id, element, ids);
  const Group* group = kind == "entity" ? groupOf(id) : nullptr;
  if (group != nullptr) {
    refuseTaken(kind, id, group->location, element);
  }
}

const Reader::Group* Reader::groupOf(const std::string& id) const {
  const std::size_t underline = id.rfind('_');
  const auto group = underline == std::string::npos ? groups.end() : groups.find(id.substr(0, underline));
  if (group == groups.end()) {
    return nullptr;
  }
  const std::size_t number = numberOf(id, group->first);
  return number > 0 && number <= group->second.count ? &group->second : nullptr;
}

void Reader::takeNumberedIds(const std::string& prefix, std::size_t count, const XmlElement& element) {
  const std::string first = "entity " + prefix + "_";
  for (auto known = ids.lower_bound(first); known != ids.end() && known->first.rfind(first, 0) == 0; ++known) {
    const std::string id = known->first.substr(std::string("entity ").size());
    const std::size_t number = numberOf(id, prefix);
    if (number > 0 && number <= count) {
      refuseTaken("entity", id, known->second, element);
    }
  }
  groups[prefix] = {count, element.location()};
}

void Reader::needLibrary(const std::string& library, const SourceLocation& location) {
  if (loads_libraries) {
    loadPluginLibrary(library, experiment.framework.controller_path, location);
  } else {
    unloaded.insert(library);
  }
}

const Registry::Entry& Reader::standIn(PluginKind kind, const std::string& label) {
  unknown.push_back({kind, {}, nullptr});
  unknown.back().description.label = label;
  unknown.back().description.free_parameters = true;
  return unknown.back();
}

/// Otherwise the first library's plugin would silently be used instead of the second one's.
void refuseSecondLibrary(const Registry::Entry& entry, const XmlElement& element, const std::string& library) {
  if (library.empty()) {
    return;
  }
  const std::filesystem::path path(library);
  const std::string file = path.extension() == ".so" ? path.filename().string() : "lib" + library + ".so";
  for (const Registry::Conflict& conflict : Registry::instance().conflicts()) {
    const bool is_its_own = conflict.kind == entry.kind && conflict.label == entry.description.label;
    // of two defaults the first is used, with a warning; both can be selected by name
    if (is_its_own && !conflict.is_about_default && conflict.second_library == file && conflict.first_library != file) {
      element.refuse("found the label '" + conflict.label + "' in two libraries (" + conflict.first_library + ", " +
                     conflict.second_library + "), allowed: one in a process");
    }
  }
}

const std::multimap<std::string, std::string>& Reader::declaredLabels(PluginKind kind) {
  static const std::multimap<std::string, std::string> none;
  if (kind != PluginKind::kObserver) {
    return none;
  }
  if (!declared_visualisations) {
    declared_visualisations.emplace();
    for (const DeclaredLibrary& declared : declaredLibraries()) {
      for (const std::string& label : declared.visualisations) {
        declared_visualisations->emplace(label, declared.library);
      }
    }
  }
  return *declared_visualisations;
}

std::string Reader::libraryOf(PluginKind kind, const XmlElement& element) {
  if (const auto named = element.attribute("library")) {
    return *named;
  }
  const auto [first, last] = declaredLabels(kind).equal_range(element.name());
  std::vector<std::string> libraries;
  for (auto own = first; own != last; ++own) {
    libraries.push_back(own->second);
  }
  if (libraries.size() > 1) {
    element.refuse("found no library, though several have declared '" + element.name() +
                   "', allowed: library=\"...\", one of " + joinNames(libraries));
  }
  return libraries.empty() ? "" : libraries.front();
}

const Registry::Entry& Reader::requirePlugin(PluginKind kind, const XmlElement& element, const std::string& library) {
  if (!library.empty()) {
    needLibrary(library, element.attributeLocation("library"));
  }
  const Registry::Entry* entry = Registry::instance().find(kind, element.name());
  if (entry == nullptr && !loads_libraries && !library.empty()) {
    return standIn(kind, element.name());
  }
  if (entry == nullptr) {
    std::vector<std::string> labels = Registry::instance().labels(kind);
    for (const auto& [label, its_library] : declaredLabels(kind)) {
      labels.push_back(label);
    }
    std::sort(labels.begin(), labels.end());
    labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
    element.refuse(unknownName(toString(kind), element.name(), labels));
  }
  refuseSecondLibrary(*entry, element, library);
  return *entry;
}

Configuration readPluginParameters(const XmlElement& element, const PluginDescription& plugin,
                                   const std::vector<std::string>& others) {
  return plugin.free_parameters ? element.toConfiguration() : readParameters(element, plugin.parameters, others);
}

namespace {

/// Reads the sections in an order in which each refers only to earlier ones; in the file they may have any order.
void readSections(const XmlElement& root, Reader& reader) {
  root.allowAttributes({});
  root.allowChildren(tagsIn(""));
  const auto framework = root.child("framework");
  const auto arena = root.child("arena");
  if (!framework || !arena) {
    root.refuse(std::string("<ahss-config> needs <") + (framework ? "arena" : "framework") + ">");
  }
  readFramework(*framework, reader);
  if (const auto section = root.child("controllers")) {
    readControllers(*section, reader);
  }
  readArena(*arena, reader);
  if (const auto section = root.child("engines")) {
    readEngines(*section, reader);
  }
  if (const auto section = root.child("arena_physics")) {
    readArenaPhysics(*section, reader);
  }
  if (const auto section = root.child("rules")) {
    reader.experiment.rules = readPluginUses(*section, PluginKind::kRule, reader);
  }
  const auto visualisations = root.child("visualisations");
  const auto visualizations = root.child("visualizations");
  if (visualisations && visualizations) {
    visualizations->refuse("found <visualizations> beside <visualisations>, allowed: one of them");
  }
  if (visualisations || visualizations) {
    reader.experiment.visualisations =
        readPluginUses(visualisations ? *visualisations : *visualizations, PluginKind::kObserver, reader);
  }
}

}  // namespace
}  // namespace experiment

/// Reads and checks the document; warnings are kept for takeExperimentWarnings.
void experiment::readDocument(const XmlElement& root, Reader& reader) {
  const auto& conflicts = Registry::instance().conflicts();
  const std::size_t first_new = conflicts.size();
  readSections(root, reader);
  warnOfUnmovedRobots(reader);
  auto& warnings = pendingWarnings();
  warnings.insert(warnings.end(), reader.warnings.begin(), reader.warnings.end());
  for (std::size_t i = first_new; i < conflicts.size(); ++i) {
    warnings.push_back(describe(conflicts[i]));
  }
}

namespace {

void readText(const std::string& text, const std::string& name, const std::vector<Override>& overrides,
              experiment::Reader& reader) {
  using experiment::XmlElement;
  if (text.empty()) {
    throw ConfigError({name, 0}, "found an empty file, allowed: an <ahss-config> element");
  }
  const XmlDocument document = parseXml(text, name, XmlNamespaces::kRefused);
  const XmlElement root_element(xmlDocGetRootElement(document.get()), &name);
  if (root_element.name() != "ahss-config") {
    root_element.refuse("found the root element <" + root_element.name() + ">, allowed: <ahss-config>");
  }
  auto marks = experiment::applyOverrides(*document, overrides);
  experiment::applyRealism(*document, name, experiment::installedPresets, marks);
  reader.experiment.file = name;
  reader.experiment.name = std::filesystem::path(name).stem().string();
  reader.experiment.text = text;
  reader.experiment.overrides = overrides;
  reader.experiment.files = {name};
  experiment::readDocument(root_element, reader);
}

/// @return true, so that a static variable can keep that it is done
bool loadBuiltInLibraries() {
  for (const DeclaredLibrary& declared : declaredLibraries()) {
    if (declared.is_built_in) {
      loadPluginLibrary(declared.library, {}, {"package " + declared.package, 0});
    }
  }
  for (const auto& [kind, package] :
       {std::pair{PluginKind::kEngine, "swarmanoid_engines"}, std::pair{PluginKind::kSensor, "swarmanoid_devices"}}) {
    if (Registry::instance().all(kind).empty()) {
      throw ConfigError({},
                        std::string("found no ") + toString(kind) + ", allowed: an installation that has " + package);
    }
  }
  return true;
}

}  // namespace

std::string experiment::takeFile(const std::string& name, Reader& reader) {
  const std::filesystem::path folder = std::filesystem::path(reader.experiment.file).parent_path();
  reader.experiment.files.push_back((folder / name).string());  // an absolute name stays unchanged
  return reader.experiment.files.back();
}

std::string experiment::textOf(const std::string& file) { return readFile(file, limits::kLongestText); }

Experiment parseExperiment(const std::string& text, const std::string& name, const std::vector<Override>& overrides) {
  experiment::Reader reader;
  readText(text, name, overrides, reader);
  return std::move(reader.experiment);
}

Experiment readExperiment(const std::string& file, const std::vector<Override>& overrides) {
  return parseExperiment(experiment::textOf(file), file, overrides);
}

UncheckedExperiment readWithoutLibraries(const std::string& file, const std::vector<Override>& overrides) {
  experiment::Reader reader;
  reader.loads_libraries = false;
  readText(experiment::textOf(file), file, overrides, reader);
  return {std::move(reader.experiment), {reader.unloaded.begin(), reader.unloaded.end()}};
}

void loadBuiltInPlugins() {
  static const bool is_done = loadBuiltInLibraries();
  static_cast<void>(is_done);
}

std::vector<std::string> takeExperimentWarnings() {
  std::vector<std::string> warnings;
  warnings.swap(experiment::pendingWarnings());
  return warnings;
}

}  // namespace swarmanoid
