// Networks compared with computations by hand, or with closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "../src/neural/feed_forward_network.hpp"
#include "../src/neural/recurrent_network.hpp"

namespace swarmanoid::neural {
namespace {

TEST(ActivationTest, IsTheFunctionOfTheBooks) {
  for (double x = -30.0; x <= 30.0; x += 0.37) {
    EXPECT_NEAR(tanh(x), std::tanh(x), 4e-16) << x;
    EXPECT_NEAR(logistic(x), 0.5 * (1.0 + std::tanh(0.5 * x)), 4e-16) << x;
  }
  EXPECT_EQ(tanh(-1e300), -1.0);
  EXPECT_EQ(tanh(0.0), 0.0);
  EXPECT_EQ(logistic(-1e300), 0.0);
  EXPECT_EQ(logistic(1e300), 1.0);
}

TEST(FeedForwardNetworkTest, AnswersAsComputedByHand) {
  // hidden: 0.5 + 1 * 0.5 + 2 * -1 = -1 and 1 - 2 * 0.5 - 1 * -1 = 1; output: 0.1 + 2 tanh(-1) - tanh(1) = -2.18478...
  FeedForwardNetwork network({2, 2, 1}, {1.0, 2.0, -2.0, -1.0, 2.0, -1.0}, {0.5, 1.0, 0.1});
  network.inputs() = {0.5, -1.0};
  network.evaluate();
  EXPECT_NEAR(network.outputs()[0], 0.10112537615564625, 1e-13);
}

TEST(FeedForwardNetworkTest, WithoutAHiddenLayerIsAPerceptron) {
  FeedForwardNetwork network({2, 2}, {1.0, -1.0, 0.0, 4.0}, {0.0, -1.0});
  network.inputs() = {2.0, 0.25};
  network.evaluate();
  EXPECT_NEAR(network.outputs()[0], 1.0 / (1.0 + std::exp(-1.75)), 1e-15);
  EXPECT_EQ(network.outputs()[1], 0.5);  // -1 + 4 * 0.25 = 0
}

TEST(FeedForwardNetworkTest, CountsItsParameters) {
  EXPECT_EQ(FeedForwardNetwork::weightCount({24, 5, 3, 2}), 24U * 5 + 5 * 3 + 3 * 2);
  EXPECT_EQ(FeedForwardNetwork::biasCount({24, 5, 3, 2}), 10U);
}

TEST(RecurrentNetworkTest, OneNeuronDecaysTowardsItsInputAsTheEquationSays) {
  // tau y' = -y + g I  with y(0) = 0:  y = g I (1 - e^(-t / tau))
  constexpr double kTau = 0.7;
  RecurrentNetwork network(1, 1, {2.0, 0.0}, {0.3}, {kTau});
  network.inputs() = {1.5};
  double t = 0.0;
  for (int k = 0; k < 40; ++k) {
    const double dt = k % 2 == 0 ? 0.1 : 0.25;
    network.advance(dt);
    t += dt;
    const double y = 3.0 * (1.0 - std::exp(-t / kTau));
    ASSERT_NEAR(network.states()[0], y, 1e-14) << "t = " << t;
    ASSERT_NEAR(network.outputs()[0], 1.0 / (1.0 + std::exp(-y - 0.3)), 1e-14);
  }
  network.inputs() = {0.0};  // decay from the current state
  const double from = network.states()[0];
  network.advance(0.35);
  EXPECT_NEAR(network.states()[0], from * std::exp(-0.5), 1e-14);
}

TEST(RecurrentNetworkTest, ANeuronThatExcitesItselfRestsWhereTheEquationDoes) {
  RecurrentNetwork network(1, 1, {1.0, 6.0}, {-3.0}, {0.05});
  for (const double input : {0.0, 2.0, -2.0}) {
    network.inputs() = {input};
    for (int k = 0; k < 500; ++k) {
      network.advance(0.1);  // twice its time constant, the stability limit of Euler's method
    }
    const double y = network.states()[0];
    EXPECT_NEAR(y, input + 6.0 / (1.0 + std::exp(3.0 - y)), 1e-12);
  }
}

TEST(RecurrentNetworkTest, TwoNeuronsConvergeToTheirEquationWithTheStep) {
  // an oscillator of Beer (1995): weights 4.5, 1, -1, 4.5, biases -2.75, -1.75
  const auto after = [](int steps) {
    RecurrentNetwork network(0, 2, {4.5, 1.0, -1.0, 4.5}, {-2.75, -1.75}, {1.0, 1.0});
    for (int k = 0; k < steps; ++k) {
      network.advance(4.0 / steps);
    }
    return network.states();
  };
  // the classical Runge-Kutta method with 4000 steps
  double y[2] = {0.0, 0.0};
  const auto rate = [](const double* at, double* slope) {
    const double first = logistic(at[0] - 2.75);
    const double second = logistic(at[1] - 1.75);
    slope[0] = -at[0] + 4.5 * first + second;
    slope[1] = -at[1] - first + 4.5 * second;
  };
  constexpr int kSteps = 4000;
  constexpr double kStep = 4.0 / kSteps;
  for (int k = 0; k < kSteps; ++k) {
    double slope[4][2];
    double at[2] = {y[0], y[1]};
    for (int stage = 0; stage < 4; ++stage) {
      rate(at, slope[stage]);
      const double ahead = stage == 2 ? kStep : 0.5 * kStep;
      at[0] = y[0] + ahead * slope[stage][0];
      at[1] = y[1] + ahead * slope[stage][1];
    }
    for (int i = 0; i < 2; ++i) {
      y[i] += kStep / 6.0 * (slope[0][i] + 2.0 * slope[1][i] + 2.0 * slope[2][i] + slope[3][i]);
    }
  }
  const double coarse = std::abs(after(100)[0] - y[0]) + std::abs(after(100)[1] - y[1]);
  const double fine = std::abs(after(1000)[0] - y[0]) + std::abs(after(1000)[1] - y[1]);
  EXPECT_LT(fine, 0.01);
  EXPECT_NEAR(coarse / fine, 10.0, 1.0) << "of first order";
}

TEST(RecurrentNetworkTest, AResetForgets) {
  RecurrentNetwork network(1, 2, {1.0, 2.0, -3.0, 0.5, 1.0, 1.0}, {0.1, 0.2}, {0.4, 2.0});
  network.inputs() = {0.7};
  network.advance(0.1);
  const std::vector<double> fresh = network.outputs();
  network.advance(0.1);
  EXPECT_NE(network.outputs(), fresh);
  network.reset();
  network.advance(0.1);
  EXPECT_EQ(network.outputs(), fresh);
}

}  // namespace
}  // namespace swarmanoid::neural
