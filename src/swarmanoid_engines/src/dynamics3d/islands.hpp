/// Islands: bodies that contacts and other joints connect, which a solver has to solve as one.
///
/// The time of ODE's exact solver grows with the cube of an island's joints: forty footbots that are pressed into a
/// corner would take seconds a tick. So islands of more than a few contacts go to the crowd solver. Where joints hold
/// bodies together the exact solver goes on to larger ones, and the rest go to ODE's iterative solver.
#pragma once

#include <vector>

#include "dynamics3d/touches.hpp"

namespace swarmanoid::dynamics3d {

class Islands {
 public:
  /// Sorts the bodies of the step under way into islands (Body::island). @param bodies by rank, none of them disabled
  /// but those left out of ODE
  void find(const std::vector<Body*>& bodies, const std::vector<Touch>& touches);
  /// Whether all islands are for the exact solver.
  bool areAllSmall() const { return are_all_small_; }
  /// Whether there is one of so many bodies that forces spread in it over some steps, instead of being right at once.
  bool hasLarge() const { return largest_ > 0; }
  /// Bodies of the largest island that was found since the object was made or cleared; 0: none was too large.
  int largestEver() const { return largest_ever_; }
  void clear() { *this = Islands(); }

  /// Lets ODE's next step move the bodies of small islands alone, or those of all others alone.
  static void enableSmall(const std::vector<Body*>& bodies, bool is_small);
  static void enableAll(const std::vector<Body*>& bodies);
  /// After the step.
  static void forget(const std::vector<Body*>& bodies);

 private:
  /// What a body is part of, where it stands for its island.
  struct Island {
    int bodies = 0;
    int joints = 0;
    bool has_links = false;
    bool has_grips = false;
  };

  std::size_t rootOf(std::size_t rank);
  void join(const Body& a, const Body& b);
  void joinHeld(Body& body);
  void joinBy(Body& body, dBodyID rigid);
  static bool isLarge(const Island& island);
  static Body::Island solverOf(const Island& island);

  std::vector<std::size_t> parents_;  // by rank: another body of the island, which is nearer to its root, or itself
  std::vector<Island> islands_;       // by rank; of roots
  int largest_ = 0;                   // bodies of the largest large island
  int largest_ever_ = 0;
  bool are_all_small_ = true;
};

}  // namespace swarmanoid::dynamics3d
