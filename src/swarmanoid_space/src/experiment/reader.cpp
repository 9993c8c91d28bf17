// From a file or a text to an Experiment.
#include "reader.hpp"

#include <cctype>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "swarmanoid_interface/plugin_library.hpp"

namespace swarmanoid {
namespace experiment {
namespace {

std::vector<std::string>& pendingWarnings() {
  thread_local std::vector<std::string> warnings;
  return warnings;
}

}  // namespace

void checkName(const std::string& id, const XmlElement& element) {
  bool good = !id.empty() && std::isalpha(static_cast<unsigned char>(id[0])) != 0;
  for (const char c : id) {
    good = good && (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_');
  }
  if (!good) {
    throw ConfigError(element.attributeLocation("id"),
                      "id: found '" + id + "', allowed: letters, digits and _, a letter first");
  }
}

void Reader::takeId(const std::string& kind, const std::string& id, const XmlElement& element) {
  checkName(id, element);
  const auto [known, is_new] = ids.emplace(kind + " " + id, element.location());
  if (!is_new) {
    throw ConfigError(element.attributeLocation("id"),
                      "the " + kind + " id '" + id + "' is taken already, in " + known->second.toString());
  }
}

void refuseSecondLibrary(const Registry::Entry& entry, const XmlElement& element, const std::string& library) {
  if (library.empty()) {
    return;
  }
  const std::filesystem::path path(library);
  const std::string file = path.extension() == ".so" ? path.filename().string() : "lib" + library + ".so";
  const std::string title = std::string(toString(entry.kind)) + " '" + entry.description.label;
  for (const std::string& conflict : Registry::instance().conflicts()) {
    if (conflict.rfind(title, 0) == 0 && conflict.find(", " + file + ")") != std::string::npos) {
      element.refuse("found the label '" + entry.description.label + "' in two libraries " +
                     conflict.substr(conflict.find('('), conflict.find(')') - conflict.find('(') + 1) +
                     ", allowed: one in a process");
    }
  }
}

const Registry::Entry& Reader::requirePlugin(PluginKind kind, const XmlElement& element, const std::string& library) {
  if (!library.empty()) {
    loadPluginLibrary(library, experiment.framework.controller_path, element.attributeLocation("library"));
  }
  const Registry::Entry* entry = Registry::instance().find(kind, element.name());
  if (entry == nullptr) {
    element.refuse(unknownName(toString(kind), element.name(), Registry::instance().labels(kind)));
  }
  refuseSecondLibrary(*entry, element, library);
  return *entry;
}

namespace {

/// Sections may come in any order, but later ones refer to earlier ones: read them in an order of our own.
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
  const auto visualisations = root.child("visualisations");
  const auto visualizations = root.child("visualizations");
  if (visualisations && visualizations) {
    visualizations->refuse("found <visualizations> beside <visualisations>, allowed: one of them");
  }
  if (visualisations || visualizations) {
    readVisualisations(visualisations ? *visualisations : *visualizations, reader);
  }
}

std::string xmlProblem(const tinyxml2::XMLDocument& document) {
  switch (document.ErrorID()) {
    case tinyxml2::XML_ERROR_EMPTY_DOCUMENT:
      return "found an empty file, allowed: an <ahss-config> element";
    case tinyxml2::XML_ERROR_MISMATCHED_ELEMENT:
      return "found a closing tag that does not match the open element";
    case tinyxml2::XML_ERROR_PARSING_ATTRIBUTE:
      return "found a malformed attribute, allowed: name=\"value\", each name once";
    case tinyxml2::XML_ERROR_PARSING:
    case tinyxml2::XML_ERROR_PARSING_ELEMENT:
      return "found a tag that is malformed or never closed";
    default:
      return std::string("found malformed XML (") + tinyxml2::XMLDocument::ErrorIDToName(document.ErrorID()) + ")";
  }
}

}  // namespace
}  // namespace experiment

/// Reads and checks the document; what it warns of is kept for takeExperimentWarnings.
Experiment experiment::readDocument(const XmlElement& root, Experiment start) {
  Reader reader;
  reader.experiment = std::move(start);
  const auto& conflicts = Registry::instance().conflicts();
  const auto first_new = static_cast<std::ptrdiff_t>(conflicts.size());
  readSections(root, reader);
  auto& warnings = pendingWarnings();
  warnings.insert(warnings.end(), reader.warnings.begin(), reader.warnings.end());
  warnings.insert(warnings.end(), conflicts.begin() + first_new, conflicts.end());
  return std::move(reader.experiment);
}

Experiment parseExperiment(const std::string& text, const std::string& name, const std::vector<Override>& overrides) {
  using experiment::XmlElement;
  experiment::checkWellFormed(text, name);
  tinyxml2::XMLDocument document;
  if (document.Parse(text.c_str(), text.size()) != tinyxml2::XML_SUCCESS) {
    throw ConfigError({name, document.ErrorLineNum()}, experiment::xmlProblem(document));
  }
  const tinyxml2::XMLElement* root = document.RootElement();
  if (root == nullptr) {
    throw ConfigError({name, 0}, "found no element, allowed: an <ahss-config> element");
  }
  const XmlElement root_element(root, &name);
  if (root_element.name() != "ahss-config") {
    root_element.refuse("found the root element <" + root_element.name() + ">, allowed: <ahss-config>");
  }
  if (const tinyxml2::XMLElement* second = root->NextSiblingElement()) {
    XmlElement(second, &name)
        .refuse("found <" + std::string(second->Name()) + "> after the root element, allowed: nothing");
  }
  const auto marks = experiment::applyOverrides(document, overrides);
  Experiment start;
  start.file = name;
  start.name = std::filesystem::path(name).stem().string();
  start.text = text;
  return experiment::readDocument(root_element, std::move(start));
}

Experiment readExperiment(const std::string& file, const std::vector<Override>& overrides) {
  std::error_code ignored;
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file, ignored)) {
    throw ConfigError({file, 0}, "cannot be read");
  }
  std::ostringstream text;
  text << in.rdbuf();
  return parseExperiment(text.str(), file, overrides);
}

void loadBuiltInPlugins() {
  for (const char* library : {"swarmanoid_engines", "swarmanoid_devices", "swarmanoid_visualisations"}) {
    loadPluginLibrary(library, {}, {});
  }
}

std::vector<std::string> takeExperimentWarnings() {
  std::vector<std::string> warnings;
  warnings.swap(experiment::pendingWarnings());
  return warnings;
}

}  // namespace swarmanoid
