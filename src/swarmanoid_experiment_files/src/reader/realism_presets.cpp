// Finds and reads preset files.
#include "realism_presets.hpp"

#include <algorithm>
#include <memory>
#include <set>
#include <tuple>
#include <utility>

#include "../robots/robot_files.hpp"
#include "reader.hpp"

namespace swarmanoid::experiment {
namespace {

struct XmlBufferDeleter {
  void operator()(xmlBuffer* buffer) const { xmlBufferFree(buffer); }
};

/// Returns the child elements as text, one per line.
std::string contentOf(xmlNode& preset) {
  std::string text;
  for (xmlNode* child : elementsOf(preset)) {
    const std::unique_ptr<xmlBuffer, XmlBufferDeleter> buffer(xmlBufferCreate());
    xmlNodeDump(buffer.get(), child->doc, child, 0, 0);
    text += (text.empty() ? "" : "\n") + std::string(characters(xmlBufferContent(buffer.get())));
  }
  return text;
}

/// Returns the device or entity type that the presets of a file belong to.
RealismPreset subjectOf(const XmlElement& root) {
  constexpr std::pair<const char*, PluginKind> kSubjects[] = {
      {"sensor", PluginKind::kSensor}, {"actuator", PluginKind::kActuator}, {"entity", PluginKind::kEntity}};
  root.allowAttributes({"sensor", "actuator", "entity"});
  RealismPreset about;
  for (const auto& [attribute, kind] : kSubjects) {
    if (const auto type = root.attribute(attribute)) {
      if (!about.device.empty()) {
        about.device.clear();
        break;
      }
      about.kind = kind;
      about.device = *type;
    }
  }
  if (about.device.empty()) {
    root.refuse("<realism> needs the attribute sensor=\"...\", actuator=\"...\" or entity=\"...\", one of them");
  }
  return about;
}

}  // namespace

PresetLibrary::PresetLibrary(const std::vector<std::string>& files) {
  for (const std::string& file : files) {
    add(file);
  }
}

void PresetLibrary::add(const std::string& file) {
  XmlDocument document = parseXml(textOf(file), file, XmlNamespaces::kRefused);
  const XmlElement root(xmlDocGetRootElement(document.get()), &file);
  if (root.name() != "realism") {
    root.refuse("found the root element <" + root.name() + ">, allowed: <realism>");
  }
  RealismPreset about = subjectOf(root);
  about.file = file;
  root.allowChildren({"preset"});
  for (xmlNode* element : elementsOf(*xmlDocGetRootElement(document.get()))) {
    const XmlElement preset(element, &file);
    preset.allowAttributes({"name", "source"});
    preset.refuseText();
    about.name = preset.requireAttribute("name");
    about.source = preset.requireAttribute("source");
    about.content = contentOf(*element);
    if (about.name == kIdealRealism) {
      preset.refuse("name: found 'ideal', which means no preset, allowed: another name");
    }
    if (const Preset* known = find(about.kind, about.device, about.name); known != nullptr) {
      preset.refuse("found a second preset '" + about.name + "' of '" + about.device +
                    "', allowed: one; the first is in " + known->about.file);
    }
    presets_.push_back({about, element});
  }
  documents_.push_back(std::move(document));
}

const PresetLibrary::Preset* PresetLibrary::find(PluginKind kind, const std::string& device,
                                                 const std::string& name) const {
  const auto found = std::find_if(presets_.begin(), presets_.end(), [&](const Preset& preset) {
    return preset.about.kind == kind && preset.about.device == device && preset.about.name == name;
  });
  return found == presets_.end() ? nullptr : &*found;
}

const PresetLibrary& installedPresets() {
  static const PresetLibrary library(robotFiles().presets);  // after an exception the next caller tries again
  return library;
}

}  // namespace swarmanoid::experiment

namespace swarmanoid {

std::vector<RealismPreset> realismPresets() {
  std::vector<RealismPreset> presets;
  for (const auto& preset : experiment::installedPresets().all()) {
    presets.push_back(preset.about);
  }
  std::sort(presets.begin(), presets.end(), [](const RealismPreset& a, const RealismPreset& b) {
    return std::tie(a.device, a.kind, a.name) < std::tie(b.device, b.kind, b.name);
  });
  return presets;
}

const std::vector<std::string>& realismNames() {
  static const std::vector<std::string> names = [] {
    std::set<std::string> found;
    for (const std::string& file : robotFiles().presets) {
      experiment::PresetLibrary library;
      try {
        library.add(file);
      } catch (const ConfigError&) {
        continue;  // an experiment that names a preset reports it
      }
      for (const auto& preset : library.all()) {
        found.insert(preset.about.name);
      }
    }
    std::vector<std::string> all{kIdealRealism};
    all.insert(all.end(), found.begin(), found.end());
    return all;
  }();
  return names;
}

}  // namespace swarmanoid
