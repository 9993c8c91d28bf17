// <realism>: inserts presets into the document before it is read.
#include <algorithm>
#include <new>
#include <utility>

#include "parameter_table.hpp"
#include "realism_presets.hpp"

namespace swarmanoid::experiment {
namespace {

constexpr const char* kTag = "realism";
constexpr const char* kImplementation = "implementation";
constexpr const char* kError = "error";

/// Returns whether the file sets errors of the device, by <error> or by the older noise parameters, which are
/// equivalent.
bool saysErrors(const xmlNode& device) {
  const std::vector<xmlNode*> children = elementsOf(device);
  return std::any_of(children.begin(), children.end(), [](const xmlNode* child) {
    return nameOf(*child) == kError || nameOf(*child).rfind("noise", 0) == 0;
  });
}

/// Returns whether the entity has a battery.
bool hasBattery(const xmlNode& entity) {
  const xmlNode* battery = childOf(entity, "battery");
  return battery != nullptr && trimmed(textIn(battery->children)) == "true";
}

/// Returns the type of a tag, which may be an alias.
std::string typeOf(PluginKind kind, const std::string& tag) {
  const Registry::Entry* entry = Registry::instance().find(kind, tag);
  return entry == nullptr ? tag : entry->description.label;
}

class Application {
 public:
  Application(const std::string& file, const PresetSource& presets, std::deque<OverrideMarks>& marks)
      : file_(file), presets_(presets), marks_(marks) {}

  /// Returns the preset that an element names, or else `outer`.
  std::string nameIn(xmlNode& element, const std::string& outer) const {
    xmlNode* child = childOf(element, kTag);
    if (child == nullptr) {
      return outer;
    }
    const XmlElement realism(child, &file_);
    realism.allowAttributes({});
    checkValue(realismParameter(), realism.text(), realism.location());
    return realism.text();
  }

  void complete(xmlNode& device, PluginKind kind, const std::string& outer) const {
    const std::string name = kind == PluginKind::kEntity ? outer : nameIn(device, outer);
    const auto* preset = name == kIdealRealism ? nullptr : presets_().find(kind, typeOf(kind, nameOf(device)), name);
    if (preset == nullptr) {
      return;
    }
    const bool takes_values = isItsImplementation(device, *preset->element);
    const bool takes_errors = !saysErrors(device);
    for (xmlNode* child : elementsOf(*preset->element)) {
      const bool is_error = nameOf(*child) == kError;
      if (kind == PluginKind::kEntity && nameOf(*child).rfind("battery_", 0) == 0 && !hasBattery(device)) {
        continue;
      }
      if (is_error ? takes_errors : takes_values && childOf(device, nameOf(*child)) == nullptr) {
        append(device, *child, preset->about.file);
      }
    }
  }

 private:
  /// Returns whether the file sets no implementation, or that of the preset.
  bool isItsImplementation(const xmlNode& device, const xmlNode& preset) const {
    const xmlNode* wanted = childOf(device, kImplementation);
    const xmlNode* given = childOf(preset, kImplementation);
    return wanted == nullptr ||
           (given != nullptr && trimmed(textIn(wanted->children)) == trimmed(textIn(given->children)));
  }

  void append(xmlNode& device, xmlNode& child, const std::string& preset_file) const {
    constexpr int kDeep = 1;
    xmlNode* copy = xmlDocCopyNode(&child, device.doc, kDeep);
    if (copy == nullptr) {
      throw std::bad_alloc();
    }
    marks_.emplace_back();
    marks_.back().file = preset_file;
    copy->_private = &marks_.back();
    copy->psvi = child.psvi;  // line number
    xmlAddChild(&device, copy);
  }

  const std::string& file_;
  const PresetSource& presets_;
  std::deque<OverrideMarks>& marks_;
};

/// Calls visit(element, kind) for the devices of a controller.
template <class Visit>
void visitDevices(const xmlNode& controller, Visit visit) {
  for (const auto& [section, kind] :
       {std::pair("sensors", PluginKind::kSensor), std::pair("actuators", PluginKind::kActuator)}) {
    if (const xmlNode* devices = childOf(controller, section)) {
      for (xmlNode* device : elementsOf(*devices)) {
        visit(*device, kind);
      }
    }
  }
}

/// Calls visit(element) for the controllers.
template <class Visit>
void visitControllers(const xmlNode& root, Visit visit) {
  if (const xmlNode* controllers = childOf(root, "controllers")) {
    for (xmlNode* controller : elementsOf(*controllers)) {
      visit(*controller);
    }
  }
}

/// Calls visit(element) for the entities, also for those that are distributed.
template <class Visit>
void visitEntities(const xmlNode& root, Visit visit) {
  if (const xmlNode* arena = childOf(root, "arena")) {
    for (xmlNode* entity : elementsOf(*arena)) {
      visit(*entity);
      if (nameOf(*entity) == "distribute") {
        for (xmlNode* distributed : elementsOf(*entity)) {
          visit(*distributed);
        }
      }
    }
  }
}

}  // namespace

void applyRealism(xmlDoc& document, const std::string& file, const PresetSource& presets,
                  std::deque<OverrideMarks>& marks) {
  xmlNode& root = *xmlDocGetRootElement(&document);
  const Application application(file, presets, marks);
  xmlNode* framework = childOf(root, "framework");
  const std::string of_all = framework == nullptr ? kIdealRealism : application.nameIn(*framework, kIdealRealism);
  visitControllers(root, [&](xmlNode& controller) {
    const std::string of_controller = application.nameIn(controller, of_all);
    visitDevices(controller,
                 [&](xmlNode& device, PluginKind kind) { application.complete(device, kind, of_controller); });
  });
  visitEntities(root, [&](xmlNode& entity) { application.complete(entity, PluginKind::kEntity, of_all); });
}

void removeRealism(xmlDoc& document) {
  const auto set_ideal = [](xmlNode& element) {
    xmlNode* realism = childOf(element, kTag);
    const std::string name = realism == nullptr ? kIdealRealism : trimmed(textIn(realism->children));
    if (name != kIdealRealism) {
      const std::string comment = " " + name + ": what it means is said in the devices ";
      xmlAddPrevSibling(realism, xmlNewDocComment(element.doc, xmlCharacters(comment.c_str())));
      xmlNodeSetContent(realism, xmlCharacters(kIdealRealism));
    }
  };
  xmlNode& root = *xmlDocGetRootElement(&document);
  if (xmlNode* framework = childOf(root, "framework")) {
    set_ideal(*framework);
  }
  visitControllers(root, [&](xmlNode& controller) {
    set_ideal(controller);
    visitDevices(controller, [&](xmlNode& device, PluginKind /*kind*/) { set_ideal(device); });
  });
}

}  // namespace swarmanoid::experiment
