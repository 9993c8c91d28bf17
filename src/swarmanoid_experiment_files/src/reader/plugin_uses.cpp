// <engines>, <rules>, <visualisations>: sections that list plugins by their ids; and the Python files of plugins.
#include <algorithm>
#include <filesystem>

#include "reader.hpp"
#include "swarmanoid_interface/plugin_library.hpp"

namespace swarmanoid::experiment {

std::string readScript(const XmlElement& element, Reader& reader) {
  const bool is_python = readChoice(element, "source", codeLanguages(), codeLanguages().front()) == "python";
  const auto file = element.attribute("file");
  if (!is_python) {
    if (file) {
      throw ConfigError(element.attributeLocation("file"),
                        "file: found '" + *file + "', allowed: with source=\"python\"");
    }
    return "";
  }
  if (element.attribute("library")) {
    throw ConfigError(element.attributeLocation("library"),
                      "library: found beside source=\"python\", allowed: file, the name of a file in Python");
  }
  const SourceLocation location = element.attributeLocation("file");
  const std::string name = element.requireAttribute("file");
  if (!areLibrariesByPathAllowed()) {
    throw ConfigError(location, "file: found '" + name +
                                    "', allowed, as other computers reach the master: no code in files; or "
                                    "allow_remote_libraries:=true at start");
  }
  std::string script = takeFile(name, reader);
  std::error_code ignored;
  if (std::filesystem::path(script).extension() != ".py" || !std::filesystem::is_regular_file(script, ignored)) {
    throw ConfigError(location, "file: found '" + name + "', allowed: a file that is there and ends in .py");
  }
  if (!reader.loads_libraries) {
    reader.unloaded.insert(name);
  }
  return script;
}

Configuration readFreeParameters(const XmlElement& element, const std::vector<std::string>& others) {
  element.refuseText();
  element.refuseDoubles();
  const Configuration all = element.toConfiguration();
  Configuration parameters(element.name(), "", element.location());
  for (const Configuration& value : all.children()) {
    const bool is_other = std::find(others.begin(), others.end(), value.name()) != others.end();
    if (!is_other || !element.attribute(value.name().c_str())) {
      parameters.add(value);
    }
  }
  return parameters;
}

std::vector<PluginUse> readPluginUses(const XmlElement& section, PluginKind kind, Reader& reader) {
  const std::string path = pathOf(kind);
  section.allowAttributes({});
  section.refuseText();
  std::vector<PluginUse> uses;
  for (const XmlElement& element : section.children()) {
    element.allowAttributes(attributesOf(path));
    PluginUse use;
    use.location = element.location();
    use.id = element.requireAttribute("id");
    use.library = reader.libraryOf(kind, element);
    use.script = kind == PluginKind::kRule ? readScript(element, reader) : "";
    reader.takeId(toString(kind), use.id, element);
    if (use.script.empty()) {
      const Registry::Entry& entry = reader.requirePlugin(kind, element, use.library);
      use.label = entry.description.label;
      use.parameters = readPluginParameters(element, entry.description);
    } else {
      use.label = element.name();
      use.parameters = readFreeParameters(element, attributesOf(path));
    }
    uses.push_back(std::move(use));
  }
  return uses;
}

}  // namespace swarmanoid::experiment
