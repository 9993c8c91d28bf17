// <visualisations>: who looks at the run.
#include "reader.hpp"

namespace swarmanoid::experiment {

void readVisualisations(const XmlElement& section, Reader& reader) {
  section.allowAttributes({});
  section.refuseText();
  for (const XmlElement& element : section.children()) {
    element.allowAttributes(attributesOf("visualisations/*"));
    VisualisationDescription visualisation;
    visualisation.location = element.location();
    visualisation.id = element.requireAttribute("id");
    visualisation.library = element.attribute("library").value_or("");
    reader.takeId("visualisation", visualisation.id, element);
    const Registry::Entry& entry = reader.requirePlugin(PluginKind::kObserver, element, visualisation.library);
    visualisation.label = entry.description.label;
    visualisation.parameters = readPluginParameters(element, entry.description);
    reader.experiment.visualisations.push_back(std::move(visualisation));
  }
}

}  // namespace swarmanoid::experiment
