/// Helper functions for libxml2's trees.
#pragma once

#include <libxml/tree.h>

#include <optional>
#include <string>
#include <vector>

namespace swarmanoid {

/// Converts libxml2's strings of unsigned bytes; null stays null.
inline const char* characters(const xmlChar* text) { return reinterpret_cast<const char*>(text); }
inline const xmlChar* xmlCharacters(const char* text) { return reinterpret_cast<const xmlChar*>(text); }

/// Text directly in an element or attribute, given the first of its children.
std::string textIn(const xmlNode* first_child);

/// Returns the text without white space at either end.
std::string trimmed(const std::string& text);

/// Name of an element, without the prefix of a namespace.
inline std::string nameOf(const xmlNode& element) { return characters(element.name); }

/// Value of an element's attribute, unmodified; nothing if there is no such attribute.
std::optional<std::string> attributeOf(const xmlNode& element, const char* name);

/// Child elements, in document order.
std::vector<xmlNode*> elementsOf(const xmlNode& parent);

/// First child element with that name; null if there is none.
xmlNode* childOf(const xmlNode& parent, const std::string& name);

}  // namespace swarmanoid
