/// Islands: bodies connected by contacts and other joints, which a solver must solve together.
///
/// Islands that only contacts connect go to the contact solver (contact_solver.hpp). Islands with grips, ropes or
/// links, which only ODE knows, go to ODE's exact solver. Its time grows with the cube of an island's joints, so large
/// ones go to ODE's iterative solver.
#pragma once

#include <vector>

#include "dynamics3d/contacts/touches.hpp"

namespace swarmanoid::dynamics3d {

class Islands {
 public:
  /// Finds the islands of a step and sets Body::island. @param bodies by rank; ODE bodies are disabled only if the body
  /// is left out (steady_motion.hpp)
  void find(const std::vector<Body*>& bodies, const std::vector<Touch>& touches);
  /// Returns whether an island is for ODE's exact solver.
  bool hasSmall() const { return has_small_; }
  /// Returns whether an island is for another solver.
  bool hasOthers() const { return has_others_; }
  /// Returns whether an island is so large that its forces need several steps to spread.
  bool hasLarge() const { return largest_ > 0; }
  /// Returns the number of bodies of the largest such island since construction or clear; 0: there was none.
  int largestEver() const { return largest_ever_; }
  void clear() { *this = Islands(); }

  /// Marks the small island of a body: its solution must be corrected.
  void markAstray(const Body& body) { is_astray_[static_cast<std::size_t>(body.island_first)] = 1; }
  /// Disables the small islands that are not marked and calls them solved; removes the marks. @return whether an island
  /// was marked
  bool leaveAstray(const std::vector<Body*>& bodies);
  /// Enables all islands that leaveAstray called solved, and calls them small again.
  static void reopenSolved(const std::vector<Body*>& bodies);

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
    bool has_grips = false;  // or ropes
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
  std::vector<char> is_astray_;       // by rank; valid for roots
  int largest_ = 0;                   // bodies of the largest large island
  int largest_ever_ = 0;
  bool has_small_ = false;
  bool has_others_ = false;
};

}  // namespace swarmanoid::dynamics3d
