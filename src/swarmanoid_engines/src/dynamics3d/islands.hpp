/// Islands: bodies connected by contacts and other joints, which a solver must solve together.
///
/// The time of ODE's exact solver grows with the cube of an island's joints: 40 footbots pressed into a corner would
/// take seconds a tick. Islands with more than a few contacts go to the crowd solver. Islands with grips, ropes or
/// links, which only ODE knows, go to the exact solver up to a larger size, and beyond it to ODE's iterative solver.
#pragma once

#include <vector>

#include "dynamics3d/touches.hpp"

namespace swarmanoid::dynamics3d {

class Islands {
 public:
  /// Finds the islands of a step and sets Body::island. @param bodies by rank; ODE bodies are disabled only if the body
  /// is left out (steady_motion.hpp)
  void find(const std::vector<Body*>& bodies, const std::vector<Touch>& touches);
  /// Returns whether all islands are for the exact solver.
  bool areAllSmall() const { return are_all_small_; }
  /// Returns whether an island is so large that its forces need several steps to spread.
  bool hasLarge() const { return largest_ > 0; }
  /// Returns the number of bodies of the largest such island since construction or clear; 0: there was none.
  int largestEver() const { return largest_ever_; }
  void clear() { *this = Islands(); }

  /// Enables the bodies of small islands for ODE's next step and disables the others, or the reverse.
  static void enableSmall(const std::vector<Body*>& bodies, bool is_small);
  static void enableAll(const std::vector<Body*>& bodies);
  /// Resets Body::island after the step.
  static void forget(const std::vector<Body*>& bodies);

 private:
  /// Counts of an island, stored at the rank of its root.
  struct Island {
    int bodies = 0;
    int joints = 0;
    bool has_links = false;
    bool has_grips = false;
  };

  std::size_t rootOf(std::size_t rank);
  void join(const Body& a, const Body& b);
  /// Joins the body with everything that its joints and ropes connect.
  void joinHeld(Body& body);
  void joinBy(Body& body, dBodyID rigid);
  static bool isLarge(const Island& island);
  static Body::Island solverOf(const Island& island);

  std::vector<std::size_t> parents_;  // union-find forest, by rank; roots are the first bodies of their islands
  std::vector<Island> islands_;       // by rank; valid for roots
  int largest_ = 0;                   // bodies of the largest large island
  int largest_ever_ = 0;
  bool are_all_small_ = true;
};

}  // namespace swarmanoid::dynamics3d
