#include "swarmanoid_interface/configuration.hpp"

#include <algorithm>

namespace swarmanoid {

Configuration& Configuration::add(Configuration child) {
  children_.push_back(std::move(child));
  return children_.back();
}

Configuration& Configuration::set(const std::string& name, const std::string& text) {
  return add(Configuration(name, text, location_));
}

const Configuration* Configuration::firstOf(std::string_view key) const {
  const auto child = std::find_if(children_.begin(), children_.end(),
                                  [&](const Configuration& candidate) { return candidate.name_ == key; });
  return child == children_.end() ? nullptr : &*child;
}

const Configuration* Configuration::find(std::string_view key) const {
  const Configuration* child = firstOf(key);
  if (child != nullptr) {
    child->read_ = true;
  }
  return child;
}

const Configuration& Configuration::require(std::string_view key) const {
  const Configuration* child = find(key);
  if (child == nullptr) {
    throw ConfigError(location_, "<" + name_ + "> has no '" + std::string(key) + "', which it needs");
  }
  return *child;
}

double Configuration::number(std::string_view key, Range range) const {
  const Configuration& child = require(key);
  return parseNumber(child.text_, std::string(key), child.location_, range);
}

double Configuration::number(std::string_view key, double fallback, Range range) const {
  return has(key) ? number(key, range) : fallback;
}

std::int64_t Configuration::integer(std::string_view key, Range range) const {
  const Configuration& child = require(key);
  return parseInteger(child.text_, std::string(key), child.location_, range);
}

std::int64_t Configuration::integer(std::string_view key, std::int64_t fallback, Range range) const {
  return has(key) ? integer(key, range) : fallback;
}

bool Configuration::boolean(std::string_view key) const {
  const Configuration& child = require(key);
  return parseBoolean(child.text_, std::string(key), child.location_);
}

bool Configuration::boolean(std::string_view key, bool fallback) const { return has(key) ? boolean(key) : fallback; }

std::string Configuration::text(std::string_view key) const { return require(key).text_; }

std::string Configuration::text(std::string_view key, const std::string& fallback) const {
  return has(key) ? text(key) : fallback;
}

Color Configuration::color(std::string_view key) const {
  const Configuration& child = require(key);
  return parseColorOrThrow(child.text_, std::string(key), child.location_);
}

Color Configuration::color(std::string_view key, Color fallback) const { return has(key) ? color(key) : fallback; }

Eigen::Vector2d Configuration::vector2(std::string_view key) const {
  const Configuration& child = require(key);
  const std::vector<double> values = parseNumbers(child.text_, 2, std::string(key), child.location_);
  return {values[0], values[1]};
}

Eigen::Vector3d Configuration::vector3(std::string_view key) const {
  const Configuration& child = require(key);
  const std::vector<double> values = parseNumbers(child.text_, 3, std::string(key), child.location_);
  return {values[0], values[1], values[2]};
}

Eigen::Vector3d Configuration::vector3(std::string_view key, const Eigen::Vector3d& fallback) const {
  return has(key) ? vector3(key) : fallback;
}

double Configuration::angle(std::string_view key, double fallback_rad, Range range_deg) const {
  constexpr double kRadPerDeg = 3.14159265358979323846 / 180.0;
  return has(key) ? number(key, range_deg) * kRadPerDeg : fallback_rad;
}

void Configuration::refuseUnread(const std::vector<std::string>& known) const {
  for (const Configuration& child : children_) {
    if (!child.read_) {
      // only the first child of a name is ever read
      if (const Configuration* first = firstOf(child.name_); first != &child && first->read_) {
        throw ConfigError(child.location_, "'" + child.name_ + "' stands in <" + name_ + "> twice");
      }
      throw ConfigError(child.location_, "'" + child.name_ + "' is not known in <" + name_ + ">" +
                                             (known.empty() ? "" : "; allowed: " + joinNames(known)) +
                                             didYouMean(child.name_, known));
    }
  }
}

}  // namespace swarmanoid
