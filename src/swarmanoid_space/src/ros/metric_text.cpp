#include "swarmanoid_space/ros/metric_text.hpp"

#include <ios>
#include <variant>

#include "swarmanoid_interface/plain_text.hpp"

namespace swarmanoid {

std::string metricText(const Metrics::mapped_type& value) {
  PlainTextStream text;
  text.precision(17);
  std::visit([&](const auto& held) { text << std::boolalpha << held; }, value);
  return text.str();
}

}  // namespace swarmanoid
