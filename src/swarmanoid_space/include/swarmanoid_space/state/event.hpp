/// What happened in a tick, in words that a recording can tell the story with.
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
    kLeftArena,         ///< the origin of `entity` is outside the arena since this tick, or 0.1 m below its ground
    kOverflow,          ///< a sensor of `entity` saw more than it can report
    kSpawned,
    kDeleted,
    kMoved,         ///< put elsewhere from outside
    kIntervention,  ///< anything else that came from outside
    kFinished,
    kHandedOver,       ///< another engine moves `entity` from now on; the text says which
    kHandoverRefused,  ///< a rule asked for it, and `entity` stays where it is; the text says why
    kEngineTrouble,    ///< an engine had to make do with something worse than its method; the text says which and what
    kParticipantLate,  ///< a process that commands robots has not answered in time; the text says what follows
    kParticipantJoined,    ///< one has registered, or is back
    kAnswerRefused,        ///< one answered twice, or for a wrong tick; the first time
    kInterventionRefused,  ///< a rule asked for what may be refused, and was; the text says why
    kFellIntoHole          ///< `entity` is out of the world since this tick; the text names the hole
  };

  Kind kind;
  std::string entity;
  std::string other;
  std::string text;
};

/// "attached", "released", ...
const char* toString(Event::Kind kind);

}  // namespace swarmanoid
