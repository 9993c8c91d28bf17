/// An element of an experiment file, read strictly: the reader declares the allowed content, and anything else is
/// refused.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "swarmanoid_experiment_files/xml/xml_document.hpp"
#include "swarmanoid_experiment_files/xml/xml_node.hpp"
#include "swarmanoid_interface/configuration.hpp"

namespace swarmanoid::experiment {

/// Origins of an element's contents that differ from the file; attached to the element as its private data.
struct OverrideMarks {
  std::string file;  ///< file of the preset that the element comes from; "": the document's file
  std::string text;  ///< path of the override that set the element's text; "" for none
  std::map<std::string, std::string> attributes;  ///< paths of the overrides that set attributes, by attribute
};

class XmlElement {
 public:
  XmlElement(xmlNode* element, const std::string* file) : element_(element), file_(file) {}

  std::string name() const { return nameOf(*element_); }
  /// Location of the element; the override if one has set its text.
  SourceLocation location() const;
  /// Location of an attribute; the override if one has set it.
  SourceLocation attributeLocation(const char* name) const;
  /// Text without surrounding white space. @throws ConfigError if the element has child elements
  std::string text() const;
  std::optional<std::string> attribute(const char* name) const;
  /// @throws ConfigError if it is not there
  std::string requireAttribute(const char* name) const;
  std::vector<XmlElement> children() const;
  /// The only child with that name. @throws ConfigError if there are two
  std::optional<XmlElement> child(const char* name) const;

  /// @throws ConfigError for the first attribute that is not among the names
  void allowAttributes(const std::vector<std::string>& names) const;
  /// @throws ConfigError for the first child element that is not among the names, and for text between elements
  void allowChildren(const std::vector<std::string>& names) const;
  /// @throws ConfigError for text beside the child elements
  void refuseText() const;

  /// The whole element with all its contents, unchecked; attributes become children as well.
  Configuration toConfiguration() const;
  /// @throws ConfigError for the first child element that has the name of an attribute or of another child
  void refuseDoubles() const;

  [[noreturn]] void refuse(const std::string& message) const { throw ConfigError(location(), message); }

 private:
  xmlNode* element_;
  const std::string* file_;
};

}  // namespace swarmanoid::experiment
