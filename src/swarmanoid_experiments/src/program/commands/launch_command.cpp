// `swarmanoid launch`: runs roslaunch with the launch file of experiments, and returns the exit code of the run, which
// roslaunch by itself does not return.
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <stdexcept>

#include "../commands.hpp"
#include "swarmanoid_experiment_files/experiment_lookup.hpp"
#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/process/temporary_folder.hpp"

namespace swarmanoid::program {
namespace {

volatile std::sig_atomic_t is_asked_to_end = 0;
volatile std::sig_atomic_t had_result = 0;  // whether the result existed when the first signal came
volatile std::sig_atomic_t roslaunch_pid = 0;
std::string result_file;  // constant once the signal handlers are installed

/// Forwards a signal from another process to roslaunch; Ctrl-C in a terminal reaches roslaunch directly.
void passOn(int signal, siginfo_t* sender, void*) {
  if (is_asked_to_end == 0) {
    had_result = access(result_file.c_str(), F_OK) == 0 ? 1 : 0;
  }
  is_asked_to_end = 1;
  if (sender->si_code <= 0 && roslaunch_pid > 0) {
    kill(static_cast<pid_t>(roslaunch_pid), signal);
  }
}

/// @return the exit code of roslaunch; nothing if a signal ended it
std::optional<int> runRoslaunch(const std::vector<std::string>& arguments) {
  std::vector<char*> words;
  for (const std::string& argument : arguments) {
    words.push_back(const_cast<char*>(argument.c_str()));  // execvp changes nothing, but its type lacks the const
  }
  words.push_back(nullptr);
  struct sigaction action {};
  action.sa_sigaction = passOn;
  action.sa_flags = SA_SIGINFO | SA_RESTART;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    sigaction(signal, &action, nullptr);
  }
  const pid_t child = fork();
  if (child < 0) {
    throw std::runtime_error(std::string("cannot start roslaunch: ") + std::strerror(errno));
  }
  if (child == 0) {
    execvp(words[0], words.data());
    std::cerr << "swarmanoid: cannot start roslaunch: " << std::strerror(errno) << std::endl;
    _exit(toNumber(ExitCode::kBadInput));
  }
  roslaunch_pid = child;
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) {
      throw std::runtime_error(std::string("lost roslaunch: ") + std::strerror(errno));
    }
  }
  roslaunch_pid = 0;
  return WIFEXITED(status) ? std::optional<int>(WEXITSTATUS(status)) : std::nullopt;
}

/// Returns the code that the run wrote, or else the one derived from roslaunch.
ExitCode exitCode(const std::filesystem::path& file, std::optional<int> of_roslaunch) {
  int number = 0;
  if (std::ifstream(file) >> number) {
    const auto code = static_cast<ExitCode>(number);
    // roslaunch ends its nodes one by one: the space may have been unloaded before ROS shut down
    const bool is_interrupted = code == ExitCode::kStopped && is_asked_to_end != 0 && had_result == 0;
    return is_interrupted ? ExitCode::kInterrupted : code;
  }
  if (is_asked_to_end != 0) {
    return ExitCode::kInterrupted;
  }
  if (of_roslaunch.value_or(0) != 0) {
    return ExitCode::kBadInput;  // roslaunch has refused to start, and has reported the reason
  }
  std::cerr << "swarmanoid: the run has ended without a result\n";
  return ExitCode::kStopped;
}

/// Sets the host name in the environment: roslaunch runs the master itself, with its own environment, independent of
/// the settings for nodes in a launch file.
void nameThisHost(const std::vector<std::string>& arguments) {
  const std::string option = "hostname:=";
  for (const std::string& argument : arguments) {
    if (argument.rfind(option, 0) == 0 && argument.size() > option.size()) {
      setenv("ROS_HOSTNAME", argument.substr(option.size()).c_str(), 1);
    }
  }
  if (std::getenv("ROS_IP") == nullptr) {
    setenv("ROS_HOSTNAME", "localhost", 0);
  }
}

ExitCode launch(const std::string& experiment, const std::vector<std::string>& others) {
  for (const std::string& argument : others) {
    for (const char* own : {"exit_code:=", "experiment:="}) {
      if (argument.rfind(own, 0) == 0) {
        throw ConfigError({"launch", 0}, "found '" + argument + "', allowed: arguments of run.launch other than " +
                                             "experiment and exit_code, and options of roslaunch");
      }
    }
  }
  findExperiment(experiment);  // roslaunch would hide a mistyped name, and replace an empty one by its default
  const TemporaryFolder folder("launch");
  const std::filesystem::path file = std::filesystem::absolute(folder.path() / "exit_code");
  // not a ROS parameter: other users of the master could make it name files of this user
  setenv("SWARMANOID_EXIT_CODE", file.c_str(), 1);
  result_file = file;
  nameThisHost(others);
  std::vector<std::string> arguments{"roslaunch", "swarmanoid_experiments", "run.launch", "experiment:=" + experiment};
  arguments.insert(arguments.end(), others.begin(), others.end());
  return exitCode(file, runRoslaunch(arguments));
}

}  // namespace

Command addLaunchCommand(CLI::App& app) {
  auto experiment = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("launch", "run an experiment under ROS, with the exit code of the run");
  command->add_option("experiment", *experiment, "an experiment file, or the name of an installed experiment")
      ->required();
  command->prefix_command();
  command->footer(
      "What follows the experiment goes on to roslaunch: arguments of run.launch such as seed:=3 (it has "
      "them all: roslaunch --ros-args swarmanoid_experiments run.launch), and roslaunch's own options.");
  return [experiment, command] { return launch(*experiment, command->remaining()); };
}

}  // namespace swarmanoid::program
