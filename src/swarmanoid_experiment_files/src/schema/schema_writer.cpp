#include "schema_writer.hpp"

#include <cmath>
#include <iomanip>

#include "swarmanoid_experiment_files/xml/xml_node.hpp"
#include "swarmanoid_interface/plain_text.hpp"

namespace swarmanoid::experiment {
namespace {

constexpr const char* kNumber = "[+\\-]?([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][+\\-]?[0-9]+)?";
constexpr const char* kComma = "\\s*,\\s*";

/// Returns the named type of a value; numbers with a range get a type of their own.
std::string typeOf(const Parameter& parameter) {
  switch (parameter.type) {
    case Parameter::Type::kNumber:
    case Parameter::Type::kAngle:
      return "number";
    case Parameter::Type::kInteger:
      return "integer";
    case Parameter::Type::kBoolean:
      return "boolean";
    case Parameter::Type::kVector2:
      return "two_numbers";
    case Parameter::Type::kVector3:
    case Parameter::Type::kAngles3:
      return "three_numbers";
    case Parameter::Type::kColor:
      return "color";
    case Parameter::Type::kChoice:
    case Parameter::Type::kText:
      return "xs:string";
  }
  return "xs:string";
}

std::string numberText(double value, bool is_whole) {
  PlainTextStream text;
  text << std::setprecision(is_whole ? 0 : 15);
  if (is_whole) {
    text << std::fixed;
  }
  text << value;
  return text.str();
}

std::string documentationOf(const Parameter& parameter) {
  return parameter.description + (parameter.unit.empty() ? "" : " [" + parameter.unit + "]") +
         (parameter.value && !parameter.value->empty() ? " Default: " + *parameter.value : "");
}

}  // namespace

SchemaWriter::SchemaWriter() : text_(xmlBufferCreate()), writer_(xmlNewTextWriterMemory(text_.get(), 0)) {
  if (writer_ == nullptr) {
    throw std::bad_alloc();
  }
  xmlTextWriterSetIndent(writer_.get(), 1);
  xmlTextWriterSetIndentString(writer_.get(), xmlCharacters("    "));
  xmlTextWriterStartDocument(writer_.get(), nullptr, "UTF-8", nullptr);
  open("schema", {{"xmlns:xs", "http://www.w3.org/2001/XMLSchema"}});
  const std::string number = kNumber;
  pattern("number", "xs:double", "\\s*" + number + "\\s*");
  pattern("integer", "xs:integer", "\\s*[+\\-]?[0-9]+\\s*");
  pattern("boolean", "xs:token", "true|false");
  pattern("two_numbers", "xs:token", number + kComma + number);
  pattern("three_numbers", "xs:token", number + kComma + number + kComma + number);
  const std::string channel = "0*(25[0-5]|2[0-4][0-9]|1[0-9][0-9]|[0-9]?[0-9])";
  std::string color = channel + kComma + channel + kComma + channel;
  for (const std::string& name : colorNames()) {
    color += "|" + name;
  }
  pattern("color", "xs:token", color);
  pattern("name", "xs:token", "[A-Za-z][A-Za-z0-9_]*");
  pattern("text", "xs:token", ".+");
}

void SchemaWriter::open(const std::string& tag, const Attributes& attributes) {
  xmlTextWriterStartElement(writer_.get(), xmlCharacters(("xs:" + tag).c_str()));
  for (const auto& [name, value] : attributes) {
    xmlTextWriterWriteAttribute(writer_.get(), xmlCharacters(name.c_str()), xmlCharacters(value.c_str()));
  }
}

void SchemaWriter::close() { xmlTextWriterEndElement(writer_.get()); }

void SchemaWriter::leaf(const std::string& tag, const Attributes& attributes) {
  open(tag, attributes);
  close();
}

void SchemaWriter::openElement(const std::string& name, bool required, const std::string& summary) {
  open("element", required ? Attributes{{"name", name}} : Attributes{{"name", name}, {"minOccurs", "0"}});
  documentation(summary);
  open("complexType");
}

void SchemaWriter::openRepeatedElement(const std::string& name) {
  open("element", {{"name", name}, {"minOccurs", "0"}, {"maxOccurs", "unbounded"}});
  open("complexType");
}

void SchemaWriter::closeElement() {
  close();
  close();
}

void SchemaWriter::parameter(const Parameter& parameter) {
  const bool is_whole = parameter.type == Parameter::Type::kInteger;
  const bool is_number = typeOf(parameter) == "number" || is_whole;
  const bool has_range = std::isfinite(parameter.range.minimum) || std::isfinite(parameter.range.maximum);
  Attributes attributes{{"name", parameter.name}};
  if (parameter.value) {
    attributes.emplace_back("minOccurs", "0");
  }
  const bool has_own_type = parameter.type == Parameter::Type::kChoice || (is_number && has_range);
  if (!has_own_type) {
    attributes.emplace_back("type", typeOf(parameter));
  }
  open("element", attributes);
  documentation(documentationOf(parameter));
  if (parameter.type == Parameter::Type::kChoice) {
    enumeration(parameter.choices);
  } else if (has_own_type) {
    restriction(typeOf(parameter), parameter.range, is_whole);
  }
  close();
}

void SchemaWriter::parameters(const std::vector<Parameter>& table) {
  for (const Parameter& entry : table) {
    parameter(entry);
  }
}

void SchemaWriter::choiceElement(const std::string& name, const std::vector<std::string>& choices) {
  open("element", {{"name", name}, {"minOccurs", "0"}});
  enumeration(choices);
  close();
}

void SchemaWriter::attribute(const ExperimentAttribute& attribute) {
  const Parameter& value = attribute.value;
  const bool is_whole = value.type == Parameter::Type::kInteger;
  Attributes written{{"name", value.name}, {"use", value.value ? "optional" : "required"}};
  if (value.type == Parameter::Type::kChoice) {
    open("attribute", written);
    enumeration(value.choices);
  } else if (value.type == Parameter::Type::kNumber || is_whole) {
    open("attribute", written);
    restriction(typeOf(value), value.range, is_whole);
  } else {
    const bool is_needed_text = value.type == Parameter::Type::kText && !value.value;
    written.emplace_back("type", attribute.is_id ? "name" : (is_needed_text ? "text" : typeOf(value)));
    open("attribute", written);
  }
  close();
}

void SchemaWriter::attributes(const std::vector<ExperimentAttribute>& table) {
  for (const ExperimentAttribute& entry : table) {
    attribute(entry);
  }
}

void SchemaWriter::tag(const ExperimentTag& tag) {
  openElement(tag.name, true, tag.summary);
  if (!tag.values.empty()) {
    open("all");
    parameters(tag.values);
    close();
  }
  attributes(tag.attributes);
  closeElement();
}

void SchemaWriter::identity(const std::string& kind, const std::string& name, const std::string& selector) {
  open(kind, {{"name", name}});
  leaf("selector", {{"xpath", selector}});
  leaf("field", {{"xpath", "@id"}});
  close();
}

void SchemaWriter::reference(const std::string& name, const std::string& key, const std::string& selector,
                             const std::string& field) {
  open("keyref", {{"name", name}, {"refer", key}});
  leaf("selector", {{"xpath", selector}});
  leaf("field", {{"xpath", field}});
  close();
}

void SchemaWriter::anyElements(const std::string& process_contents) {
  open("sequence");
  leaf("any", {{"processContents", process_contents}, {"minOccurs", "0"}, {"maxOccurs", "unbounded"}});
  close();
}

std::string SchemaWriter::text() {
  close();
  xmlTextWriterEndDocument(writer_.get());  // flushes the text
  return characters(xmlBufferContent(text_.get()));
}

void SchemaWriter::pattern(const std::string& name, const std::string& base, const std::string& pattern) {
  open("simpleType", {{"name", name}});
  open("restriction", {{"base", base}});
  leaf("pattern", {{"value", pattern}});
  close();
  close();
}

void SchemaWriter::documentation(const std::string& text) {
  if (!text.empty()) {
    open("annotation");
    open("documentation");
    xmlTextWriterWriteString(writer_.get(), xmlCharacters(text.c_str()));
    close();
    close();
  }
}

void SchemaWriter::restriction(const std::string& base, Range range, bool is_whole) {
  open("simpleType");
  open("restriction", {{"base", base}});
  if (std::isfinite(range.minimum)) {
    leaf("minInclusive", {{"value", numberText(range.minimum, is_whole)}});
  }
  if (std::isfinite(range.maximum)) {
    leaf("maxInclusive", {{"value", numberText(range.maximum, is_whole)}});
  }
  close();
  close();
}

void SchemaWriter::enumeration(const std::vector<std::string>& choices) {
  open("simpleType");
  open("restriction", {{"base", "xs:token"}});
  for (const std::string& choice : choices) {
    leaf("enumeration", {{"value", choice}});
  }
  close();
  close();
}

}  // namespace swarmanoid::experiment
