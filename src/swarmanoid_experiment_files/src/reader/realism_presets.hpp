/// Reads files of presets:
///
///     <realism sensor="eyebot_pressure">                          or actuator="..."
///       <preset name="typical" source="Bosch Sensortec BMP085">   one or more
///         <implementation>...</implementation>                    as in the device in an experiment file:
///         <range>...</range>                                      an implementation, its values,
///         <error kind="gaussian" deviation="5"/>                  and errors
///       </preset>
///     </realism>
#pragma once

#include <deque>
#include <functional>
#include <string>
#include <vector>

#include "swarmanoid_experiment_files/realism.hpp"
#include "swarmanoid_experiment_files/xml/xml_element.hpp"

namespace swarmanoid::experiment {

/// Presets of files, as XML trees. Immutable after reading, so any thread may use it.
class PresetLibrary {
 public:
  struct Preset {
    RealismPreset about;
    xmlNode* element = nullptr;  ///< <preset>, in a document of the library
  };

  PresetLibrary() = default;
  /// @param files each with one <realism> @throws ConfigError for the first mistake, such as two presets of one name
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

/// Presets of this installation, read once per process. @throws ConfigError, on every call, if one of the files has a
/// mistake
const PresetLibrary& installedPresets();

/// Returns the presets on demand, so that their files are read only if they are needed.
using PresetSource = std::function<const PresetLibrary&()>;

/// Inserts presets into the document: each device gets the values of its preset that the document does not set. The
/// first `<realism>` found in the device, its controller or <framework> names the preset.
/// @param marks get the origin files of the inserted elements, which point to them
/// @throws ConfigError for a name that no preset has
void applyRealism(xmlDoc& document, const std::string& file, const PresetSource& presets,
                  std::deque<OverrideMarks>& marks);

/// Sets all <realism> to ideal, with a comment: for a document with inserted presets, so that they are not inserted
/// again.
void removeRealism(xmlDoc& document);

}  // namespace swarmanoid::experiment
