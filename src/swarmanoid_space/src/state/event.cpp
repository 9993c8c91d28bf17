#include "swarmanoid_space/state/event.hpp"

namespace swarmanoid {

const char* toString(Event::Kind kind) {
  switch (kind) {
    case Event::Kind::kAttached:
      return "attached";
    case Event::Kind::kReleased:
      return "released";
    case Event::Kind::kControllerFailed:
      return "controller_failed";
    case Event::Kind::kLeftArena:
      return "left_arena";
    case Event::Kind::kOverflow:
      return "overflow";
    case Event::Kind::kSpawned:
      return "spawned";
    case Event::Kind::kDeleted:
      return "deleted";
    case Event::Kind::kMoved:
      return "moved";
    case Event::Kind::kIntervention:
      return "intervention";
    case Event::Kind::kInterventionRefused:
      return "intervention_refused";
    case Event::Kind::kFinished:
      return "finished";
    case Event::Kind::kHandedOver:
      return "handed_over";
    case Event::Kind::kHandoverRefused:
      return "handover_refused";
    case Event::Kind::kEngineTrouble:
      return "engine_trouble";
    case Event::Kind::kParticipantLate:
      return "participant_late";
    case Event::Kind::kParticipantJoined:
      return "participant_joined";
    case Event::Kind::kAnswerRefused:
      return "answer_refused";
    case Event::Kind::kFellIntoHole:
      return "fell_into_hole";
  }
  return "event";
}

}  // namespace swarmanoid
