#include "swarmanoid_experiment_files/recorded_text.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <new>

#include "reader.hpp"
#include "realism_presets.hpp"
#include "swarmanoid_interface/expects.hpp"

namespace swarmanoid::experiment {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFile = "file";  // name of parameters that name a file

struct XmlBytesDeleter {
  void operator()(xmlChar* bytes) const { xmlFree(bytes); }
};

std::string toText(xmlDoc& document) {
  xmlChar* bytes = nullptr;
  int size = 0;
  xmlDocDumpFormatMemoryEnc(&document, &bytes, &size, "UTF-8", 1);
  const std::unique_ptr<xmlChar, XmlBytesDeleter> owner(bytes);
  if (bytes == nullptr) {
    throw std::bad_alloc();
  }
  return {characters(bytes), static_cast<std::size_t>(size)};
}

/// Returns the replacement of a value; the value itself if it stays.
using Exchange = std::function<std::string(const std::string& name, const std::string& value)>;

/// Replaces the values of attributes, and the texts of elements without child elements.
void exchangeValues(xmlNode& element, const Exchange& exchange) {
  for (xmlAttr* attribute = element.properties; attribute != nullptr; attribute = attribute->next) {
    const std::string name = characters(attribute->name);
    const std::string value = textIn(attribute->children);
    const std::string other = exchange(name, value);
    if (other != value) {
      xmlSetProp(&element, attribute->name, xmlCharacters(other.c_str()));
    }
  }
  const std::vector<xmlNode*> children = elementsOf(element);
  for (xmlNode* child : children) {
    exchangeValues(*child, exchange);
  }
  const std::string text = children.empty() ? textIn(element.children) : "";
  if (const std::string other = exchange(nameOf(element), text); other != text) {
    xmlNodeSetContent(&element, nullptr);
    xmlNodeAddContent(&element, xmlCharacters(other.c_str()));
  }
}

/// Returns the overrides of the experiment, and one that makes the folders of libraries independent of the current
/// folder.
std::vector<Override> overridesOf(const Experiment& experiment) {
  std::vector<Override> overrides = experiment.overrides;
  std::string folders;
  for (const std::string& folder : experiment.framework.controller_path) {
    folders += (folders.empty() ? "" : ":") + fs::absolute(folder).lexically_normal().string();
  }
  if (!folders.empty()) {
    overrides.push_back({"framework.controller_path", folders});
  }
  return overrides;
}

/// Returns whether the name is that of an existing file; the loader treats a name with a slash or this ending as a
/// file.
bool isFileOfLibrary(const std::string& library) {
  std::error_code ignored;
  const bool is_file = library.find('/') != std::string::npos || fs::path(library).extension() == ".so";
  return is_file && fs::exists(library, ignored);
}

}  // namespace

std::string recordedText(const Experiment& experiment, const std::vector<std::string>& new_names) {
  SWARMANOID_EXPECTS(new_names.size() + 1 == experiment.files.size());
  const XmlDocument document = parseXml(experiment.text, experiment.file, XmlNamespaces::kRefused);
  auto marks = applyOverrides(*document, overridesOf(experiment));
  applyRealism(*document, experiment.file, installedPresets, marks);
  removeRealism(*document);
  const fs::path folder = fs::path(experiment.file).parent_path();
  std::vector<bool> is_named(new_names.size(), false);
  const Exchange exchange = [&](const std::string& name, const std::string& value) {
    const std::string file = trimmed(value);
    std::string new_name;
    for (std::size_t i = 0; name == kFile && i < new_names.size(); ++i) {
      if (!file.empty() && (folder / file).string() == experiment.files[i + 1]) {
        is_named[i] = true;  // a file that is named twice is in the list twice
        new_name = new_names[i];
      }
    }
    if (!new_name.empty()) {
      return new_name;
    }
    if (name == "library" && isFileOfLibrary(file)) {
      return fs::absolute(file).lexically_normal().string();
    }
    return value;
  };
  exchangeValues(*xmlDocGetRootElement(document.get()), exchange);
  for (std::size_t i = 0; i < new_names.size(); ++i) {
    if (!is_named[i]) {
      throw ConfigError({experiment.file, 0}, "found no place that names '" + experiment.files[i + 1] +
                                                  "', which the experiment was read from, allowed in a record: files "
                                                  "that the text names");
    }
  }
  return toText(*document);
}

}  // namespace swarmanoid::experiment
