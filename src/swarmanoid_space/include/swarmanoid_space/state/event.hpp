/// Events of a tick, with texts for recordings.
#pragma once

#include <cstdint>
#include <string>

#include "swarmanoid_space/state/entities.hpp"

namespace swarmanoid {

struct Event {
  enum class Kind {
    kAttached,          ///< `entity` grips `other`
    kReleased,          ///< `entity` let go of `other`
    kControllerFailed,  ///< the controller of `entity` threw or commanded a number that is not finite; the robot stops
    kLeftArena,  ///< the origin of `entity` has been outside the arena since this tick, or 0.1 m below its ground
    kOverflow,   ///< a sensor of `entity` saw more than it can report
    kSpawned,
    kDeleted,
    kMoved,         ///< teleported from outside
    kIntervention,  ///< any other intervention from outside
    kFinished,
    kHandedOver,           ///< another engine moves `entity` from now on; the text names it
    kHandoverRefused,      ///< a rule requested it, and `entity` stays in its engine; the text has the reason
    kEngineTrouble,        ///< an engine had to use a fallback for its method; the text has engine and details
    kParticipantLate,      ///< a process that commands robots has not answered in time; the text has the consequence
    kParticipantJoined,    ///< such a process has registered, or is back
    kAnswerRefused,        ///< such a process answered twice, or for a wrong tick; reported once
    kInterventionRefused,  ///< a rule requested it by InterventionQueue::tryTo; the text has the reason
    kFellIntoHole          ///< `entity` has been removed from the world in this tick; the text names the hole
  };

  Kind kind;
  std::string entity;
  std::string other;
  std::string text;
};

/// "attached", "released", ...
const char* toString(Event::Kind kind);

}  // namespace swarmanoid
