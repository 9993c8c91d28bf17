/// An element of an experiment file, read strictly: whoever reads it says what is allowed, and the rest is refused.
#pragma once

#include <tinyxml2.h>

#include <optional>
#include <string>
#include <vector>

#include "swarmanoid_interface/configuration.hpp"

namespace swarmanoid::experiment {

class XmlElement {
 public:
  XmlElement(const tinyxml2::XMLElement* element, const std::string* file) : element_(element), file_(file) {}

  std::string name() const { return element_->Name(); }
  /// Where it stands; for what an override has set, the override.
  SourceLocation location() const;
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

  [[noreturn]] void refuse(const std::string& message) const { throw ConfigError(location(), message); }

 private:
  const tinyxml2::XMLElement* element_;
  const std::string* file_;
};

/// "<name> ..., allowed: ...; did you mean ...?"
std::string unknownName(const std::string& what, const std::string& name, const std::vector<std::string>& allowed);

}  // namespace swarmanoid::experiment
