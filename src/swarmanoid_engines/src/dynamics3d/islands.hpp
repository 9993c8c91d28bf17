/// Islands: bodies that contacts and other joints connect, which a solver has to solve as one.
///
/// The time of ODE's exact solver grows with the cube of an island's joints: forty footbots that are pressed into a
/// corner would take seconds a tick. Islands that are too large for it are left to the iterative solver.
#pragma once

#include <vector>

#include "dynamics3d/body.hpp"

namespace swarmanoid::dynamics3d {

class Islands {
 public:
  /// Finds the large islands of the step under way. @pre its joints are made; no body of `bodies` is disabled but those
  /// left out of ODE
  void find(const std::vector<Body*>& bodies);
  bool hasLarge() const { return largest_ > 0; }
  /// Bodies of the largest island that was found since the object was made or cleared; 0: none was too large.
  int largestEver() const { return largest_ever_; }
  void clear() { *this = Islands(); }

  /// Lets ODE's next step move the bodies of large islands alone, or those of all others alone.
  static void enableOnly(const std::vector<Body*>& bodies, bool is_large);
  /// After the step.
  static void enableAll(const std::vector<Body*>& bodies);

 private:
  struct Size {
    int bodies = 0;
    int joints = 0;
    bool has_grips = false;
  };
  Size measure(Body& first);
  void visitJoints(Body& body, dBodyID rigid, Size& size);
  static bool isLarge(const Size& size);

  std::vector<Body*> island_;  // scratch
  int largest_ = 0;            // bodies of the largest large island
  int largest_ever_ = 0;
};

}  // namespace swarmanoid::dynamics3d
