// Phase 5, at its end: rules for handover look at the new poses and grips, and at what controllers said.
#include "../assembly/handover.hpp"

#include "phases.hpp"

namespace swarmanoid::phases {
namespace {

void attempt(Space& space, const std::vector<Driver>& drivers, HandoverWatch& watch,
             std::vector<std::vector<Seat>>& seats) {
  if (space.mover[static_cast<std::size_t>(watch.row)] == watch.engine) {
    watch.is_due = false;
    return;
  }
  const std::vector<Row> members = connectedTo(space.entities, space.structure, space.attachments, watch.row);
  refreshMirrors(space, seats, *watch.engine);
  const std::string problem = handoverProblem(space, drivers, seats, members, watch.row, *watch.engine);
  if (problem.empty()) {
    commitHandover(space, drivers, seats, members, *watch.engine, space.events);
    watch.is_due = false;
  } else if (!watch.is_refused) {
    watch.is_refused = true;  // told once; tried again each tick, for what is in the way may go
    space.events.push_back({Event::Kind::kHandoverRefused, space.entities.name[static_cast<std::size_t>(watch.row)], "",
                            "to " + watch.engine->id() + ": " + problem});
  }
}

}  // namespace

void handOver(Space& space, const std::vector<Driver>& drivers, std::vector<HandoverWatch>& watches,
              std::vector<std::vector<Seat>>& seats) {
  for (HandoverWatch& watch : watches) {
    if (space.entities.number[static_cast<std::size_t>(watch.row)] != watch.number) {
      continue;  // deleted; whoever has its row now is somebody else
    }
    const bool is_true = holds(*watch.rule, space, watch.row);
    if (is_true != watch.was_true) {
      watch.is_due = is_true;
      watch.is_refused = false;
    }
    watch.was_true = is_true;
    if (watch.is_due) {
      attempt(space, drivers, watch, seats);
    }
  }
}

}  // namespace swarmanoid::phases
