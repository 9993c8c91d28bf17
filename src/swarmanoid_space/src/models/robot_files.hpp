/// Finds the robots and the presets of devices of this installation: packages say in their package.xml where theirs
/// are,
///
///     <export><swarmanoid robots="${prefix}/urdf" realism="${prefix}/realism"/></export>
///
/// one of the two or both. Each <type>.urdf in the first folder is a robot type, each .xml in the second has presets
/// (experiment_file/realism_presets.hpp). Packages are searched in share/ of every prefix, and in the
/// source folders of those prefixes that are devel spaces. A package that is there more than once is taken from the
/// first prefix where its package.xml has that element.
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
  std::vector<RobotFile> robots;      ///< sorted by type; a type may be there twice, which is for the caller to refuse
  std::vector<std::string> presets;   ///< files with presets of devices, sorted by name, then by folder
  std::vector<std::string> problems;  ///< packages whose robots or presets cannot be found: "package.xml:12: found ..."
};

/// Searched once a process. Thread-safe.
const RobotFiles& robotFiles();

/// @param share_folders those of the prefixes, most important first
RobotFiles findRobotFiles(const std::vector<std::string>& share_folders);

}  // namespace swarmanoid
