/// The form of a spawned entity in a file of interventions, and functions shared with the forms of the other kinds.
#pragma once

#include <string>

#include "swarmanoid_experiment_files/xml/element_text.hpp"
#include "swarmanoid_experiment_files/xml/xml_element.hpp"
#include "swarmanoid_space/intervention.hpp"

namespace swarmanoid {

/// Returns the numbers separated by commas, each with the shortest text that is read as the same number.
template <class Numbers>
std::string numbersText(const Numbers& numbers) {
  std::string text;
  for (const double number : numbers) {
    text += (text.empty() ? "" : ", ") + numberText(number);
  }
  return text;
}

/// @return the id @throws ConfigError at the place of the attribute if no engine has it
std::string requireEngineId(const experiment::XmlElement& element, const char* attribute, const std::string& id,
                            const Experiment& experiment);

// See InterventionGrammar.
SpawnEntity readSpawn(const experiment::XmlElement& element, const Experiment& experiment);
void writeSpawn(const SpawnEntity& what, ElementText& text);

}  // namespace swarmanoid
