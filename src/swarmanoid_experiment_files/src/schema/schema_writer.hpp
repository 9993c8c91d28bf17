/// Writes the parts of an XML schema (XSD 1.0): elements, attributes and types, from tables of parameters.
#pragma once

#include <libxml/xmlwriter.h>

#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "swarmanoid_experiment_files/experiment_schema.hpp"
#include "swarmanoid_experiment_files/experiment_tags.hpp"
#include "swarmanoid_interface/registry.hpp"

namespace swarmanoid::experiment {

class SchemaWriter {
 public:
  using Attributes = std::vector<std::pair<std::string, std::string>>;

  /// Starts the schema, with the types of parameters.
  SchemaWriter();

  /// <xs:tag ...>; the prefix is added.
  void open(const std::string& tag, const Attributes& attributes = {});
  void close();
  void leaf(const std::string& tag, const Attributes& attributes);

  /// <xs:element name=...><xs:complexType>, to be closed with closeElement.
  void openElement(const std::string& name, bool required, const std::string& summary = "");
  /// As openElement, for an element that may occur any number of times.
  void openRepeatedElement(const std::string& name);
  void closeElement();

  /// Writes an element with one value.
  void parameter(const Parameter& parameter);
  /// Writes the values of a table, for any order, each at most once; the caller opens <xs:all>.
  void parameters(const std::vector<Parameter>& table);
  /// Writes an element whose value is one of the choices.
  void choiceElement(const std::string& name, const std::vector<std::string>& choices);

  void attributes(const std::vector<ExperimentAttribute>& table);
  /// Writes a tag with its values and attributes and no other children.
  void tag(const ExperimentTag& tag);
  /// Requires that no two elements of `selector` have the same id. `kind`: unique or key; key also requires the id.
  void identity(const std::string& kind, const std::string& name, const std::string& selector);
  /// Requires that `field` of every element of `selector`, such as "@entity", is the id of an element of the key.
  void reference(const std::string& name, const std::string& key, const std::string& selector,
                 const std::string& field);
  /// Allows any elements. They are checked if the schema knows their tags.
  void anyElements(const std::string& process_contents);

  /// Returns the finished schema.
  std::string text();

 private:
  void pattern(const std::string& name, const std::string& base, const std::string& pattern);
  void documentation(const std::string& text);
  void attribute(const ExperimentAttribute& attribute);
  void restriction(const std::string& base, Range range, bool is_whole);
  void enumeration(const std::vector<std::string>& choices);

  struct Deleter {
    void operator()(xmlBuffer* buffer) const { xmlBufferFree(buffer); }
    void operator()(xmlTextWriter* writer) const { xmlFreeTextWriter(writer); }
  };

  std::unique_ptr<xmlBuffer, Deleter> text_;
  std::unique_ptr<xmlTextWriter, Deleter> writer_;  ///< writes to text_
};

/// Returns the tags of a plugin: its label and aliases, except names that XML does not allow.
std::vector<std::string> tagsOf(const PluginDescription& plugin);

/// Returns the attributes of a plugin's tag. @param libraries an experiment file must name one of them; empty: it need
/// not name any
std::vector<ExperimentAttribute> attributesWithLibrary(const std::string& path, const std::set<std::string>& libraries);

/// Declares the plugins of the registry, and the common children of controllers, at the top level of the schema. A tag
/// of plugins of several kinds is not declared, so its content is not checked.
void writePlugins(const PluginLibraries& libraries, SchemaWriter& out);

}  // namespace swarmanoid::experiment
