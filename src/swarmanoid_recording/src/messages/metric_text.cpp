#include "swarmanoid_recording/messages/metric_text.hpp"

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

std::vector<swarmanoid_msgs::TextParameter> toMessages(const Metrics& metrics) {
  std::vector<swarmanoid_msgs::TextParameter> messages;
  for (const auto& [name, value] : metrics) {
    messages.emplace_back();
    messages.back().name = name;
    messages.back().value = metricText(value);
  }
  return messages;
}

}  // namespace swarmanoid
