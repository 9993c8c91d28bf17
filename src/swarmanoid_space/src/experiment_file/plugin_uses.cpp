// <engines>, <rules>, <visualisations>: sections that list plugins by their ids.
#include "reader.hpp"

namespace swarmanoid::experiment {

std::vector<PluginUse> readPluginUses(const XmlElement& section, PluginKind kind, Reader& reader) {
  section.allowAttributes({});
  section.refuseText();
  std::vector<PluginUse> uses;
  for (const XmlElement& element : section.children()) {
    element.allowAttributes(attributesOf("engines/*"));  // the same in all these sections
    PluginUse use;
    use.location = element.location();
    use.id = element.requireAttribute("id");
    use.library = element.attribute("library").value_or("");
    reader.takeId(toString(kind), use.id, element);
    const Registry::Entry& entry = reader.requirePlugin(kind, element, use.library);
    use.label = entry.description.label;
    use.parameters = readPluginParameters(element, entry.description);
    uses.push_back(std::move(use));
  }
  return uses;
}

}  // namespace swarmanoid::experiment
