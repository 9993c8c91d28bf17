/// A feed-forward network: layers of neurons, each of which is connected to all neurons of the layer before.
///
///     neuron    a_i = f(b_i + sum_j w_ij a_j)    a_j of the layer before; f: logistic in the last layer, else tanh
///     weights   by layer, then by neuron, then by neuron of the layer before
///     biases    by layer, then by neuron
///
/// Threads  one network belongs to one robot. No allocation after construction.
#pragma once

#include <cstddef>
#include <vector>

#include "activation.hpp"
#include "swarmanoid_interface/expects.hpp"

namespace swarmanoid::neural {

class FeedForwardNetwork {
 public:
  FeedForwardNetwork() = default;
  /// @param layers sizes: inputs, hidden layers if any, outputs
  /// @pre weightCount(layers) weights and biasCount(layers) biases
  FeedForwardNetwork(std::vector<std::size_t> layers, std::vector<double> weights, std::vector<double> biases)
      : layers_(std::move(layers)), weights_(std::move(weights)), biases_(std::move(biases)) {
    SWARMANOID_EXPECTS(weights_.size() == weightCount(layers_) && biases_.size() == biasCount(layers_));
    for (const std::size_t size : layers_) {
      activations_.emplace_back(size, 0.0);
    }
  }

  static std::size_t weightCount(const std::vector<std::size_t>& layers) {
    std::size_t count = 0;
    for (std::size_t i = 1; i < layers.size(); ++i) {
      count += layers[i - 1] * layers[i];
    }
    return count;
  }
  static std::size_t biasCount(const std::vector<std::size_t>& layers) {
    std::size_t count = 0;
    for (std::size_t i = 1; i < layers.size(); ++i) {
      count += layers[i];
    }
    return count;
  }

  /// Set before `evaluate`.
  std::vector<double>& inputs() { return activations_.front(); }
  /// In [0, 1].
  const std::vector<double>& outputs() const { return activations_.back(); }

  void evaluate() {
    const double* weight = weights_.data();
    const double* bias = biases_.data();
    for (std::size_t layer = 1; layer < activations_.size(); ++layer) {
      for (double& activation : activations_[layer]) {
        double sum = *bias++;
        for (const double before : activations_[layer - 1]) {
          sum += *weight++ * before;
        }
        activation = layer + 1 == activations_.size() ? logistic(sum) : tanh(sum);
      }
    }
  }

 private:
  std::vector<std::size_t> layers_;
  std::vector<double> weights_;
  std::vector<double> biases_;
  std::vector<std::vector<double>> activations_;  // by layer
};

}  // namespace swarmanoid::neural
