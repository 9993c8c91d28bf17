// Names of command sources, in files and services.
#include "swarmanoid_space/experiment/experiment.hpp"

namespace swarmanoid {

const char* toString(CommandSource source) {
  switch (source) {
    case CommandSource::kController:
      return "controller";
    case CommandSource::kRemote:
      return "remote";
    case CommandSource::kTopics:
      return "topics";
    case CommandSource::kNone:
      return "none";
  }
  return "";
}

std::optional<CommandSource> parseCommandSource(const std::string& text) {
  for (const CommandSource source :
       {CommandSource::kController, CommandSource::kRemote, CommandSource::kTopics, CommandSource::kNone}) {
    if (text == toString(source)) {
      return source;
    }
  }
  return std::nullopt;
}

}  // namespace swarmanoid
