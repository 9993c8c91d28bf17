/// Readers of the sections, one file each, and their shared state.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "parameter_table.hpp"
#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_experiment_files/xml/xml_element.hpp"
#include "swarmanoid_space/experiment/experiment.hpp"
#include "tags.hpp"

namespace swarmanoid::experiment {

/// Locations of the ids in use, by kind and id.
using TakenIds = std::map<std::string, SourceLocation>;

/// Registers an id. @throws ConfigError if it is not a valid name, or is in use within its kind ("controller",
/// "entity", "engine", ...)
void takeId(const std::string& kind, const std::string& id, const XmlElement& element, TakenIds& taken);

/// The experiment under construction, and the names in use.
struct Reader {
  Experiment experiment;
  TakenIds ids;  ///< of controllers, entities, patches, engines, handovers, rules, visualisations
  /// Ids prefix_1 to prefix_count, used by the entities of a distribution.
  struct Group {
    std::size_t count = 0;
    SourceLocation location;
  };
  std::map<std::string, Group> groups;  ///< by prefix
  std::vector<std::string> warnings;
  bool loads_libraries = true;
  std::set<std::string> unloaded;       ///< libraries that the file names, if the reader does not load them
  std::deque<Registry::Entry> unknown;  ///< placeholders for the plugins of these libraries
  /// Libraries by the visualisation labels that they declare. Filled on first use, because it needs files.
  std::optional<std::multimap<std::string, std::string>> declared_visualisations;

  /// As experiment::takeId. The id of an entity must not be one of the numbered ids either.
  void takeId(const std::string& kind, const std::string& id, const XmlElement& element);
  /// Registers the entity ids prefix_1, prefix_2, ..., for any count.
  void takeNumberedIds(const std::string& prefix, std::size_t count, const XmlElement& element);

  /// Returns the distribution that contains an entity with this id; null if none has been read so far.
  const Group* groupOf(const std::string& id) const;

  /// Loads the library, or only notes it if libraries are not loaded. @throws ConfigError
  void needLibrary(const std::string& library, const SourceLocation& location);

  /// Returns a placeholder for a plugin of a library that is not loaded; it accepts any content.
  const Registry::Entry& standIn(PluginKind kind, const std::string& label);

  /// Libraries by the labels that they declare.
  const std::multimap<std::string, std::string>& declaredLabels(PluginKind kind);
  /// Returns the library that the element names or, if it names none, the one that declares its label; "" if the plugin
  /// is in a library that is always loaded. @throws ConfigError if several libraries declare the label
  std::string libraryOf(PluginKind kind, const XmlElement& element);

  /// Returns the registry's entry for a tag; loads `library` first if it is not empty.
  /// @throws ConfigError that lists the known plugins
  const Registry::Entry& requirePlugin(PluginKind kind, const XmlElement& element, const std::string& library);
};

/// A list of known names with fast look-up.
struct KnownNames {
  std::vector<std::string> all;
  std::set<std::string> lookup;

  void add(const std::string& name) {
    all.push_back(name);
    lookup.insert(name);
  }
  bool has(const std::string& name) const { return lookup.count(name) != 0; }
};

/// Refuses a label that two libraries define, because the result would depend on the order of loading.
/// @param library requested by the element; "": any
/// @throws ConfigError if the plugin in use comes from another library, which was loaded first
void refuseSecondLibrary(const Registry::Entry& entry, const XmlElement& element, const std::string& library);

/// Returns the Python file of a controller or a rule, and adds it to the experiment's files; "" for C++.
/// @throws ConfigError
std::string readScript(const XmlElement& element, Reader& reader);

void readFramework(const XmlElement& section, Reader& reader);
void readControllers(const XmlElement& section, Reader& reader);
/// Reads all <error> of a sensor or an actuator. @param device its type; "" if it is not known
std::vector<ErrorModelDescription> readErrors(const XmlElement& element, const std::string& device);
void readArena(const XmlElement& section, Reader& reader);
/// <distribute> in <arena>.
void readDistribute(const XmlElement& element, Reader& reader);
/// Returns the entity tags that an element may contain. Tags that name a library are known only after it is loaded.
std::vector<std::string> entityTagsIn(const XmlElement& parent);
/// Reads an entity in <distribute>, which has no position.
EntityDescription readDistributedEntity(const XmlElement& element, Reader& reader);
/// Reads an entity for a run in progress, in the form that it has in <arena>. Instead of <orientation> in degrees it
/// may have <angles>, the exact value in radians. The function does not check whether the id is in use.
/// @param experiment provides the arena and the controllers
EntityDescription readSpawnedEntity(const XmlElement& element, const Experiment& experiment);
/// <heightfield> in <arena>, at most one.
void readHeightfield(const XmlElement& element, Reader& reader);
void readFloorPatch(const XmlElement& element, Reader& reader);
void readHole(const XmlElement& element, Reader& reader);
/// <floor_image> in <arena>, at most one.
void readFloorImage(const XmlElement& element, Reader& reader);
/// <floor_paint> in <arena>, at most one.
void readFloorPaint(const XmlElement& element, Reader& reader);
/// Adds a file that the experiment names to Experiment::files. @return its path; a relative name starts in the folder
/// of the experiment file
std::string takeFile(const std::string& name, Reader& reader);
void readEngines(const XmlElement& section, Reader& reader);
void readArenaPhysics(const XmlElement& section, Reader& reader);
/// @param entities, engines known ids
void readHandover(const XmlElement& element, const KnownNames& entities, const KnownNames& engines, Reader& reader);
/// Warns of each robot whose actuators no engine executes. It is called after all sections are read.
void warnOfUnmovedRobots(Reader& reader);
/// Reads all plugins that <engines>, <rules> or <visualisations> lists.
std::vector<PluginUse> readPluginUses(const XmlElement& section, PluginKind kind, Reader& reader);

/// Reads all sections. @pre the reader's experiment has its name, file and text
void readDocument(const XmlElement& root, Reader& reader);

/// Reads the parameters of a plugin; accepts any content if its library is not loaded.
/// @param others child elements that are not parameters
Configuration readPluginParameters(const XmlElement& element, const PluginDescription& plugin,
                                   const std::vector<std::string>& others = {});

/// Reads all elements and attributes of an element, for code that checks them itself. Content that such code would
/// ignore silently is refused. @param others attributes that are not parameters @throws ConfigError
Configuration readFreeParameters(const XmlElement& element, const std::vector<std::string>& others = {});

/// Sets values in the document before it is read.
/// @return marks that the document's elements point to; they must live until the document is read
/// @throws ConfigError for a path that leads nowhere, or to more than one place
std::deque<OverrideMarks> applyOverrides(xmlDoc& document, const std::vector<Override>& overrides);

}  // namespace swarmanoid::experiment
