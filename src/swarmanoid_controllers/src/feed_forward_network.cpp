// A feed-forward neural network: its inputs, outputs, size, weights and biases are parameters. See
// docs/reference/neural_controllers.md.
#include "neural/feed_forward_network.hpp"

#include "neural/network_inputs.hpp"
#include "neural/network_outputs.hpp"
#include "neural/network_parameters.hpp"
#include "required_section.hpp"
#include "swarmanoid_interface/controller.hpp"

namespace swarmanoid {
namespace {

/// "8, 4" means two layers; an empty text means none.
std::vector<std::size_t> hiddenLayers(const Configuration& parameters) {
  const Configuration* found = parameters.find("hidden");
  if (found == nullptr || found->text().empty()) {
    return {};
  }
  constexpr double kLargest = 1000.0;
  const std::string& text = found->text();
  std::vector<std::size_t> sizes;
  std::size_t begin = 0;
  while (begin <= text.size()) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    sizes.push_back(static_cast<std::size_t>(
        parseInteger(text.substr(begin, end - begin), "hidden", found->location(), {1.0, kLargest})));
    begin = end + 1;
  }
  return sizes;
}

}  // namespace

class FeedForwardController final : public Controller {
 public:
  void init(Robot& robot, const Configuration& parameters) override {
    inputs_ = neural::NetworkInputs(robot, requiredSection(parameters, "inputs", "the network"));
    outputs_ = neural::NetworkOutputs(robot, requiredSection(parameters, "outputs", "the network"));
    std::vector<std::size_t> layers = hiddenLayers(parameters);
    layers.insert(layers.begin(), inputs_.size());
    layers.push_back(outputs_.size());
    std::string shape = "neurons by layer: " + std::to_string(layers.front());
    for (std::size_t i = 1; i < layers.size(); ++i) {
      shape += ", " + std::to_string(layers[i]);
    }
    using Network = neural::FeedForwardNetwork;
    std::vector<double> weights = neural::numbersOf(parameters, "weights", Network::weightCount(layers), shape);
    std::vector<double> biases = neural::numbersOf(parameters, "biases", Network::biasCount(layers), shape);
    network_ = Network(std::move(layers), std::move(weights), std::move(biases));
    parameters.refuseUnread({"inputs", "outputs", "hidden", "weights", "biases"});
  }

  void step(Time, Duration) override {
    inputs_.read(network_.inputs());
    network_.evaluate();
    outputs_.write(network_.outputs());
  }

  void archive(StateArchive& /*state*/) override {}

 private:
  neural::NetworkInputs inputs_;
  neural::NetworkOutputs outputs_;
  neural::FeedForwardNetwork network_;
};

}  // namespace swarmanoid

REGISTER_CONTROLLER(swarmanoid::FeedForwardController, "feed_forward_network")
