// The program `swarmanoid`: experiments from the command line, without a ROS master.
#include <exception>
#include <iostream>
#include <utility>
#include <vector>

#include "commands.hpp"
#include "run_summary.hpp"
#include "swarmanoid_interface/configuration.hpp"

int main(int argc, char** argv) {
  using namespace swarmanoid::program;
  CLI::App app{"Runs experiments of the swarmanoid simulator.", "swarmanoid"};
  app.require_subcommand(1);
  std::vector<std::pair<CLI::App*, Command>> commands;
  for (const auto add : {addRunCommand, addLaunchCommand, addValidateCommand, addListCommand, addSchemaCommand}) {
    Command command = add(app);
    commands.emplace_back(app.get_subcommands({}).back(), std::move(command));
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const int code = app.exit(error);
    return code == 0 ? kFinished : kBadInput;
  }
  try {
    for (const auto& [subcommand, command] : commands) {
      if (subcommand->parsed()) {
        return command();
      }
    }
  } catch (const swarmanoid::ConfigError& error) {
    std::cerr << "swarmanoid: " << error.what() << '\n';
    return kBadInput;
  } catch (const std::exception& error) {
    std::cerr << "swarmanoid: " << error.what() << '\n';
    return kEngineStopped;
  }
  return kBadInput;
}
