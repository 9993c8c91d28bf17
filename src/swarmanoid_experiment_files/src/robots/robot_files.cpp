#include "robot_files.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>
#include <tuple>

#include "swarmanoid_experiment_files/xml/xml_document.hpp"
#include "swarmanoid_experiment_files/xml/xml_node.hpp"
#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "swarmanoid_interface/read_file.hpp"
#include "swarmanoid_space/models/limits.hpp"

namespace swarmanoid {
namespace {

namespace fs = std::filesystem;

constexpr const char* kManifest = "package.xml";

/// Finds the packages below a folder as catkin does: folders inside a package are not searched.
void findPackages(const fs::path& folder, std::vector<fs::path>& packages) {
  std::error_code ignored;
  if (fs::exists(folder / "CATKIN_IGNORE", ignored)) {
    return;
  }
  if (fs::exists(folder / kManifest, ignored)) {
    packages.push_back(folder);
    return;
  }
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    if (entry.is_directory(ignored) && !entry.is_symlink(ignored) && entry.path().filename().string()[0] != '.') {
      findPackages(entry.path(), packages);
    }
  }
}

/// Returns the source folders of a devel space, which it lists in a file; none for an install space.
std::vector<fs::path> sourceFolders(const fs::path& prefix) {
  std::vector<fs::path> folders;
  std::ifstream file(prefix / ".catkin");
  for (std::string folder; std::getline(file, folder, ';');) {
    folder.erase(folder.find_last_not_of("\r\n") + 1);
    folders.emplace_back(folder);
  }
  return folders;
}

std::vector<fs::path> packagesOf(const fs::path& share) {
  std::vector<fs::path> packages;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(share, ignored)) {
    if (fs::exists(entry.path() / kManifest, ignored)) {
      packages.push_back(entry.path());
    }
  }
  for (const fs::path& folder : sourceFolders(share.parent_path())) {
    if (!folder.empty()) {
      findPackages(folder, packages);
    }
  }
  std::sort(packages.begin(), packages.end());
  return packages;
}

class Search {
 public:
  void look(const fs::path& package) {
    const std::string file = (package / kManifest).string();
    try {
      const std::string text = readFile(file, limits::kLongestText);
      if (text.find("<swarmanoid") != std::string::npos) {  // few of the hundreds of packages need parsing
        readManifest(package, file, text);
      }
    } catch (const ConfigError& error) {
      found_.problems.emplace_back(error.what());
    }
  }

  RobotFiles take() {
    std::sort(found_.robots.begin(), found_.robots.end(), [](const RobotFile& a, const RobotFile& b) {
      return std::tie(a.type, a.file) < std::tie(b.type, b.file);
    });
    std::sort(found_.presets.begin(), found_.presets.end(), [](const std::string& a, const std::string& b) {
      return std::make_pair(fs::path(a).filename(), a) < std::make_pair(fs::path(b).filename(), b);
    });
    return std::move(found_);
  }

 private:
  void readManifest(const fs::path& package, const std::string& file, const std::string& text) {
    const XmlDocument document = parseXml(text, file, XmlNamespaces::kAllowed);
    const xmlNode& root = *xmlDocGetRootElement(document.get());
    const xmlNode* name = childOf(root, "name");
    const xmlNode* exported = childOf(root, "export");
    const xmlNode* element = exported == nullptr ? nullptr : childOf(*exported, "swarmanoid");
    if (name == nullptr || element == nullptr || !packages_.insert(textIn(name->children)).second) {
      return;
    }
    const std::vector<fs::path> robots = filesIn("robots", ".urdf", package, file, *element);
    const std::vector<fs::path> presets = filesIn("realism", ".xml", package, file, *element);
    if (!attributeOf(*element, "robots") && !attributeOf(*element, "realism")) {
      throw ConfigError({file, lineOf(element)},
                        "<swarmanoid> needs the attribute robots=\"${prefix}/...\" or realism=\"${prefix}/...\"");
    }
    for (const fs::path& robot : robots) {
      found_.robots.push_back({robot.stem().string(), robot.string(), textIn(name->children)});
    }
    for (const fs::path& preset : presets) {
      found_.presets.push_back(preset.string());
    }
  }

  /// Returns the files with an extension in the folder that an attribute names; none without the attribute.
  static std::vector<fs::path> filesIn(const char* attribute, const char* ending, const fs::path& package,
                                       const std::string& manifest, const xmlNode& element) {
    std::vector<fs::path> files;
    const std::optional<std::string> value = attributeOf(element, attribute);
    if (!value) {
      return files;
    }
    std::string folder = *value;
    const std::string prefix = "${prefix}";
    if (const auto place = folder.find(prefix); place != std::string::npos) {
      folder.replace(place, prefix.size(), package.string());
    }
    std::error_code ignored;
    if (!fs::is_directory(folder, ignored)) {
      throw ConfigError({manifest, lineOf(&element)}, std::string(attribute) + ": found '" + *value +
                                                          "', allowed: a folder, such as ${prefix}/" +
                                                          (ending == std::string(".urdf") ? "urdf" : "realism"));
    }
    for (const auto& entry : fs::directory_iterator(folder, ignored)) {
      if (entry.path().extension() == ending) {
        files.push_back(entry.path());
      }
    }
    return files;
  }

  std::set<std::string> packages_;  // names
  RobotFiles found_;
};

}  // namespace

RobotFiles findRobotFiles(const std::vector<std::string>& share_folders) {
  Search search;
  std::set<fs::path> known;
  for (const std::string& share : share_folders) {
    if (known.insert(fs::path(share)).second) {
      for (const fs::path& package : packagesOf(share)) {
        search.look(package);
      }
    }
  }
  return search.take();
}

const RobotFiles& robotFiles() {
  static const RobotFiles files = findRobotFiles(shareFolders());
  return files;
}

}  // namespace swarmanoid
