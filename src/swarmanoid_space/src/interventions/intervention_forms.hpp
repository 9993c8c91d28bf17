/// How each kind of intervention stands in a file.
///
/// When you add a kind of intervention, add its InterventionForm in intervention_forms.cpp: what is missing there does
/// not compile.
#pragma once

#include <array>
#include <string>
#include <variant>
#include <vector>

#include "../experiment_file/xml_element.hpp"
#include "../xml/element_text.hpp"
#include "swarmanoid_space/intervention.hpp"

namespace swarmanoid {

/// One kind, for both directions.
struct InterventionGrammar {
  const char* tag;
  std::vector<std::string> attributes;  ///< beside those that all kinds have
  /// @throws ConfigError
  Intervention (*read)(const experiment::XmlElement& element, const Experiment& experiment);
  /// The element has begun, and what all kinds have is written.
  void (*write)(const Intervention& intervention, ElementText& text);
};

/// In the order of the variant's alternatives.
const std::array<InterventionGrammar, std::variant_size_v<Intervention>>& interventionGrammars();

}  // namespace swarmanoid
