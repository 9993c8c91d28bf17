#include "swarmanoid_experiment_files/xml/xml_node.hpp"

namespace swarmanoid {

std::string textIn(const xmlNode* first_child) {
  std::string text;
  for (const xmlNode* node = first_child; node != nullptr; node = node->next) {
    if (node->type == XML_TEXT_NODE) {
      text += characters(node->content);
    }
  }
  return text;
}

std::string trimmed(const std::string& text) {
  constexpr const char* kSpace = " \t\r\n";
  const auto first = text.find_first_not_of(kSpace);
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

std::optional<std::string> attributeOf(const xmlNode& element, const char* name) {
  const xmlAttr* attribute = xmlHasProp(&element, xmlCharacters(name));
  return attribute == nullptr ? std::nullopt : std::optional<std::string>(textIn(attribute->children));
}

std::vector<xmlNode*> elementsOf(const xmlNode& parent) {
  std::vector<xmlNode*> elements;
  for (xmlNode* child = parent.children; child != nullptr; child = child->next) {
    if (child->type == XML_ELEMENT_NODE) {
      elements.push_back(child);
    }
  }
  return elements;
}

xmlNode* childOf(const xmlNode& parent, const std::string& name) {
  for (xmlNode* child : elementsOf(parent)) {
    if (nameOf(*child) == name) {
      return child;
    }
  }
  return nullptr;
}

}  // namespace swarmanoid
