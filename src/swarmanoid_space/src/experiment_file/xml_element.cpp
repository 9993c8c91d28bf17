#include "xml_element.hpp"

#include <algorithm>
#include <set>

namespace swarmanoid::experiment {
namespace {

std::string trimmed(const std::string& text) {
  constexpr const char* kSpace = " \t\r\n";
  const auto first = text.find_first_not_of(kSpace);
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

SourceLocation XmlElement::location() const {
  for (const tinyxml2::XMLNode* node = element_; node != nullptr; node = node->Parent()) {
    const auto* marks = static_cast<const OverrideMarks*>(node->GetUserData());
    if (marks != nullptr && !marks->text.empty()) {
      return {"--set " + marks->text, 0};
    }
  }
  return {*file_, element_->GetLineNum()};
}

SourceLocation XmlElement::attributeLocation(const char* name) const {
  if (const auto* marks = static_cast<const OverrideMarks*>(element_->GetUserData())) {
    const auto mark = marks->attributes.find(name);
    if (mark != marks->attributes.end()) {
      return {"--set " + mark->second, 0};
    }
  }
  return location();
}

std::string XmlElement::text() const {
  if (const tinyxml2::XMLElement* child = element_->FirstChildElement()) {
    XmlElement(child, file_)
        .refuse("found <" + std::string(child->Name()) + "> in <" + name() + ">, allowed: only a value");
  }
  std::string text;
  for (const tinyxml2::XMLNode* node = element_->FirstChild(); node != nullptr; node = node->NextSibling()) {
    if (const tinyxml2::XMLText* part = node->ToText()) {
      text += part->Value();
    }
  }
  return trimmed(text);
}

std::optional<std::string> XmlElement::attribute(const char* name) const {
  const char* value = element_->Attribute(name);
  return value == nullptr ? std::nullopt : std::optional<std::string>(trimmed(value));
}

std::string XmlElement::requireAttribute(const char* attribute_name) const {
  const auto value = attribute(attribute_name);
  if (!value || value->empty()) {
    throw ConfigError(attributeLocation(attribute_name),
                      "<" + name() + "> needs the attribute " + attribute_name + "=\"...\"");
  }
  return *value;
}

std::vector<XmlElement> XmlElement::children() const {
  std::vector<XmlElement> result;
  for (const auto* child = element_->FirstChildElement(); child != nullptr; child = child->NextSiblingElement()) {
    result.emplace_back(child, file_);
  }
  return result;
}

std::optional<XmlElement> XmlElement::child(const char* child_name) const {
  const auto* first = element_->FirstChildElement(child_name);
  if (first == nullptr) {
    return std::nullopt;
  }
  if (const auto* second = first->NextSiblingElement(child_name)) {
    XmlElement(second, file_)
        .refuse("found a second <" + std::string(child_name) + "> in <" + name() + ">, allowed: one");
  }
  return XmlElement(first, file_);
}

void XmlElement::allowAttributes(const std::vector<std::string>& names) const {
  for (const auto* entry = element_->FirstAttribute(); entry != nullptr; entry = entry->Next()) {
    if (!contains(names, entry->Name())) {
      refuse(unknownName("attribute", entry->Name(), names) + " (in <" + name() + ">)");
    }
  }
}

void XmlElement::allowChildren(const std::vector<std::string>& names) const {
  for (const XmlElement& entry : children()) {
    if (!contains(names, entry.name())) {
      entry.refuse(unknownName("tag", entry.name(), names) + " (in <" + name() + ">)");
    }
  }
  refuseText();
}

void XmlElement::refuseText() const {
  for (const tinyxml2::XMLNode* node = element_->FirstChild(); node != nullptr; node = node->NextSibling()) {
    const tinyxml2::XMLText* text = node->ToText();
    if (text != nullptr && !trimmed(text->Value()).empty()) {
      throw ConfigError({location().file, text->GetLineNum()},
                        "found the text '" + trimmed(text->Value()) + "' in <" + name() + ">, allowed: only elements");
    }
  }
}

void XmlElement::refuseDoubles() const {
  std::set<std::string> names;
  for (const XmlElement& entry : children()) {
    if (element_->Attribute(entry.name().c_str()) != nullptr) {
      entry.refuse("found <" + entry.name() + "> beside the attribute of that name in <" + name() + ">, allowed: one");
    }
    if (!names.insert(entry.name()).second) {
      child(entry.name().c_str());  // says which one is the second
    }
  }
}

Configuration XmlElement::toConfiguration() const {
  std::string own_text;
  for (const tinyxml2::XMLNode* node = element_->FirstChild(); node != nullptr; node = node->NextSibling()) {
    if (const tinyxml2::XMLText* part = node->ToText()) {
      own_text += part->Value();
    }
  }
  Configuration result(name(), trimmed(own_text), location());
  for (const auto* entry = element_->FirstAttribute(); entry != nullptr; entry = entry->Next()) {
    result.add(Configuration(entry->Name(), trimmed(entry->Value()), attributeLocation(entry->Name())));
  }
  for (const XmlElement& entry : children()) {
    result.add(entry.toConfiguration());
  }
  return result;
}

}  // namespace swarmanoid::experiment
