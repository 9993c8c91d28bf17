// Extracts the record of a run from its bag, for `swarmanoid rerun` and `swarmanoid run --interventions`.
#include <CLI/CLI.hpp>
#include <iostream>

#include "swarmanoid_interface/process/exit_code.hpp"
#include "unpack.hpp"

int main(int argc, char** argv) {
  using swarmanoid::ExitCode;
  std::string bag;
  std::string folder;
  swarmanoid::unpack::Choice choice;
  CLI::App app{"Makes the record of a run of what is in its bag.", "unpack"};
  app.add_option("BAG", bag, "of `swarmanoid run --bag`, or of the space")->required();
  app.add_option("FOLDER", folder, "where the record goes")->required();
  app.add_option("--run", choice.run, "which run, as resets count them; else the last one that made a tick");
  app.add_flag("--interventions", choice.only_interventions, "only what was done to the run");
  try {
    app.parse(argc, argv);
    swarmanoid::unpack::unpack(bag, folder, choice);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? toNumber(ExitCode::kFinished) : toNumber(ExitCode::kBadInput);
  } catch (const std::exception& error) {
    std::cerr << "swarmanoid: " << error.what() << '\n';
    return toNumber(ExitCode::kBadInput);
  }
  return toNumber(ExitCode::kFinished);
}
