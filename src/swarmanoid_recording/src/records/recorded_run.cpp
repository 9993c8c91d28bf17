#include "swarmanoid_recording/records/recorded_run.hpp"

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <variant>

#include "content_hash.hpp"
#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_experiment_files/xml/xml_element.hpp"
#include "swarmanoid_interface/plain_text.hpp"
#include "swarmanoid_space/models/limits.hpp"

namespace swarmanoid {
namespace {

namespace fs = std::filesystem;
using experiment::XmlElement;

constexpr const char* kFormat = "1";

/// Reads a number of up to 64 bits, such as a seed.
std::uint64_t countOf(const XmlElement& element, const char* name) {
  const std::string text = element.requireAttribute(name);
  const bool is_whole = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
  try {
    if (is_whole) {
      return std::stoull(text);
    }
  } catch (const std::out_of_range&) {
    // too large: refused below like a text that is not a number
  }
  throw ConfigError(element.attributeLocation(name), std::string(name) + ": found '" + text +
                                                         "', allowed: a whole number from 0 to 18446744073709551615");
}

std::uint64_t ticksOf(const XmlElement& element, const char* name) {
  return static_cast<std::uint64_t>(
      parseInteger(element.requireAttribute(name), name, element.attributeLocation(name), limits::kTicks));
}

std::uint64_t hashOf(const XmlElement& element) {
  const std::string text = element.requireAttribute("hash");
  if (const auto hash = records::parseHash(text)) {
    return *hash;
  }
  throw ConfigError(element.attributeLocation("hash"), "hash: found '" + text + "', allowed: 16 hexadecimal digits");
}

/// Refuses pipes and devices: opening a pipe would block until a writer opens it.
void refuseSpecialFile(const std::string& file) {
  std::error_code ignored;
  if (fs::is_other(fs::status(file, ignored))) {
    throw ConfigError({file, 0}, "is a pipe or a device, allowed: a file");
  }
}

/// @throws ConfigError if the file does not exist, or has another hash
void checkFile(const XmlElement& element, const std::string& folder) {
  element.allowAttributes({"name", "hash"});
  const std::string name = element.requireAttribute("name");
  const fs::path path(name);
  if (path.is_absolute() || std::find(path.begin(), path.end(), "..") != path.end()) {
    throw ConfigError(element.attributeLocation("name"), "name: found '" + name + "', allowed: a file of the record");
  }
  const std::string file = (fs::path(folder) / path).string();
  refuseSpecialFile(file);
  const std::uint64_t hash = records::contentHash(experiment::textOf(file));
  if (const std::uint64_t expected = hashOf(element); hash != expected) {
    throw ConfigError({file, 0}, "found a content with the hash " + hashText(hash) +
                                     ", allowed: " + hashText(expected) + ", as it was recorded");
  }
}

RunRecord parseRecord(const std::string& text, const std::string& file, const std::string& folder) {
  if (text.empty()) {
    throw ConfigError({file, 0}, "found an empty file, allowed: a <run_record> element");
  }
  const XmlDocument document = parseXml(text, file, XmlNamespaces::kRefused);
  const XmlElement root(xmlDocGetRootElement(document.get()), &file);
  if (root.name() != "run_record") {
    root.refuse("found the root element <" + root.name() + ">, allowed: <run_record>");
  }
  if (const std::string format = root.requireAttribute("format"); format != kFormat) {
    throw ConfigError(root.attributeLocation("format"), "format: found '" + format + "', allowed: " + kFormat +
                                                            "; another version of the suite has written this record");
  }
  root.allowAttributes(
      {"format", "experiment", "seed", "maxclock", "every", "open", "version", "compiler", "math_library"});
  root.allowChildren({"file", "override", "library"});
  RunRecord record;
  record.experiment = root.requireAttribute("experiment");
  record.seed = countOf(root, "seed");
  record.max_clock = ticksOf(root, "maxclock");
  record.every = ticksOf(root, "every");
  record.is_open = parseBoolean(root.requireAttribute("open"), "open", root.attributeLocation("open"));
  record.version = root.requireAttribute("version");
  record.compiler = root.requireAttribute("compiler");
  record.math_library = root.requireAttribute("math_library");
  for (const XmlElement& element : root.children()) {
    if (element.name() == "file") {
      checkFile(element, folder);
      record.files.push_back({element.requireAttribute("name"), ""});
    } else if (element.name() == "override") {
      element.allowAttributes({"path", "value"});
      record.overrides.push_back({element.requireAttribute("path"), element.requireAttribute("value")});
    } else {
      element.allowAttributes({"name", "hash"});
      record.libraries.push_back({element.requireAttribute("name"), hashOf(element)});
    }
  }
  const auto is_experiment = [](const RecordedFile& each) { return each.name == record_files::kExperiment; };
  if (std::none_of(record.files.begin(), record.files.end(), is_experiment)) {
    root.refuse("found no <file name=\"" + std::string(record_files::kExperiment) + "\">, allowed: with it");
  }
  return record;
}

/// Reads one line of the file of hashes. @throws ConfigError
RecordedHash parseHashLine(const std::string& line, const SourceLocation& location) {
  const std::size_t space = line.find(' ');
  const std::string tick = line.substr(0, space);
  const auto hash = space == std::string::npos ? std::nullopt : records::parseHash(line.substr(space + 1));
  const bool is_tick = !tick.empty() && tick.size() <= 18 && tick.find_first_not_of("0123456789") == std::string::npos;
  if (!is_tick || !hash) {
    throw ConfigError(location, "found '" + line + "', allowed: a tick and its state hash of 16 hexadecimal digits");
  }
  return {std::stoull(tick), *hash};
}

/// Reads whole lines. @param rest gets the text after the last one
std::vector<RecordedHash> parseHashes(const std::string& text, const std::string& file, std::uint64_t every,
                                      std::string& rest) {
  std::vector<RecordedHash> hashes;
  std::size_t begin = 0;
  for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', begin)) {
    const SourceLocation location{file, static_cast<int>(hashes.size()) + 1};
    hashes.push_back(parseHashLine(text.substr(begin, end - begin), location));
    const std::uint64_t expected = every * (hashes.size() - 1);
    if (hashes.back().tick != expected) {
      throw ConfigError(location, "found tick " + std::to_string(hashes.back().tick) + ", allowed: tick " +
                                      std::to_string(expected) + " in this line");
    }
    begin = end + 1;
  }
  rest = text.substr(begin);
  return hashes;
}

std::string inFolder(const RecordedRun& run, const char* name) { return (fs::path(run.folder) / name).string(); }

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// Appends the end that a killed run has not written. @return whether it was missing
bool completeInterventions(std::string& text, const RunRecord& record) {
  const std::string end = interventionsEnd();
  if (endsWith(text, end)) {
    return false;
  }
  text = (text.empty() ? interventionsBegin(record.experiment, record.seed) : text) + end;
  return true;
}

/// Returns the robot that the intervention puts under the command of other processes, which may differ from the
/// experiment; null if there is none.
const std::string* commandedByOthers(const Intervention& intervention) {
  if (const auto* change = std::get_if<SetCommandSource>(&intervention)) {
    return isOfOthers(change->source) ? &change->robot : nullptr;
  }
  if (const auto* spawn = std::get_if<SpawnEntity>(&intervention)) {
    return isOfOthers(spawn->entity.source) ? &spawn->entity.id : nullptr;
  }
  return nullptr;
}

}  // namespace

RecordedRun readRecordedRun(const std::string& folder) {
  RecordedRun run;
  run.folder = folder;
  for (const char* name :
       {record_files::kRecord, record_files::kHashes, record_files::kInterventions, record_files::kResult}) {
    refuseSpecialFile(inFolder(run, name));
  }
  const std::string file = inFolder(run, record_files::kRecord);
  run.record = parseRecord(experiment::textOf(file), file, folder);
  std::error_code ignored;
  if (const std::string result = inFolder(run, record_files::kResult); fs::exists(result, ignored)) {
    run.result = experiment::textOf(result);
  }
  const std::string hashes = inFolder(run, record_files::kHashes);
  std::string rest;
  run.hashes = parseHashes(experiment::textOf(hashes), hashes, run.record.every, rest);
  if (run.hashes.empty() || (run.hasResult() && !rest.empty())) {
    throw ConfigError({hashes, static_cast<int>(run.hashes.size()) + 1},
                      "found '" + rest + "' at the end, allowed: whole lines, at least that of tick 0");
  }
  run.interventions = experiment::textOf(inFolder(run, record_files::kInterventions));
  const bool is_cut = completeInterventions(run.interventions, run.record);
  if (is_cut && run.hasResult()) {
    throw ConfigError({inFolder(run, record_files::kInterventions), 0},
                      "found no </interventions> at the end, allowed: a file that ends with it");
  }
  if (!run.hasResult()) {
    run.missing.push_back("the run has no result: it was killed, or is not over; what there is ends with tick " +
                          std::to_string(run.ticks()));
  }
  return run;
}

Experiment experimentOf(const RecordedRun& run) {
  Experiment experiment = readExperiment(inFolder(run, record_files::kExperiment));
  experiment.name = run.record.experiment;
  experiment.framework.seed = run.record.seed;
  experiment.framework.max_clock = run.record.max_clock;
  experiment.framework.location = {inFolder(run, record_files::kRecord), 0};
  return experiment;
}

InterventionFile interventionsOf(const RecordedRun& run, const Experiment& experiment) {
  return parseInterventions(run.interventions, inFolder(run, record_files::kInterventions), experiment);
}

InterventionFile withoutThoseOfRules(InterventionFile interventions, const Experiment& experiment) {
  const auto comes_again = [&](const RecordedIntervention& recorded) {
    return hasRule(experiment, recorded.taken.asked_by);
  };
  std::vector<RecordedIntervention>& all = interventions.interventions;
  all.erase(std::remove_if(all.begin(), all.end(), comes_again), all.end());
  return interventions;
}

std::vector<std::string> robotsOfOthers(const RecordedRun& run, const Experiment& experiment,
                                        const InterventionFile& interventions) {
  if (!run.record.is_open) {
    return {};
  }
  std::vector<std::string> robots = robotNames(experiment, CommandSource::kRemote);
  const std::vector<std::string> by_topics = robotNames(experiment, CommandSource::kTopics);
  robots.insert(robots.end(), by_topics.begin(), by_topics.end());
  for (const RecordedIntervention& recorded : interventions.interventions) {
    const std::string* robot = commandedByOthers(recorded.taken.what);
    if (robot != nullptr && std::find(robots.begin(), robots.end(), *robot) == robots.end()) {
      robots.push_back(*robot);
    }
  }
  return robots;
}

}  // namespace swarmanoid
