// `swarmanoid diff`: the first tick in which two recorded runs differ, and all fields that differ in it.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>

#include "bag_reader.hpp"
#include "compare.hpp"
#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/process/exit_code.hpp"

namespace swarmanoid::diff {
namespace {

struct Options {
  std::string first;
  std::string second;
  std::size_t most_fields = 20;
};

/// Returns the file itself if it is a bag, or the only bag in a folder.
std::string bagOf(const std::string& run) {
  namespace fs = std::filesystem;
  if (!fs::is_directory(run)) {
    return run;
  }
  std::vector<std::string> bags;
  for (const fs::directory_entry& file : fs::directory_iterator(run)) {
    if (file.path().extension() == ".bag") {
      bags.push_back(file.path().string());
    }
  }
  if (bags.size() != 1) {
    throw ConfigError({run, 0}, "found " + std::to_string(bags.size()) + " bags in this folder, allowed: one");
  }
  return bags.front();
}

std::string nameOf(const TickKey& key) {
  return (key.run == 0 ? "" : "run " + std::to_string(key.run) + ", ") +
         (key.finished_ticks == 0 ? "before the first tick" : "tick " + std::to_string(key.finished_ticks - 1));
}

void print(const TickKey& key, const std::vector<Difference>& differences, const Options& options) {
  std::cout << "first difference: " << nameOf(key) << '\n';
  for (std::size_t i = 0; i < std::min(differences.size(), options.most_fields); ++i) {
    std::cout << "  " << differences[i].field << ": " << differences[i].first << " | " << differences[i].second << '\n';
  }
  if (differences.size() > options.most_fields) {
    std::cout << "  and " << differences.size() - options.most_fields << " more fields\n";
  }
}

/// Counts the compared ticks, fields and bytes, for people.
struct Count {
  std::size_t ticks = 0;
  std::size_t fields = 0;  // fields of states
  std::size_t bytes = 0;   // bytes of readings and commands

  void add(const RecordedTick& tick) {
    ++ticks;
    fields += tick.state ? tick.state->names->size() : 0;
    for (const auto& [robot, frames] : tick.controllers) {
      bytes +=
          (frames.sensors ? frames.sensors->data.size() : 0) + (frames.commands ? frames.commands->data.size() : 0);
    }
  }
};

std::string describe(const Count& count, StateSource source) {
  return std::to_string(count.ticks) + " ticks, " + std::to_string(count.fields) + " fields of " +
         (source == StateSource::kNamedState ? "all named state" : "the world state") +
         (count.bytes == 0 ? "" : ", " + std::to_string(count.bytes) + " bytes of readings and commands");
}

void hint(StateSource source, bool has_frames) {
  if (source != StateSource::kNamedState || !has_frames) {
    std::cerr << "not compared: " << (source == StateSource::kNamedState ? "" : "joints, LEDs, attachments, properties")
              << (source == StateSource::kNamedState || has_frames ? "" : "; ")
              << (has_frames ? "" : "readings and commands")
              << "; record both runs with --record-state and --record-controllers all\n";
  }
}

ExitCode diff(const Options& options) {
  BagReader first(bagOf(options.first));
  BagReader second(bagOf(options.second));
  const StateSource source =
      first.hasNamedState() && second.hasNamedState() ? StateSource::kNamedState : StateSource::kWorldState;
  first.choose(source);
  second.choose(source);
  Count count;
  while (true) {
    const std::optional<RecordedTick> a = first.next();
    const std::optional<RecordedTick> b = second.next();
    if (!a && !b) {
      std::cout << "equal: " << describe(count, source) << '\n';
      hint(source, count.bytes > 0);
      return ExitCode::kFinished;
    }
    if (!a || !b || a->key < b->key || b->key < a->key) {
      const bool is_in_first = a && (!b || a->key < b->key);
      const TickKey& key = is_in_first ? a->key : b->key;
      std::cout << "first difference: " << nameOf(key) << " is in " << (is_in_first ? options.first : options.second)
                << " alone; before it all is equal\n";
      return ExitCode::kDiffers;
    }
    const std::vector<Difference> differences = compare({*a, first.robots()}, {*b, second.robots()});
    if (!differences.empty()) {
      print(a->key, differences, options);
      hint(source, count.bytes > 0 || !a->controllers.empty());
      return ExitCode::kDiffers;
    }
    count.add(*a);
  }
}

}  // namespace
}  // namespace swarmanoid::diff

int main(int argc, char** argv) {
  using namespace swarmanoid::diff;
  using swarmanoid::ExitCode;
  Options options;
  CLI::App app{"Names the first tick in which two recorded runs differ, and the fields that differ in it.",
               "swarmanoid diff"};
  app.footer("Exit code: 0 equal, 1 different, 2 bad input.");
  app.add_option("RUN1", options.first, "a bag, or a folder with one")->required();
  app.add_option("RUN2", options.second, "likewise")->required();
  app.add_option("--fields", options.most_fields, "how many of the fields that differ are named");
  try {
    app.parse(argc, argv);
    return toNumber(diff(options));
  } catch (const CLI::ParseError& error) {
    return toNumber(app.exit(error) == 0 ? ExitCode::kFinished : ExitCode::kBadInput);
  } catch (const std::exception& error) {
    std::cerr << "swarmanoid: " << error.what() << '\n';
    return toNumber(ExitCode::kBadInput);
  }
}
