/// The forms of device faults: in a file of interventions, and in words.
#pragma once

#include <string>
#include <vector>

#include "../experiment_file/xml_element.hpp"
#include "../xml/element_text.hpp"
#include "swarmanoid_space/intervention.hpp"

namespace swarmanoid {

// See InterventionGrammar.
SetFault readFault(const experiment::XmlElement& element, const Experiment& experiment);
/// Parameters with their default value are left out.
void writeFault(const SetFault& what, ElementText& text);

/// Returns "stuck on value[3], gaussian (deviation 0.02) on value from tick 300"; "mended" without any fault. Faults
/// with the same text have the same effect. @param errors complete: parameters of known kinds, with their defaults
std::string describeFaults(const std::vector<ErrorModelDescription>& errors);

}  // namespace swarmanoid
