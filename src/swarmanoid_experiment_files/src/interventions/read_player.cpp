#include "swarmanoid_experiment_files/interventions/read_player.hpp"

#include <map>
#include <utility>

namespace swarmanoid {
namespace {

std::string countOf(std::size_t number) {
  return std::to_string(number) + (number == 1 ? " intervention" : " interventions");
}

}  // namespace

std::vector<std::string> playingWarnings(const InterventionFile& file, AskedByRules asked_by_rules,
                                         const Experiment& experiment) {
  std::vector<std::string> warnings;
  if (!file.experiment.empty() && file.experiment != experiment.name) {
    warnings.push_back(file.file + ": recorded with the experiment '" + file.experiment + "', played into '" +
                       experiment.name + "'");
  }
  const std::string seed = std::to_string(experiment.framework.seed);
  if (!file.seed.empty() && file.seed != seed) {
    warnings.push_back(file.file + ": recorded with the seed " + file.seed + ", played into a run with the seed " +
                       seed);
  }
  const bool are_rules_played = asked_by_rules == AskedByRules::kPlayed;
  std::size_t late = 0;
  const RecordedIntervention* first_late = nullptr;
  std::map<std::string, std::size_t> strange;  // by the rule that requested them
  for (const RecordedIntervention& recorded : file.interventions) {
    const std::string& asked_by = recorded.taken.asked_by;
    if (!asked_by.empty() && hasRule(experiment, asked_by) == are_rules_played) {
      ++strange[asked_by];
    }
    if ((asked_by.empty() || are_rules_played) && recorded.taken.tick >= experiment.framework.max_clock) {
      first_late = first_late == nullptr ? &recorded : first_late;
      ++late;
    }
  }
  if (late > 0) {
    warnings.push_back(first_late->location.toString() + ": " + countOf(late) + " from tick " +
                       std::to_string(first_late->taken.tick) + " on will not be played, the run ends after " +
                       std::to_string(experiment.framework.max_clock) + " ticks");
  }
  for (const auto& [asked_by, number] : strange) {
    warnings.push_back(file.file + ": " + countOf(number) + " of " + asked_by +
                       (are_rules_played ? " will be played, and the run has that rule, which may ask for them too"
                                         : " will not be played, and the run has no such rule to ask for them"));
  }
  return warnings;
}

InterventionPlayer readPlayer(const std::string& file, const std::string& name, AskedByRules asked_by_rules,
                              const Experiment& experiment, const std::function<void(const std::string&)>& warn) {
  if (file.empty()) {
    return {};
  }
  InterventionFile interventions = readInterventions(file, name, experiment);
  for (const std::string& warning : playingWarnings(interventions, asked_by_rules, experiment)) {
    warn(warning);
  }
  for (RecordedIntervention& recorded : interventions.interventions) {
    // the run's rule makes its own requests; the played ones count as requests from outside, so that the run can be
    // repeated
    if (asked_by_rules == AskedByRules::kPlayed && hasRule(experiment, recorded.taken.asked_by)) {
      recorded.taken.asked_by.clear();
    }
  }
  return InterventionPlayer(std::move(interventions.interventions), asked_by_rules);
}

}  // namespace swarmanoid
