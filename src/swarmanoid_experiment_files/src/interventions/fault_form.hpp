/// The form of device faults in a file of interventions.
#pragma once

#include <string>
#include <vector>

#include "swarmanoid_experiment_files/xml/element_text.hpp"
#include "swarmanoid_experiment_files/xml/xml_element.hpp"
#include "swarmanoid_space/intervention.hpp"

namespace swarmanoid {

// See InterventionGrammar.
SetFault readFault(const experiment::XmlElement& element, const Experiment& experiment);
/// Parameters with their default value are left out.
void writeFault(const SetFault& what, ElementText& text);

}  // namespace swarmanoid
