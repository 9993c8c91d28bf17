/// Outputs of a neural network: commands of actuators.
///
/// Threads  const after construction, except the commands, which belong to one robot.
#pragma once

#include "port.hpp"

namespace swarmanoid::neural {

class NetworkOutputs {
 public:
  NetworkOutputs() = default;
  /// @param outputs the element <outputs> @throws ConfigError
  NetworkOutputs(Robot& robot, const Configuration& outputs);

  std::size_t size() const { return targets_.size(); }
  /// @param values in [0, 1], from the minimum of the field to its maximum
  void write(const std::vector<double>& values) const;

 private:
  struct Target {
    std::byte* device = nullptr;
    NumberPlace place;
    Range range;
  };

  std::vector<Target> targets_;
  std::vector<Target> constants_;  // fields with a fixed command, whose range holds the value
};

}  // namespace swarmanoid::neural
