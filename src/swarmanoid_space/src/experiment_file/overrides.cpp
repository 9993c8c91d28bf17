// "path=value" from the command line, put into the document before it is read.
#include <algorithm>

#include "reader.hpp"

namespace swarmanoid::experiment {
namespace {

using tinyxml2::XMLElement;

[[noreturn]] void refuse(const Override& change, const std::string& message) {
  throw ConfigError({"--set " + change.path, 0}, message);
}

bool hasTag(const XMLElement* element, const std::string& tag) {
  const std::string name = element->Name();
  const auto american = [](const std::string& word) { return word == "visualisations" ? "visualizations" : word; };
  return american(name) == american(tag);
}

std::string idOf(const XMLElement* element) {
  const char* id = element->Attribute("id");
  return id == nullptr ? "" : id;
}

/// The element's children; an entity in <distribute> is found as if it stood beside the others.
std::vector<XMLElement*> childrenOf(XMLElement* parent) {
  std::vector<XMLElement*> children;
  for (auto* child = parent->FirstChildElement(); child != nullptr; child = child->NextSiblingElement()) {
    children.push_back(child);
    if (hasTag(child, "distribute")) {
      for (auto* inner = child->FirstChildElement(); inner != nullptr; inner = inner->NextSiblingElement()) {
        if (!idOf(inner).empty()) {
          children.push_back(inner);
        }
      }
    }
  }
  return children;
}

/// The child with that id, or else the only one with that tag; null if there is none.
XMLElement* findChild(XMLElement* parent, const std::string& name, const Override& change) {
  XMLElement* found = nullptr;
  int count = 0;
  for (XMLElement* child : childrenOf(parent)) {
    if (idOf(child) == name) {
      return child;
    }
    if (hasTag(child, name)) {
      found = child;
      ++count;
    }
  }
  if (count > 1) {
    refuse(change, "found " + std::to_string(count) + " <" + name + "> in <" + parent->Name() +
                       ">, allowed: a tag that stands there once, or an id");
  }
  return found;
}

std::vector<std::string> namesIn(XMLElement* parent) {
  std::vector<std::string> names;
  for (XMLElement* child : childrenOf(parent)) {
    names.push_back(idOf(child).empty() ? child->Name() : idOf(child));
  }
  return names;
}

/// Whether a value of that name belongs into an attribute, even if the file does not give it.
bool isAttribute(const XMLElement* element, const std::string& name) {
  if (element->Attribute(name.c_str()) != nullptr) {
    return true;
  }
  const auto among = [&name](const std::vector<std::string>& names) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  const auto* parent = element->Parent()->ToElement();
  const std::string parent_tag = parent == nullptr ? "" : parent->Name();
  if (hasTag(element, "arena") && parent != nullptr && parent->Parent()->ToDocument() != nullptr) {
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
    const bool is_rule = std::find(rules.begin(), rules.end(), element->Name()) != rules.end();
    return is_rule && among(attributesOf(std::string("arena_physics/handover/") + element->Name()));
  }
  if (hasTag(element, "controller") && parent_tag != "controllers") {
    return among(attributesOf("arena/*/controller"));
  }
  const bool is_plugin = parent_tag == "controllers" || parent_tag == "engines" || parent_tag == "visualisations" ||
                         parent_tag == "visualizations";
  const bool is_device = parent_tag == "actuators" || parent_tag == "sensors";
  // these are the same in all sections
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

OverrideMarks& marksOf(XMLElement* element, std::deque<OverrideMarks>& all) {
  if (element->GetUserData() == nullptr) {
    element->SetUserData(&all.emplace_back());
  }
  return *static_cast<OverrideMarks*>(element->GetUserData());
}

void apply(XMLElement* root, const Override& change, std::deque<OverrideMarks>& marks) {
  const std::vector<std::string> parts = split(change.path);
  if (parts.size() < 2 || std::find(parts.begin(), parts.end(), "") != parts.end()) {
    refuse(change, "allowed: section.name, such as framework.maxclock");
  }
  XMLElement* element = root;
  for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
    XMLElement* child = findChild(element, parts[i], change);
    if (child == nullptr) {
      refuse(change, unknownName("no tag or id", parts[i], namesIn(element)) + " (in <" + element->Name() + ">)");
    }
    element = child;
  }
  const std::string& last = parts.back();
  if (isAttribute(element, last)) {
    element->SetAttribute(last.c_str(), change.value.c_str());
    marksOf(element, marks).attributes[last] = change.path;
    return;
  }
  XMLElement* target = findChild(element, last, change);
  if (target == nullptr) {
    target = element->InsertNewChildElement(last.c_str());
  } else if (target->FirstChildElement() != nullptr) {
    refuse(change, "found <" + std::string(target->Name()) + ">, which holds elements, allowed: the path of a value");
  }
  target->DeleteChildren();  // a comment before the old text would survive SetText, and the old text with it
  target->SetText(change.value.c_str());
  marksOf(target, marks).text = change.path;
}

}  // namespace

std::deque<OverrideMarks> applyOverrides(tinyxml2::XMLDocument& document, const std::vector<Override>& overrides) {
  std::deque<OverrideMarks> marks;
  for (const Override& change : overrides) {
    apply(document.RootElement(), change, marks);
  }
  return marks;
}

}  // namespace swarmanoid::experiment
