/// What the readers of the sections share, and the readers themselves, one file each.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "parameter_table.hpp"
#include "swarmanoid_space/experiment_file/experiment.hpp"
#include "tags.hpp"
#include "xml_element.hpp"

namespace swarmanoid::experiment {

/// Ids that are taken, by kind and id, and where.
using TakenIds = std::map<std::string, SourceLocation>;

/// Takes an id. @throws ConfigError if it is no name, or is taken within its kind ("controller", "entity", "engine",
/// ...)
void takeId(const std::string& kind, const std::string& id, const XmlElement& element, TakenIds& taken);

/// The experiment under construction, and what its parts must not collide with.
struct Reader {
  Experiment experiment;
  TakenIds ids;  ///< of controllers, entities, patches, engines, handovers, rules, visualisations
  /// Ids prefix_1 to prefix_count, which are taken by entities of a distribution.
  struct Group {
    std::size_t count = 0;
    SourceLocation location;
  };
  std::map<std::string, Group> groups;  ///< by prefix
  std::vector<std::string> warnings;
  bool loads_libraries = true;
  std::set<std::string> unloaded;       ///< libraries that were named, if it does not load them
  std::deque<Registry::Entry> unknown;  ///< stand for what is in these
  /// Libraries by the labels of visualisations that they have declared, once these were asked for: files are read.
  std::optional<std::multimap<std::string, std::string>> declared_visualisations;

  /// As experiment::takeId; an entity's id may not be among the numbered ones either.
  void takeId(const std::string& kind, const std::string& id, const XmlElement& element);
  /// Likewise the entities' ids prefix_1, prefix_2, ..., however many.
  void takeNumberedIds(const std::string& prefix, std::size_t count, const XmlElement& element);

  /// The distribution among whose entities one of that id is; null if there is none so far.
  const Group* groupOf(const std::string& id) const;

  /// Loads the library, or notes it. @throws ConfigError
  void needLibrary(const std::string& library, const SourceLocation& location);

  /// For a plugin that is in a library which was not loaded: reads whatever stands there.
  const Registry::Entry& standIn(PluginKind kind, const std::string& label);

  /// Libraries by the labels that they have declared.
  const std::multimap<std::string, std::string>& declaredLabels(PluginKind kind);
  /// The library that an element of a plugin names, or that has declared its label for elements that name none; "": one
  /// that is loaded anyway. @throws ConfigError if several have declared it
  std::string libraryOf(PluginKind kind, const XmlElement& element);

  /// The registry's entry for a tag; loads `library` first if it is not empty.
  /// @throws ConfigError naming what there is
  const Registry::Entry& requirePlugin(PluginKind kind, const XmlElement& element, const std::string& library);
};

/// Names that there are, found fast however many they are.
struct KnownNames {
  std::vector<std::string> all;
  std::set<std::string> lookup;

  void add(const std::string& name) {
    all.push_back(name);
    lookup.insert(name);
  }
  bool has(const std::string& name) const { return lookup.count(name) != 0; }
};

/// Which of two libraries with one label is meant must not depend on which was loaded first.
/// @param library that the element asks for; "": any
/// @throws ConfigError if it is not the one that has the plugin, for another with that label was first
void refuseSecondLibrary(const Registry::Entry& entry, const XmlElement& element, const std::string& library);

/// Of a controller or a rule: the file in Python that has it, from now on one of the experiment's files; "": it is in
/// C++. @throws ConfigError
std::string readScript(const XmlElement& element, Reader& reader);

void readFramework(const XmlElement& section, Reader& reader);
void readControllers(const XmlElement& section, Reader& reader);
/// All <error> of a sensor or an actuator. @param device its type; "" if that is not known
std::vector<ErrorModelDescription> readErrors(const XmlElement& element, const std::string& device);
/// Checks an error as far as that goes without its device, whoever describes it, and fills in defaults of its kind.
/// @throws ConfigError
void completeError(ErrorModelDescription& error);
void readArena(const XmlElement& section, Reader& reader);
/// <distribute> in <arena>.
void readDistribute(const XmlElement& element, Reader& reader);
/// The tags of entities that may stand in an element. Those that name their library are known once it is loaded.
std::vector<std::string> entityTagsIn(const XmlElement& parent);
/// An entity in <distribute>, which has no position.
EntityDescription readDistributedEntity(const XmlElement& element, Reader& reader);
/// An entity as it stands in <arena>, for a run that is under way. Beside <orientation> in degrees it may have
/// <angles>, the same in radians, to the last bit. Whether its id is taken is not looked at.
/// @param experiment with the arena, and the controllers
EntityDescription readSpawnedEntity(const XmlElement& element, const Experiment& experiment);
/// <heightfield> in <arena>, at most one.
void readHeightfield(const XmlElement& element, Reader& reader);
void readFloorPatch(const XmlElement& element, Reader& reader);
void readHole(const XmlElement& element, Reader& reader);
/// <floor_image> in <arena>, at most one.
void readFloorImage(const XmlElement& element, Reader& reader);
/// <floor_paint> in <arena>, at most one.
void readFloorPaint(const XmlElement& element, Reader& reader);
/// A file that the experiment names, from now on one of its files. @return its path: a name that is not absolute is
/// relative to the experiment file's folder
std::string takeFile(const std::string& name, Reader& reader);
void readEngines(const XmlElement& section, Reader& reader);
void readArenaPhysics(const XmlElement& section, Reader& reader);
/// @param entities, engines the ids that there are
void readHandover(const XmlElement& element, const KnownNames& entities, const KnownNames& engines, Reader& reader);
/// Warns of each robot whose actuators have no engine that carries them out. After all sections are read.
void warnOfUnmovedRobots(Reader& reader);
/// All that <engines>, <rules> or <visualisations> lists.
std::vector<PluginUse> readPluginUses(const XmlElement& section, PluginKind kind, Reader& reader);

/// Reads all sections. The reader's experiment has its name, file and text.
void readDocument(const XmlElement& root, Reader& reader);

/// What a plugin reads. Of one that is in a library which was not loaded, whatever stands there.
/// @param others children that are no parameters
Configuration readPluginParameters(const XmlElement& element, const PluginDescription& plugin,
                                   const std::vector<std::string>& others = {});

/// Whatever elements and attributes an element has, for code that says itself what it reads; but nothing that its
/// reader would pass over in silence. @param others attributes that are no parameters @throws ConfigError
Configuration readFreeParameters(const XmlElement& element, const std::vector<std::string>& others = {});

/// The text of a file that people write. @throws ConfigError if it cannot be read, or has no end in sight
std::string textOf(const std::string& file);

/// Sets values in the document before it is read.
/// @return what the document's elements point to, so it must live as long as they are read
/// @throws ConfigError for a path that leads nowhere, or to more than one place
std::deque<OverrideMarks> applyOverrides(xmlDoc& document, const std::vector<Override>& overrides);

}  // namespace swarmanoid::experiment
