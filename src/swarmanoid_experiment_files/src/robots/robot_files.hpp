/// Finds the robots and the device presets of this installation. Packages declare them in their package.xml:
///
///     <export><swarmanoid robots="${prefix}/urdf" realism="${prefix}/realism"/></export>
///
/// with one or both attributes. Each <type>.urdf in the first folder is a robot type, each .xml in the second has
/// presets (reader/realism_presets.hpp). Packages are searched in share/ of every prefix, and in the source
/// folders of prefixes that are devel spaces. A package with several copies is taken from the first prefix whose
/// package.xml has the element.
#pragma once

#include <string>
#include <vector>

namespace swarmanoid {

struct RobotFile {
  std::string type;
  std::string file;
  std::string package;
};

struct RobotFiles {
  std::vector<RobotFile> robots;      ///< sorted by type; a type may be there twice, which the caller must refuse
  std::vector<std::string> presets;   ///< files with presets of devices, sorted by name, then by folder
  std::vector<std::string> problems;  ///< packages without the declared folders: "package.xml:12: found ..."
};

/// Result of a search that runs once per process. Thread-safe.
const RobotFiles& robotFiles();

/// @param share_folders share/ of the prefixes, in descending priority
RobotFiles findRobotFiles(const std::vector<std::string>& share_folders);

}  // namespace swarmanoid
