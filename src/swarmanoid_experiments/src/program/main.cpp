// The program `swarmanoid`: experiments from the command line, without a ROS master.
#include <exception>
#include <iostream>
#include <new>
#include <sstream>
#include <utility>
#include <vector>

#include "commands.hpp"
#include "commands/external_command.hpp"
#include "output/standard_output.hpp"
#include "processes/recording_program.hpp"
#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/process/last_seconds.hpp"
#include "swarmanoid_interface/process/math_library.hpp"
#include "swarmanoid_interface/process/user_code.hpp"
#include "swarmanoid_space/suite_version.hpp"

namespace swarmanoid::program {
namespace {

bool hasCommand(CLI::App& app, const std::string& name) {
  return !app.get_subcommands([&](CLI::App* command) { return command->get_name() == name; }).empty();
}

/// Replaces this process by another package's command if the first argument names one; else adds all of them, for
/// --help.
void addExternalCommands(CLI::App& app, int argc, char** argv) {
  const std::string name = argc > 1 ? argv[1] : "";
  if (hasCommand(app, name)) {
    return;
  }
  for (const ExternalCommand& command : externalCommands()) {
    if (command.name == name) {
      becomeExternalCommand(command, {argv + 2, argv + argc});
    }
    if (!hasCommand(app, command.name)) {
      app.add_subcommand(command.name, command.summary.empty() ? command.program : command.summary);
    }
  }
}

ExitCode call(int argc, char** argv) {
  CLI::App app{"Runs experiments of the swarmanoid simulator.", "swarmanoid"};
  app.require_subcommand(1);
  app.set_version_flag("--version", "swarmanoid " + suiteVersion());
  std::vector<std::pair<CLI::App*, Command>> commands;
  for (const auto add :
       {addRunCommand, addRerunCommand, addLaunchCommand, addDiffCommand, addValidateCommand, addListCommand,
        addDescribeCommand, addCheckRobotCommand, addSampleCommand, addSchemaCommand}) {
    Command command = add(app);
    commands.emplace_back(app.get_subcommands({}).back(), std::move(command));
  }
  addExternalCommands(app, argc, argv);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::ostringstream help;
    const int code = app.exit(error, help, std::cerr);
    print(help.str());
    return code == 0 ? ExitCode::kFinished : ExitCode::kBadInput;
  }
  for (const auto& [subcommand, command] : commands) {
    if (subcommand->parsed()) {
      return command();
    }
  }
  return ExitCode::kBadInput;
}

ExitCode callSafely(int argc, char** argv) {
  const bool is_output_open = fillStandardStreams();
  try {
    if (!is_output_open) {
      throw ConfigError({"standard output", 0}, "found it closed, allowed: a file, a pipe or /dev/null");
    }
    return call(argc, argv);
  } catch (const RecordingProgramFailed& failed) {
    return failed.code;
  } catch (const ConfigError& error) {
    std::cerr << "swarmanoid: " << error.what() << '\n';
    return ExitCode::kBadInput;
  } catch (const std::bad_alloc&) {
    std::cerr << "swarmanoid: found no memory left, allowed: fewer entities, or a machine with more\n";
    return ExitCode::kStopped;
  } catch (const std::exception& error) {
    std::cerr << "swarmanoid: " << error.what() << '\n';
    return ExitCode::kStopped;
  } catch (...) {
    std::cerr << "swarmanoid: " << describeException() << '\n';
    return ExitCode::kStopped;
  }
}

}  // namespace
}  // namespace swarmanoid::program

int main(int argc, char** argv) {
  swarmanoid::fixMathLibrary(argv);
  const swarmanoid::ExitCode code = swarmanoid::program::callSafely(argc, argv);
  swarmanoid::endWithinSeconds(code);
  return toNumber(code);
}
