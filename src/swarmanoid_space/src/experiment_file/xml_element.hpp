/// An element of an experiment file, read strictly: whoever reads it says what is allowed, and the rest is refused.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "../xml/xml_document.hpp"
#include "../xml/xml_node.hpp"
#include "swarmanoid_interface/configuration.hpp"

namespace swarmanoid::experiment {

/// Where something of an element is from that the file does not say; hung on the element as its private data.
struct OverrideMarks {
  std::string file;                               ///< that the element is from, with presets; "": the document's
  std::string text;                               ///< path of the override that set the element's text; "" for none
  std::map<std::string, std::string> attributes;  ///< and of those that set attributes, by attribute
};

class XmlElement {
 public:
  XmlElement(xmlNode* element, const std::string* file) : element_(element), file_(file) {}

  std::string name() const { return nameOf(*element_); }
  /// Where it stands; for what an override has set, the override.
  SourceLocation location() const;
  /// The same for one attribute.
  SourceLocation attributeLocation(const char* name) const;
  /// The text without surrounding white space. @throws ConfigError if there are elements in it
  std::string text() const;
  std::optional<std::string> attribute(const char* name) const;
  /// @throws ConfigError if it is not there
  std::string requireAttribute(const char* name) const;
  std::vector<XmlElement> children() const;
  /// The only child of that name. @throws ConfigError if there are two
  std::optional<XmlElement> child(const char* name) const;

  /// @throws ConfigError for the first attribute that is not among the names
  void allowAttributes(const std::vector<std::string>& names) const;
  /// @throws ConfigError for the first child element that is not among the names, and for text between elements
  void allowChildren(const std::vector<std::string>& names) const;
  /// @throws ConfigError for text beside the child elements
  void refuseText() const;

  /// The whole element with everything in it, attributes and child elements alike, unchecked.
  Configuration toConfiguration() const;
  /// @throws ConfigError for the first child element whose name, an attribute's or another child's, is taken
  void refuseDoubles() const;

  [[noreturn]] void refuse(const std::string& message) const { throw ConfigError(location(), message); }

 private:
  xmlNode* element_;
  const std::string* file_;
};

}  // namespace swarmanoid::experiment
