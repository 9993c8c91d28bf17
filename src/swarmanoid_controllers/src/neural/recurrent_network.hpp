/// A continuous-time recurrent network: R. D. Beer, "On the dynamics of small continuous-time recurrent neural
/// networks", Adaptive Behavior 3 (1995), equation 1, with weighted inputs.
///
///     tau_i dy_i/dt = -y_i + sum_k g_ik I_k + sum_j w_ij s(y_j + b_j)      s: the logistic function
///
/// The neurons are fully connected, including self-connections. The last ones are the outputs, s(y_i + b_i). All y_i
/// start at 0.
///
///     weights         by neuron: first g from the inputs, then w from the neurons
///     biases          b, by neuron
///     time constants  tau, by neuron [s]
///
/// A step takes the right side as constant and solves the rest exactly, y_i -> r_i + (y_i - r_i) e^(-dt / tau_i): it is
/// stable with every time constant, and exact for pure decay.
///
/// Threads  one network belongs to one robot. No allocation after construction.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "activation.hpp"
#include "swarmanoid_interface/expects.hpp"
#include "swarmanoid_interface/state_archive.hpp"

namespace swarmanoid::neural {

class RecurrentNetwork {
 public:
  RecurrentNetwork() = default;
  /// @param time_constants [s], above 0, one for each neuron @pre the numbers of weights and biases fit
  RecurrentNetwork(std::size_t inputs, std::size_t outputs, std::vector<double> weights, std::vector<double> biases,
                   std::vector<double> time_constants)
      : inputs_(inputs, 0.0),
        outputs_(outputs, 0.0),
        weights_(std::move(weights)),
        biases_(std::move(biases)),
        time_constants_(std::move(time_constants)),
        states_(biases_.size(), 0.0),
        rates_(biases_.size(), 0.0),
        decays_(biases_.size(), 0.0) {
    SWARMANOID_EXPECTS(outputs <= biases_.size() && time_constants_.size() == biases_.size());
    SWARMANOID_EXPECTS(weights_.size() == weightCount(inputs, biases_.size()));
  }

  static std::size_t weightCount(std::size_t inputs, std::size_t neurons) { return neurons * (inputs + neurons); }

  /// Set before `advance`.
  std::vector<double>& inputs() { return inputs_; }
  /// In [0, 1].
  const std::vector<double>& outputs() const { return outputs_; }
  /// y, by neuron.
  const std::vector<double>& states() const { return states_; }

  void reset() { states_.assign(states_.size(), 0.0); }
  void archive(StateArchive& state) { state(states_); }

  /// @param dt [s]
  void advance(double dt) {
    if (dt != dt_) {
      dt_ = dt;
      for (std::size_t i = 0; i < decays_.size(); ++i) {
        decays_[i] = std::exp(-dt / time_constants_[i]);
      }
    }
    takeRates();
    const double* weight = weights_.data();
    for (std::size_t i = 0; i < states_.size(); ++i) {
      double rest = 0.0;
      for (const double input : inputs_) {
        rest += *weight++ * input;
      }
      for (const double rate : rates_) {
        rest += *weight++ * rate;
      }
      states_[i] = rest + (states_[i] - rest) * decays_[i];
    }
    const std::size_t first = states_.size() - outputs_.size();
    for (std::size_t i = 0; i < outputs_.size(); ++i) {
      outputs_[i] = logistic(states_[first + i] + biases_[first + i]);
    }
  }

 private:
  void takeRates() {
    for (std::size_t i = 0; i < rates_.size(); ++i) {
      rates_[i] = logistic(states_[i] + biases_[i]);
    }
  }

  std::vector<double> inputs_;
  std::vector<double> outputs_;
  std::vector<double> weights_;
  std::vector<double> biases_;
  std::vector<double> time_constants_;  // s
  std::vector<double> states_;
  std::vector<double> rates_;   // s(y + b) at the start of a step
  std::vector<double> decays_;  // e^(-dt / tau)
  double dt_ = 0.0;             // s, for which the decays were computed
};

}  // namespace swarmanoid::neural
