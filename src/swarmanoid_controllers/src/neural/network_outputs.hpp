/// The outputs of a neural network: commands of actuators.
///
/// Threads  const after they are made, but for the commands, which belong to one robot.
#pragma once

#include "port.hpp"

namespace swarmanoid::neural {

class NetworkOutputs {
 public:
  NetworkOutputs() = default;
  /// @param outputs the element <outputs> @throws ConfigError
  NetworkOutputs(Robot& robot, const Configuration& outputs);

  std::size_t size() const { return targets_.size(); }
  /// @param values from 0, which is the minimum of the field, to 1, its maximum
  void write(const std::vector<double>& values) const;

 private:
  struct Target {
    std::byte* device = nullptr;
    NumberPlace place;
    Range range;
  };

  std::vector<Target> targets_;
  std::vector<Target> constants_;  // what the network does not command: its range is the value
};

}  // namespace swarmanoid::neural
