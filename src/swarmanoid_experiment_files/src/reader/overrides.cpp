// Overrides "path=value" from the command line, applied to the document before it is read.
#include <algorithm>

#include "reader.hpp"
#include "swarmanoid_interface/contains.hpp"

namespace swarmanoid::experiment {
namespace {

[[noreturn]] void refuse(const Override& change, const std::string& message) {
  throw ConfigError({"--set " + change.path, 0}, message);
}

bool hasTag(const xmlNode* element, const std::string& tag) {
  const std::string name = nameOf(*element);
  const auto american = [](const std::string& word) { return word == "visualisations" ? "visualizations" : word; };
  return american(name) == american(tag);
}

std::string idOf(const xmlNode* element) { return attributeOf(*element, "id").value_or(""); }

/// Returns the element's children; entities in <distribute> are listed like their siblings outside.
std::vector<xmlNode*> childrenOf(xmlNode* parent) {
  std::vector<xmlNode*> children;
  for (xmlNode* child : elementsOf(*parent)) {
    children.push_back(child);
    if (hasTag(child, "distribute")) {
      for (xmlNode* inner : elementsOf(*child)) {
        if (!idOf(inner).empty()) {
          children.push_back(inner);
        }
      }
    }
  }
  return children;
}

/// Returns the child with that id, or else the only one with that tag; null if there is none.
xmlNode* findChild(xmlNode* parent, const std::string& name, const Override& change) {
  xmlNode* found = nullptr;
  int count = 0;
  for (xmlNode* child : childrenOf(parent)) {
    if (idOf(child) == name) {
      return child;
    }
    if (hasTag(child, name)) {
      found = child;
      ++count;
    }
  }
  if (count > 1) {
    refuse(change, "found " + std::to_string(count) + " <" + name + "> in <" + nameOf(*parent) +
                       ">, allowed: a tag that stands there once, or an id");
  }
  return found;
}

std::vector<std::string> namesIn(xmlNode* parent) {
  std::vector<std::string> names;
  for (xmlNode* child : childrenOf(parent)) {
    names.push_back(idOf(child).empty() ? nameOf(*child) : idOf(child));
  }
  return names;
}

/// Returns whether a value with that name is an attribute of the element, even if the file does not set it.
bool isAttribute(const xmlNode* element, const std::string& name) {
  if (attributeOf(*element, name.c_str())) {
    return true;
  }
  const auto among = [&name](const std::vector<std::string>& names) { return contains(names, name); };
  const xmlNode* root = xmlDocGetRootElement(element->doc);
  const std::string parent_tag = element == root ? "" : nameOf(*element->parent);
  if (hasTag(element, "arena") && element->parent == root) {
    return among(attributesOf("arena"));
  }
  if (hasTag(element, "distribute") && parent_tag == "arena") {
    return among(attributesOf("arena/distribute"));
  }
  if (hasTag(element, "entity") && parent_tag == "engine") {
    return among(attributesOf("arena_physics/engine/entity"));
  }
  if (hasTag(element, "handover") && parent_tag == "arena_physics") {
    return among(attributesOf("arena_physics/handover"));
  }
  if (parent_tag == "handover") {
    const std::vector<std::string> rules = tagsIn("arena_physics/handover");
    const bool is_rule = contains(rules, nameOf(*element));
    return is_rule && among(attributesOf("arena_physics/handover/" + nameOf(*element)));
  }
  if (hasTag(element, "controller") && parent_tag != "controllers") {
    return among(attributesOf("arena/*/controller"));
  }
  const xmlNode* section = element == root || element->parent == root ? nullptr : element->parent->parent;
  if (hasTag(element, "error") && section != nullptr && (hasTag(section, "sensors") || hasTag(section, "actuators"))) {
    return among(attributesOf("controllers/*/sensors/*/error"));
  }
  const bool is_plugin = parent_tag == "controllers" || parent_tag == "engines" || parent_tag == "rules" ||
                         parent_tag == "visualisations" || parent_tag == "visualizations";
  const bool is_device = parent_tag == "actuators" || parent_tag == "sensors";
  // the same in all sections
  return (is_plugin && among(attributesOf("engines/*"))) ||
         (is_device && among(attributesOf("controllers/*/sensors/*")));
}

std::vector<std::string> split(const std::string& path) {
  std::vector<std::string> parts{""};
  for (const char c : path) {
    if (c == '.') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

/// Returns whether XML does not allow the character. At a zero byte the library would stop as if the text ended there.
bool isControl(unsigned char c) { return c < ' ' && c != '\t' && c != '\n' && c != '\r'; }

bool hasControl(const std::string& text) { return std::any_of(text.begin(), text.end(), isControl); }

OverrideMarks& marksOf(xmlNode* element, std::deque<OverrideMarks>& all) {
  if (element->_private == nullptr) {
    element->_private = &all.emplace_back();
  }
  return *static_cast<OverrideMarks*>(element->_private);
}

void apply(xmlNode* root, const Override& change, std::deque<OverrideMarks>& marks) {
  const std::vector<std::string> parts = split(change.path);
  if (parts.size() < 2 || contains(parts, "")) {
    refuse(change, "allowed: section.name, such as framework.maxclock");
  }
  if (hasControl(change.path) || hasControl(change.value)) {
    std::string shown = change.path;
    std::replace_if(shown.begin(), shown.end(), isControl, '?');
    refuse({shown, ""}, "found a control character, such as a zero byte, allowed: text");
  }
  const xmlChar* value = xmlCharacters(change.value.c_str());
  if (xmlCheckUTF8(value) == 0) {
    refuse(change, "found bytes that are no text in UTF-8, allowed: UTF-8");
  }
  xmlNode* element = root;
  for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
    xmlNode* child = findChild(element, parts[i], change);
    if (child == nullptr) {
      refuse(change, unknownName("no tag or id", parts[i], namesIn(element)) + " (in <" + nameOf(*element) + ">)");
    }
    element = child;
  }
  const std::string& last = parts.back();
  if (isAttribute(element, last)) {
    xmlSetProp(element, xmlCharacters(last.c_str()), value);
    marksOf(element, marks).attributes[last] = change.path;
    return;
  }
  xmlNode* target = findChild(element, last, change);
  if (target == nullptr) {
    target = xmlNewChild(element, nullptr, xmlCharacters(last.c_str()), nullptr);
  } else if (xmlFirstElementChild(target) != nullptr) {
    refuse(change, "found <" + nameOf(*target) + ">, which holds elements, allowed: the path of a value");
  }
  xmlNodeSetContent(target, nullptr);
  xmlNodeAddContent(target, value);  // literally, while xmlNodeSetContent would look for entities in it
  marksOf(target, marks).text = change.path;
}

}  // namespace

std::deque<OverrideMarks> applyOverrides(xmlDoc& document, const std::vector<Override>& overrides) {
  std::deque<OverrideMarks> marks;
  for (const Override& change : overrides) {
    apply(xmlDocGetRootElement(&document), change, marks);
  }
  return marks;
}

}  // namespace swarmanoid::experiment
