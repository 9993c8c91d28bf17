// A continuous-time recurrent neural network (Beer 1995): its inputs, outputs, size, weights, biases and time constants
// are parameters. See docs/reference/neural_controllers.md.
#include "neural/recurrent_network.hpp"

#include "neural/network_inputs.hpp"
#include "neural/network_outputs.hpp"
#include "neural/network_parameters.hpp"
#include "required_section.hpp"
#include "swarmanoid_interface/controller.hpp"

namespace swarmanoid {

class RecurrentController final : public Controller {
 public:
  void init(Robot& robot, const Configuration& parameters) override {
    constexpr double kMostHidden = 1000.0;
    const Range time_constants{0.001, 1e6};  // s
    inputs_ = neural::NetworkInputs(robot, requiredSection(parameters, "inputs", "the network"));
    outputs_ = neural::NetworkOutputs(robot, requiredSection(parameters, "outputs", "the network"));
    const auto hidden = static_cast<std::size_t>(parameters.integer("hidden", 0, {0.0, kMostHidden}));
    const std::size_t neurons = hidden + outputs_.size();
    const std::string shape = std::to_string(inputs_.size()) + " inputs, " + std::to_string(neurons) + " neurons";
    using Network = neural::RecurrentNetwork;
    std::vector<double> weights =
        neural::numbersOf(parameters, "weights", Network::weightCount(inputs_.size(), neurons), shape);
    std::vector<double> biases = neural::numbersOf(parameters, "biases", neurons, shape);
    std::vector<double> constants = neural::numbersOf(parameters, "time_constants", neurons, shape, time_constants);
    network_ = Network(inputs_.size(), outputs_.size(), std::move(weights), std::move(biases), std::move(constants));
    parameters.refuseUnread({"inputs", "outputs", "hidden", "weights", "biases", "time_constants"});
  }

  void reset() override { network_.reset(); }

  void step(Time, Duration dt) override {
    inputs_.read(network_.inputs());
    network_.advance(toSeconds(dt));
    outputs_.write(network_.outputs());
  }

  void archive(StateArchive& state) override { state(network_); }

 private:
  neural::NetworkInputs inputs_;
  neural::NetworkOutputs outputs_;
  neural::RecurrentNetwork network_;
};

}  // namespace swarmanoid

REGISTER_CONTROLLER(swarmanoid::RecurrentController, "recurrent_network")
