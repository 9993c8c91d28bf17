/// Reads files of presets:
///
///     <realism sensor="eyebot_pressure">                          or actuator="..."
///       <preset name="typical" source="Bosch Sensortec BMP085">   one or more
///         <implementation>...</implementation>                    what an experiment file may say in the device:
///         <range>...</range>                                      an implementation, its values,
///         <error kind="gaussian" deviation="5"/>                  and errors
///       </preset>
///     </realism>
#pragma once

#include <deque>
#include <functional>
#include <string>
#include <vector>

#include "swarmanoid_space/experiment_file/realism.hpp"
#include "xml_element.hpp"

namespace swarmanoid::experiment {

/// Presets in files, as trees of XML. Immutable once read, so any thread may look in it.
class PresetLibrary {
 public:
  struct Preset {
    RealismPreset about;
    xmlNode* element = nullptr;  ///< <preset>, in a document of the library
  };

  PresetLibrary() = default;
  /// @param files each with one <realism> @throws ConfigError for the first mistake, such as a second preset of a name
  explicit PresetLibrary(const std::vector<std::string>& files);
  /// Reads one more file. @throws ConfigError
  void add(const std::string& file);

  /// @return null if the device has no preset of that name
  const Preset* find(PluginKind kind, const std::string& device, const std::string& name) const;
  /// In the order of the files.
  const std::vector<Preset>& all() const { return presets_; }

 private:
  std::vector<XmlDocument> documents_;
  std::vector<Preset> presets_;
};

/// Those of this installation, read once a process. @throws ConfigError, each time, if a file of them has a mistake
const PresetLibrary& installedPresets();

/// Gives the presets when they are asked for first, so that files of them are read only where they matter.
using PresetSource = std::function<const PresetLibrary&()>;

/// Puts presets into the document: each device gets what its preset has and the document does not say. `<realism>` of
/// the device, of its controller, of <framework>, the first that is there, names the preset.
/// @param marks get the files that elements are from; the elements point to them
/// @throws ConfigError for a name that no preset has
void applyRealism(xmlDoc& document, const std::string& file, const PresetSource& presets,
                  std::deque<OverrideMarks>& marks);

/// Sets all <realism> to ideal, with a comment: for a document whose presets have been put in, and must not be again.
void removeRealism(xmlDoc& document);

}  // namespace swarmanoid::experiment
