/// How faults of a device stand in a file of interventions, and in words.
#pragma once

#include <string>
#include <vector>

#include "../experiment_file/xml_element.hpp"
#include "../xml/element_text.hpp"
#include "swarmanoid_space/intervention.hpp"

namespace swarmanoid {

// As InterventionGrammar has them.
SetFault readFault(const experiment::XmlElement& element, const Experiment& experiment);
/// Parameters that have their default are left out.
void writeFault(const SetFault& what, ElementText& text);

/// "stuck on value[3], gaussian (deviation 0.02) on value from tick 300"; "mended" without any. The same text has the
/// same effect. @param errors complete: parameters of known kinds, with their defaults
std::string describeFaults(const std::vector<ErrorModelDescription>& errors);

}  // namespace swarmanoid
