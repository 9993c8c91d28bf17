/// The form of each kind of intervention in a file.
///
/// When you add a kind of intervention, add its InterventionForm in intervention_forms.cpp; the code does not compile
/// without it.
#pragma once

#include <array>
#include <string>
#include <variant>
#include <vector>

#include "swarmanoid_experiment_files/xml/element_text.hpp"
#include "swarmanoid_experiment_files/xml/xml_element.hpp"
#include "swarmanoid_space/intervention.hpp"

namespace swarmanoid {

/// Reads and writes one kind.
struct InterventionGrammar {
  const char* tag;
  std::vector<std::string> attributes;  ///< in addition to the attributes of all kinds
  /// @throws ConfigError
  Intervention (*read)(const experiment::XmlElement& element, const Experiment& experiment);
  /// Called after the element has been opened and the attributes of all kinds have been written.
  void (*write)(const Intervention& intervention, ElementText& text);
};

/// Grammars in the order of the variant's alternatives.
const std::array<InterventionGrammar, std::variant_size_v<Intervention>>& interventionGrammars();

}  // namespace swarmanoid
