/// Files of interventions: the interventions of one run, stored so that they can be applied to another one. The grammar
/// is in docs/reference/intervention_file.md.
///
/// Bits    a file restores the same bits: numbers have as many digits as needed, angles of spawned entities are in
///         radians, orientations of moved entities are quaternions.
/// Errors  the same as for experiment files: file, line, found text, allowed values, the nearest valid name.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "swarmanoid_space/experiment/experiment.hpp"
#include "swarmanoid_space/intervention.hpp"

namespace swarmanoid {

/// A file of interventions, read and checked.
struct InterventionFile {
  std::string file;
  std::string experiment;  ///< name of the original experiment; "": not given
  std::string seed;        ///< seed of the original run; "": not given
  /// In the order of execution: ticks do not descend, and in a tick those after the rules come last.
  std::vector<RecordedIntervention> interventions;
};

/// @param experiment to which they will be applied; they may refer to its engines, controllers and arena
/// @throws ConfigError for the first mistake
InterventionFile readInterventions(const std::string& file, const Experiment& experiment);
/// The same; `name` replaces the file in messages about its contents.
InterventionFile readInterventions(const std::string& file, const std::string& name, const Experiment& experiment);
/// The same for a text; `name` replaces the file in messages.
InterventionFile parseInterventions(const std::string& text, const std::string& name, const Experiment& experiment);

/// Whether the experiment has the rule that requested an intervention. @param asked_by as in TakenIntervention; the
/// label of the rule is ignored
bool hasRule(const Experiment& experiment, const std::string& asked_by);

/// The XML element, in lines. @param depth levels of indentation
std::string toXml(const TakenIntervention& taken, int depth = 0);

/// The beginning and the end of a file, around its elements.
std::string interventionsBegin(const std::string& experiment, std::uint64_t seed);
std::string interventionsEnd();

}  // namespace swarmanoid
