// The XML schema of experiment files, made from the tables that the readers use.
#include <sstream>

#include "parameter_table.hpp"
#include "swarmanoid_space/entity_type.hpp"
#include "swarmanoid_space/experiment.hpp"

namespace swarmanoid {
namespace experiment {
namespace {

constexpr const char* kNumberPattern = "[+\\-]?([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][+\\-]?[0-9]+)?";

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    result += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : c == '"' ? "&quot;" : std::string(1, c);
  }
  return result;
}

class SchemaWriter {
 public:
  std::string write() {
    out_ << "<?xml version=\"1.0\"?>\n<xs:schema xmlns:xs=\"http://www.w3.org/2001/XMLSchema\">\n";
    writeSimpleTypes();
    writeRoot();
    writePlugins();
    out_ << "</xs:schema>\n";
    return out_.str();
  }

 private:
  void writePattern(const std::string& name, const std::string& pattern) {
    out_ << "  <xs:simpleType name=\"" << name << "\"><xs:restriction base=\"xs:token\"><xs:pattern value=\"" << pattern
         << "\"/></xs:restriction></xs:simpleType>\n";
  }

  void writeSimpleTypes() {
    const std::string number = kNumberPattern;
    const std::string comma = "\\s*,\\s*";
    writePattern("number", number);
    writePattern("integer", "[+\\-]?[0-9]+");
    writePattern("boolean", "true|false");
    writePattern("three_numbers", number + comma + number + comma + number);
    std::string color = "[0-9]+" + comma + "[0-9]+" + comma + "[0-9]+";
    for (const std::string& name : colorNames()) {
      color += "|" + name;
    }
    writePattern("color", color);
    writePattern("name", "[A-Za-z][A-Za-z0-9_]*");
  }

  static std::string typeOf(const Parameter& parameter) {
    switch (parameter.type) {
      case Parameter::Type::kNumber:
      case Parameter::Type::kAngle:
        return "number";
      case Parameter::Type::kInteger:
        return "integer";
      case Parameter::Type::kBoolean:
        return "boolean";
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

  void writeParameter(const Parameter& parameter) {
    const bool is_choice = parameter.type == Parameter::Type::kChoice;
    out_ << "<xs:element name=\"" << parameter.name << "\"" << (parameter.value ? " minOccurs=\"0\"" : "")
         << (is_choice ? "" : " type=\"" + typeOf(parameter) + "\"") << "><xs:annotation><xs:documentation>"
         << escaped(parameter.description) << (parameter.unit.empty() ? "" : " [" + parameter.unit + "]")
         << "</xs:documentation></xs:annotation>";
    if (is_choice) {
      out_ << "<xs:simpleType><xs:restriction base=\"xs:token\">";
      for (const std::string& choice : parameter.choices) {
        out_ << "<xs:enumeration value=\"" << choice << "\"/>";
      }
      out_ << "</xs:restriction></xs:simpleType>";
    }
    out_ << "</xs:element>\n";
  }

  void writeAttribute(const std::string& name, bool required, const std::string& type = "xs:string") {
    out_ << "<xs:attribute name=\"" << name << "\" type=\"" << type << "\"" << (required ? " use=\"required\"" : "")
         << "/>\n";
  }

  void writeAll(const std::vector<Parameter>& table) {
    out_ << "<xs:all>\n";
    for (const Parameter& parameter : table) {
      writeParameter(parameter);
    }
    out_ << "</xs:all>\n";
  }

  /// Plugins that are not known here (built by users) are let through unchecked.
  void writeOpenSection(const std::string& name) {
    out_ << "<xs:element name=\"" << name
         << "\" minOccurs=\"0\"><xs:complexType><xs:sequence><xs:any processContents=\"lax\" minOccurs=\"0\" "
            "maxOccurs=\"unbounded\"/></xs:sequence></xs:complexType></xs:element>\n";
  }

  void writeRoot() {
    out_ << "<xs:element name=\"ahss-config\"><xs:complexType><xs:all>\n";
    out_ << "<xs:element name=\"framework\"><xs:complexType>\n";
    writeAll(frameworkParameters());
    out_ << "</xs:complexType></xs:element>\n";
    writeOpenSection("controllers");
    writeArena();
    writeOpenSection("engines");
    out_ << "<xs:element name=\"arena_physics\" minOccurs=\"0\"><xs:complexType><xs:sequence><xs:element "
            "name=\"engine\" "
            "minOccurs=\"0\" maxOccurs=\"unbounded\"><xs:complexType><xs:sequence><xs:element name=\"entity\" "
            "minOccurs=\"0\" maxOccurs=\"unbounded\"><xs:complexType>\n";
    for (const std::string& name : memberAttributes()) {
      writeAttribute(name, name == "id");
    }
    out_ << "</xs:complexType></xs:element></xs:sequence>";
    writeAttribute("id", true, "name");
    out_ << "</xs:complexType></xs:element></xs:sequence></xs:complexType></xs:element>\n";
    writeOpenSection("visualisations");
    writeOpenSection("visualizations");
    out_ << "</xs:all></xs:complexType></xs:element>\n";
  }

  void writeArena() {
    out_ << "<xs:element name=\"arena\"><xs:complexType><xs:choice minOccurs=\"0\" maxOccurs=\"unbounded\">\n";
    for (const Registry::Entry* entry : Registry::instance().all(PluginKind::kEntity)) {
      writeEntity(*entry, false);
    }
    out_ << "<xs:element name=\"floor_patch\"><xs:complexType>\n";
    writeAll(floorPatchParameters());
    writeAttribute("id", true, "name");
    out_ << "</xs:complexType></xs:element>\n";
    out_ << "<xs:element name=\"distribute\"><xs:complexType><xs:choice minOccurs=\"0\" maxOccurs=\"unbounded\">\n";
    for (const Parameter& parameter : distributeParameters()) {
      writeParameter(parameter);
    }
    for (const Registry::Entry* entry : Registry::instance().all(PluginKind::kEntity)) {
      writeEntity(*entry, true);
    }
    out_ << "</xs:choice>\n";
    for (const std::string& name : distributeAttributes()) {
      writeAttribute(name, name == "quantity");
    }
    out_ << "</xs:complexType></xs:element>\n</xs:choice>\n";
    for (const std::string& name : arenaAttributes()) {
      writeAttribute(name, name != "bounded");
    }
    out_ << "</xs:complexType></xs:element>\n";
  }

  void writeEntity(const Registry::Entry& entry, bool is_distributed) {
    std::vector<Parameter> table = entry.description.parameters;
    for (Parameter placement : placementParameters()) {
      if (is_distributed) {
        placement.value = "0, 0, 0";
      }
      if (!is_distributed || placement.name != "position") {
        table.push_back(placement);
      }
    }
    if (makePlugin<EntityType>(entry)->isRobot()) {
      table.push_back(makeParameter("controller", Parameter::Type::kText, "", "", {}, "Id of its controller."));
    }
    out_ << "<xs:element name=\"" << entry.description.label << "\"><xs:complexType>\n";
    writeAll(table);
    writeAttribute("id", true, "name");
    out_ << "</xs:complexType></xs:element>\n";
  }

  void writePlugins() {
    for (const PluginKind kind : {PluginKind::kEngine, PluginKind::kVisualisation}) {
      for (const Registry::Entry* entry : Registry::instance().all(kind)) {
        std::vector<std::string> tags = entry->description.label_aliases;
        tags.push_back(entry->description.label);
        for (const std::string& tag : tags) {
          out_ << "<xs:element name=\"" << tag << "\"><xs:complexType>\n";
          writeAll(entry->description.parameters);
          for (const std::string& name : pluginAttributes()) {
            writeAttribute(name, name == "id");
          }
          out_ << "</xs:complexType></xs:element>\n";
        }
      }
    }
  }

  std::ostringstream out_;
};

}  // namespace
}  // namespace experiment

std::string experimentSchema() { return experiment::SchemaWriter().write(); }

}  // namespace swarmanoid
