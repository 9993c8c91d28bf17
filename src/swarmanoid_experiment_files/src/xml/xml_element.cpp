#include "swarmanoid_experiment_files/xml/xml_element.hpp"

#include <set>

#include "swarmanoid_interface/contains.hpp"

namespace swarmanoid::experiment {

SourceLocation XmlElement::location() const {
  for (const xmlNode* node = element_; node != nullptr; node = node->parent) {
    const auto* marks = static_cast<const OverrideMarks*>(node->_private);
    if (marks != nullptr && !marks->file.empty()) {
      return {marks->file, lineOf(element_)};
    }
    if (marks != nullptr && !marks->text.empty()) {
      return {"--set " + marks->text, 0};
    }
  }
  return {*file_, lineOf(element_)};
}

SourceLocation XmlElement::attributeLocation(const char* name) const {
  if (const auto* marks = static_cast<const OverrideMarks*>(element_->_private)) {
    const auto mark = marks->attributes.find(name);
    if (mark != marks->attributes.end()) {
      return {"--set " + mark->second, 0};
    }
  }
  return location();
}

std::string XmlElement::text() const {
  if (xmlNode* child = xmlFirstElementChild(element_)) {
    const XmlElement inner(child, file_);
    inner.refuse("found <" + inner.name() + "> in <" + name() + ">, allowed: only a value");
  }
  return trimmed(textIn(element_->children));
}

std::optional<std::string> XmlElement::attribute(const char* name) const {
  const std::optional<std::string> text = attributeOf(*element_, name);
  return text ? std::optional<std::string>(trimmed(*text)) : std::nullopt;
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
  for (xmlNode* child : elementsOf(*element_)) {
    result.emplace_back(child, file_);
  }
  return result;
}

std::optional<XmlElement> XmlElement::child(const char* child_name) const {
  std::optional<XmlElement> found;
  for (xmlNode* child : elementsOf(*element_)) {
    if (nameOf(*child) == child_name) {
      const XmlElement entry(child, file_);
      if (found) {
        entry.refuse("found a second <" + entry.name() + "> in <" + name() + ">, allowed: one");
      }
      found = entry;
    }
  }
  return found;
}

void XmlElement::allowAttributes(const std::vector<std::string>& names) const {
  for (const xmlAttr* entry = element_->properties; entry != nullptr; entry = entry->next) {
    if (!contains(names, characters(entry->name))) {
      refuse(unknownName("attribute", characters(entry->name), names) + " (in <" + name() + ">)");
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
  for (const xmlNode* node = element_->children; node != nullptr; node = node->next) {
    const std::string text = node->type == XML_TEXT_NODE ? trimmed(characters(node->content)) : "";
    if (!text.empty()) {
      throw ConfigError({location().file, lineOf(node)},
                        "found the text '" + text + "' in <" + name() + ">, allowed: only elements");
    }
  }
}

void XmlElement::refuseDoubles() const {
  std::set<std::string> names;
  for (const XmlElement& entry : children()) {
    if (attribute(entry.name().c_str())) {
      entry.refuse("found <" + entry.name() + "> beside the attribute of that name in <" + name() + ">, allowed: one");
    }
    if (!names.insert(entry.name()).second) {
      child(entry.name().c_str());  // throws with the location of the second one
    }
  }
}

Configuration XmlElement::toConfiguration() const {
  Configuration result(name(), trimmed(textIn(element_->children)), location());
  for (const xmlAttr* entry = element_->properties; entry != nullptr; entry = entry->next) {
    const char* attribute_name = characters(entry->name);
    result.add(Configuration(attribute_name, trimmed(textIn(entry->children)), attributeLocation(attribute_name)));
  }
  for (const XmlElement& entry : children()) {
    result.add(entry.toConfiguration());
  }
  return result;
}

}  // namespace swarmanoid::experiment
