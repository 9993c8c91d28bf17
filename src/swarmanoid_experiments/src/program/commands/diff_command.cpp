// `swarmanoid diff`. Another program reads the bags with ROS's library.
#include "../commands.hpp"
#include "../processes/recording_program.hpp"

namespace swarmanoid::program {

Command addDiffCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand("diff", "say in which tick and fields two recorded runs differ");
  command->prefix_command();
  command->set_help_flag();
  return [command]() -> ExitCode { becomeRecordingProgram("diff", command->remaining()); };
}

}  // namespace swarmanoid::program
