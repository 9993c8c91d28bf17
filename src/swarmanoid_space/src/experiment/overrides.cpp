// "path=value" from the command line, put into the document before it is read.
#include "reader.hpp"

namespace swarmanoid::experiment {
namespace {

/// The child with that tag, or with that id; null if there is none.
tinyxml2::XMLElement* findChild(tinyxml2::XMLElement* parent, const std::string& name) {
  for (auto* child = parent->FirstChildElement(); child != nullptr; child = child->NextSiblingElement()) {
    const char* id = child->Attribute("id");
    if (name == child->Name() || (id != nullptr && name == id)) {
      return child;
    }
    // an entity in <distribute> is found as if it stood beside the others
    if (std::string(child->Name()) == "distribute") {
      if (auto* inner = findChild(child, name)) {
        return inner;
      }
    }
  }
  return nullptr;
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

void apply(tinyxml2::XMLDocument& document, const Override& change) {
  const std::vector<std::string> parts = split(change.path);
  tinyxml2::XMLElement* element = document.RootElement();
  for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
    tinyxml2::XMLElement* child = findChild(element, parts[i]);
    if (child == nullptr) {
      throw ConfigError({"--set " + change.path, 0},
                        "found no '" + parts[i] + "' in <" + element->Name() + ">, neither a tag nor an id");
    }
    element = child;
  }
  const std::string& last = parts.back();
  if (element->Attribute(last.c_str()) != nullptr) {
    element->SetAttribute(last.c_str(), change.value.c_str());
    return;
  }
  tinyxml2::XMLElement* target = findChild(element, last);
  if (target == nullptr) {
    if (last.empty() || element == document.RootElement()) {
      throw ConfigError({"--set " + change.path, 0}, "allowed: section.name, such as framework.maxclock");
    }
    target = element->InsertNewChildElement(last.c_str());
  }
  target->SetText(change.value.c_str());
  target->SetUserData(const_cast<std::string*>(&change.path));
}

}  // namespace

void applyOverrides(tinyxml2::XMLDocument& document, const std::vector<Override>& overrides) {
  for (const Override& change : overrides) {
    apply(document, change);
  }
}

}  // namespace swarmanoid::experiment
