#include "collada_parameters.hpp"

#include "xml_values.hpp"

namespace swarmanoid {

void ColladaParameters::open(const XmlTag& tag) {
  last_ = attributeOf(tag, "sid");
  if (last_.empty()) {  // a parameter without a reference would resolve to it
    refuseAt(tag.line, "a <newparam> without a sid, allowed: sid=\"...\"");
  }
  parameters_[last_];
}

void ColladaParameters::refer(const std::string& name) { parameters_[last_].references.insert(name); }

void ColladaParameters::check(int line) {
  for (const auto& [sid, parameter] : parameters_) {
    follow(sid, line, 0);
  }
  parameters_.clear();
}

// NOLINTNEXTLINE(misc-no-recursion): not deeper than kMostReferences
void ColladaParameters::follow(const std::string& name, int line, std::size_t depth) {
  constexpr std::size_t kMostReferences = 100;
  const auto found = parameters_.find(name);
  if (found == parameters_.end() || found->second.is_checked) {
    return;
  }
  Parameter& parameter = found->second;
  if (parameter.is_entered) {
    refuseAt(line, "the parameter " + inQuotes(name) + " of an effect, which leads back to itself, allowed: an image");
  }
  if (depth > kMostReferences) {
    refuseAt(line, "the parameter " + inQuotes(name) + " of an effect behind more than " +
                       std::to_string(kMostReferences) + " others, allowed: fewer");
  }
  parameter.is_entered = true;
  for (const std::string& reference : parameter.references) {
    follow(reference, line, depth + 1);
  }
  parameter.is_checked = true;
}

}  // namespace swarmanoid
