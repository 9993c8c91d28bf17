#include "xml_node.hpp"

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

}  // namespace swarmanoid
