/// The world in one call of a Python rule: read access, and requests for interventions.
///
/// Units    SI, radians; frame W.
/// Threads  the GIL must be held; valid during that call only.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>

#include "moment.hpp"
#include "robots.hpp"
#include "swarmanoid_interface/random.hpp"
#include "swarmanoid_space/intervention_queue.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid::bindings {

class RuleWorld {
 public:
  RuleWorld(const Space& space, InterventionQueue& queue, RandomStream& random, std::shared_ptr<const Moment> moment)
      : space_(&space), queue_(&queue), random_(&random), moment_(moment), of_moment_(std::move(moment)) {}

  const Space& space() const {
    of_moment_.require();
    return *space_;
  }
  Robots robots() const { return robotsOf(space(), moment_); }
  Robots entities() const { return entitiesOf(space(), moment_); }
  InterventionQueue& queue() const {
    of_moment_.require();
    return *queue_;
  }
  RandomStream& random() const {
    of_moment_.require();
    return *random_;
  }

 private:
  const Space* space_;
  InterventionQueue* queue_;
  RandomStream* random_;
  std::shared_ptr<const Moment> moment_;
  OfMoment of_moment_;
};

void bindRuleWorld(pybind11::module_& module);

}  // namespace swarmanoid::bindings
