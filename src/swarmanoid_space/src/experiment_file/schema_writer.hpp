/// The bricks of an XML schema (XSD 1.0): elements, attributes and types, written from tables of parameters.
#pragma once

#include <libxml/xmlwriter.h>

#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "swarmanoid_interface/registry.hpp"
#include "swarmanoid_space/experiment_file/experiment_schema.hpp"
#include "swarmanoid_space/experiment_file/experiment_tags.hpp"

namespace swarmanoid::experiment {

class SchemaWriter {
 public:
  using Attributes = std::vector<std::pair<std::string, std::string>>;

  /// Starts the schema, with the types that parameters need.
  SchemaWriter();

  /// <xs:tag ...>; the prefix is added.
  void open(const std::string& tag, const Attributes& attributes = {});
  void close();
  void leaf(const std::string& tag, const Attributes& attributes);

  /// <xs:element name=...><xs:complexType>, to be closed with closeElement.
  void openElement(const std::string& name, bool required, const std::string& summary = "");
  /// The same for as many as one likes.
  void openRepeatedElement(const std::string& name);
  void closeElement();

  /// An element that holds one value.
  void parameter(const Parameter& parameter);
  /// The values in any order, each once; in the <xs:all> that the caller opens.
  void parameters(const std::vector<Parameter>& table);
  /// An element with one of the texts.
  void choiceElement(const std::string& name, const std::vector<std::string>& choices);

  void attributes(const std::vector<ExperimentAttribute>& table);
  /// A tag with its values and attributes, where nothing else stands in it.
  void tag(const ExperimentTag& tag);
  /// No two elements of `selector` have the same id. `kind`: unique or key; key also asks for the id.
  void identity(const std::string& kind, const std::string& name, const std::string& selector);
  /// `field` of every element of `selector`, such as "@entity", is the id of an element of the key.
  void reference(const std::string& name, const std::string& key, const std::string& selector,
                 const std::string& field);
  /// Any elements: checked if the schema knows their tags, else let through.
  void anyElements(const std::string& process_contents);

  /// The finished schema.
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
  std::unique_ptr<xmlTextWriter, Deleter> writer_;  ///< into the text
};

/// The tags that mean a plugin: its label and the aliases. A name that XML does not allow is none of them.
std::vector<std::string> tagsOf(const PluginDescription& plugin);

/// The attributes of a plugin's tag. @param libraries one of which an experiment file must name; none: it need not
std::vector<ExperimentAttribute> attributesWithLibrary(const std::string& path, const std::set<std::string>& libraries);

/// Declares the plugins of the registry, and what stands in any controller, at the top of the schema. A tag that means
/// plugins of several kinds is not declared, so whatever stands in it is let through.
void writePlugins(const PluginLibraries& libraries, SchemaWriter& out);

}  // namespace swarmanoid::experiment
