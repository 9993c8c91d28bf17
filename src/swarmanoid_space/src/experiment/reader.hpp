/// What the readers of the sections share, and the readers themselves, one file each.
#pragma once

#include <deque>
#include <map>
#include <string>
#include <vector>

#include "parameter_table.hpp"
#include "swarmanoid_space/experiment.hpp"
#include "tags.hpp"
#include "xml_element.hpp"

namespace swarmanoid::experiment {

/// The experiment under construction, and what its parts must not collide with.
struct Reader {
  Experiment experiment;
  std::map<std::string, SourceLocation>
      ids;  ///< of controllers, entities, patches, engines, handovers, visualisations, by kind
  std::vector<std::string> warnings;

  /// @throws ConfigError if the id is taken within its kind ("controller", "entity", "engine", ...)
  void takeId(const std::string& kind, const std::string& id, const XmlElement& element);

  /// The registry's entry for a tag; loads `library` first if it is not empty.
  /// @throws ConfigError naming what there is
  const Registry::Entry& requirePlugin(PluginKind kind, const XmlElement& element, const std::string& library);
};

/// Which of two libraries with one label is meant must not depend on which was loaded first.
/// @param library that the element asks for; "": any
/// @throws ConfigError if it is not the one that has the plugin, for another with that label was first
void refuseSecondLibrary(const Registry::Entry& entry, const XmlElement& element, const std::string& library);

void readFramework(const XmlElement& section, Reader& reader);
void readControllers(const XmlElement& section, Reader& reader);
void readArena(const XmlElement& section, Reader& reader);
/// <heightfield> in <arena>, at most one.
void readHeightfield(const XmlElement& element, Reader& reader);
void readEngines(const XmlElement& section, Reader& reader);
void readArenaPhysics(const XmlElement& section, Reader& reader);
/// @param entities, engines the ids that there are
void readHandover(const XmlElement& element, const std::vector<std::string>& entities,
                  const std::vector<std::string>& engines, Reader& reader);
void readVisualisations(const XmlElement& section, Reader& reader);

/// Ids that end up in file names, topics and frames: letters, digits and _, a letter first.
/// @throws ConfigError
void checkName(const std::string& id, const XmlElement& element);

/// Reads all sections. `start` has the experiment's name, file and text.
Experiment readDocument(const XmlElement& root, Experiment start);

/// Sets values in the document before it is read.
/// @return what the document's elements point to, so it must live as long as they are read
/// @throws ConfigError for a path that leads nowhere, or to more than one place
std::deque<OverrideMarks> applyOverrides(tinyxml2::XMLDocument& document, const std::vector<Override>& overrides);

}  // namespace swarmanoid::experiment
