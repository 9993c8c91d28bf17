/// Interventions in files: what was done to a run from outside, written down so that it can be done to another one.
/// docs/reference/intervention_file.md has the grammar.
///
/// Bits    what is written is read back to the same bits: numbers with as many digits as they need, the angles of what
///         is spawned in radians, the orientation of what is moved as a quaternion.
/// Errors  as of experiment files: file, line, what was found, what is allowed, the nearest right name.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "swarmanoid_space/experiment_file/experiment.hpp"
#include "swarmanoid_space/intervention.hpp"

namespace swarmanoid {

struct RecordedIntervention {
  TakenIntervention taken;
  SourceLocation location;
};

/// A file of interventions, read and checked.
struct InterventionFile {
  std::string file;
  std::string experiment;  ///< the name of that which they were done to; "": it is not said
  std::string seed;        ///< and its seed; "": it is not said
  /// In the order in which they are carried out: ticks do not descend, and in a tick those after the rules come last.
  std::vector<RecordedIntervention> interventions;
};

/// @param experiment which they are to be done to: its engines, controllers and arena are what can be meant
/// @throws ConfigError for the first mistake
InterventionFile readInterventions(const std::string& file, const Experiment& experiment);
/// The same; `name` stands for the file in messages about what is in it.
InterventionFile readInterventions(const std::string& file, const std::string& name, const Experiment& experiment);
/// The same from a text; `name` stands for the file in messages.
InterventionFile parseInterventions(const std::string& text, const std::string& name, const Experiment& experiment);

/// Whether the experiment has the rule that asked for it. @param asked_by as TakenIntervention has it; its label does
/// not count
bool hasRule(const Experiment& experiment, const std::string& asked_by);

/// The tag of an intervention: "spawn", "delete", "move", "handover", "engine_parameters", "command_source",
/// "property", "paint", "fault".
const char* kindOf(const Intervention& intervention);

/// As an element, in lines. @param depth by how many levels it is indented
std::string toXml(const TakenIntervention& taken, int depth = 0);

/// What stands before the elements of a file, and what behind them.
std::string interventionsBegin(const std::string& experiment, std::uint64_t seed);
std::string interventionsEnd();

}  // namespace swarmanoid
