/// Short readers of libxml2's trees.
#pragma once

#include <libxml/tree.h>

#include <optional>
#include <string>
#include <vector>

namespace swarmanoid {

/// libxml2's strings are of bytes without a sign; null stays null.
inline const char* characters(const xmlChar* text) { return reinterpret_cast<const char*>(text); }
inline const xmlChar* xmlCharacters(const char* text) { return reinterpret_cast<const xmlChar*>(text); }

/// The text that stands in an element or attribute itself, given the first of its children.
std::string textIn(const xmlNode* first_child);

/// Without white space at either end.
std::string trimmed(const std::string& text);

/// Of an element, without the prefix of a namespace.
inline std::string nameOf(const xmlNode& element) { return characters(element.name); }

/// The value of an element's attribute, as it stands there; nothing if it is not there.
std::optional<std::string> attributeOf(const xmlNode& element, const char* name);

/// The child elements, in their order.
std::vector<xmlNode*> elementsOf(const xmlNode& parent);

/// The first child element of that name; null if there is none.
xmlNode* childOf(const xmlNode& parent, const std::string& name);

}  // namespace swarmanoid
