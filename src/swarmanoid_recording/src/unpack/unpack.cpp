#include "unpack.hpp"

#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <swarmanoid_msgs/Intervention.h>
#include <swarmanoid_msgs/RunRecord.h>
#include <swarmanoid_msgs/RunResult.h>
#include <swarmanoid_msgs/WorldState.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <vector>

#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/plain_text.hpp"

namespace swarmanoid::unpack {
namespace {

namespace fs = std::filesystem;

/// The data of one run in the bag.
struct Run {
  std::optional<swarmanoid_msgs::RunRecord> record;
  std::optional<swarmanoid_msgs::RunResult> result;
  std::map<std::uint64_t, std::uint64_t> hashes;  // by tick
  std::string interventions;
};
using Runs = std::map<std::uint64_t, Run>;

template <class Message>
bool isOf(const rosbag::MessageInstance& instance) {
  return instance.getDataType() == ros::message_traits::datatype<Message>();
}

template <class Message>
typename Message::ConstPtr read(const rosbag::MessageInstance& instance) {
  auto message = instance.instantiate<Message>();
  if (message == nullptr) {
    throw ConfigError({instance.getTopic(), 0}, "found " + instance.getDataType() + " (" + instance.getMD5Sum() +
                                                    "), allowed: " + ros::message_traits::datatype<Message>() + " (" +
                                                    ros::message_traits::md5sum<Message>() +
                                                    "); another version of the suite has recorded this bag");
  }
  return message;
}

void openBag(rosbag::Bag& bag, const std::string& file) {
  try {
    bag.open(file, rosbag::bagmode::Read);
  } catch (const rosbag::BagUnindexedException&) {
    throw ConfigError({file, 0},
                      "found a bag without its end, as a run that was killed leaves it, allowed: what "
                      "`rosbag reindex` makes of it");
  } catch (const rosbag::BagException& error) {
    throw ConfigError({file, 0}, std::string("cannot be read: ") + error.what());
  }
}

/// Refuses a bag of two spaces, which has two topics of one type.
void refuseSecondTopic(rosbag::View& view, const std::string& file) {
  std::map<std::string, std::set<std::string>> topics;  // by type
  for (const rosbag::ConnectionInfo* connection : view.getConnections()) {
    topics[connection->datatype].insert(connection->topic);
  }
  for (const auto& [type, names] : topics) {
    if (names.size() > 1) {
      throw ConfigError({file, 0}, "found " + type + " on " +
                                       joinNames(std::vector<std::string>(names.begin(), names.end())) +
                                       ", allowed: a bag of one space");
    }
  }
}

Runs readMessages(const std::string& file) {
  rosbag::Bag bag;
  openBag(bag, file);
  rosbag::View view(bag, rosbag::TypeQuery({ros::message_traits::datatype<swarmanoid_msgs::RunRecord>(),
                                            ros::message_traits::datatype<swarmanoid_msgs::RunResult>(),
                                            ros::message_traits::datatype<swarmanoid_msgs::WorldState>(),
                                            ros::message_traits::datatype<swarmanoid_msgs::Intervention>()}));
  refuseSecondTopic(view, file);
  Runs runs;
  for (const rosbag::MessageInstance& instance : view) {
    if (isOf<swarmanoid_msgs::RunRecord>(instance)) {
      const auto message = read<swarmanoid_msgs::RunRecord>(instance);
      runs[message->run].record = *message;
    } else if (isOf<swarmanoid_msgs::RunResult>(instance)) {
      const auto message = read<swarmanoid_msgs::RunResult>(instance);
      runs[message->run].result = *message;
    } else if (isOf<swarmanoid_msgs::WorldState>(instance)) {
      const auto message = read<swarmanoid_msgs::WorldState>(instance);
      runs[message->run].hashes[message->tick] = message->state_hash;
    } else {
      const auto message = read<swarmanoid_msgs::Intervention>(instance);
      runs[message->run].interventions += message->text;
    }
  }
  return runs;
}

/// Reads all runs. Damaged data may cause an error in any library; those do not know the file, so it is added here.
Runs readRuns(const std::string& file) {
  try {
    return readMessages(file);
  } catch (const ConfigError&) {
    throw;
  } catch (const std::exception& error) {
    throw ConfigError({file, 0}, std::string("found a damaged bag (") + error.what() + "), allowed: a whole one");
  }
}

bool hasTick(const Run& run) { return !run.hashes.empty() && run.hashes.rbegin()->first > 0; }

const Run& choose(const Runs& runs, const Choice& choice, const std::string& file) {
  if (choice.run) {
    const auto found = runs.find(*choice.run);
    if (found == runs.end()) {
      std::vector<std::string> numbers;
      for (const auto& [number, run] : runs) {
        numbers.push_back(std::to_string(number));
      }
      throw ConfigError({file, 0}, "found no run " + std::to_string(*choice.run) + ", allowed: " + joinNames(numbers));
    }
    return found->second;
  }
  for (auto run = runs.rbegin(); run != runs.rend(); ++run) {
    if (hasTick(run->second)) {
      return run->second;
    }
  }
  throw ConfigError({file, 0},
                    "found no run that made a tick, allowed: a bag of `swarmanoid run --bag`, or of the "
                    "space");
}

/// @throws ConfigError if the file cannot be written
void write(const std::string& folder, const std::string& name, const std::string& content) {
  const fs::path path = fs::path(folder) / name;
  std::error_code ignored;
  fs::create_directories(path.parent_path(), ignored);
  std::ofstream out(path, std::ios::binary);
  out.write(content.data(), static_cast<std::streamsize>(content.size()));
  out.close();
  if (!out) {
    throw ConfigError({path.string(), 0}, "cannot be written");
  }
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    result += c == '&' ? "&amp;" : (c == '<' ? "&lt;" : (c == '"' ? "&quot;" : std::string(1, c)));
  }
  return result;
}

/// The experiment and the seed of the interventions are known only for a run that has a result.
void writeInterventions(const Run& run, const std::string& folder) {
  const std::string where = run.result ? " experiment=\"" + escaped(run.result->experiment) + "\" seed=\"" +
                                             std::to_string(run.result->seed) + "\""
                                       : "";
  write(folder, "interventions.xml", "<interventions" + where + ">\n" + run.interventions + "</interventions>\n");
}

/// Refuses names that lead out of the folder, since a bag may come from an untrusted source.
void refuseOutside(const std::string& name, const std::string& file) {
  const fs::path path(name);
  if (name.empty() || path.is_absolute() || std::find(path.begin(), path.end(), "..") != path.end()) {
    throw ConfigError({file, 0}, "found a file '" + name + "' in the record, allowed: a name inside the record");
  }
}

std::string hashesOf(const Run& run) {
  std::string text;
  for (const auto& [tick, hash] : run.hashes) {
    text += std::to_string(tick) + " " + hashText(hash) + "\n";
  }
  return text;
}

/// Returns the members that the record's reader uses; the message has further ones.
std::string resultOf(const swarmanoid_msgs::RunResult& result) {
  PlainTextStream text;
  text << "{\"seed\":" << result.seed << ",\"ticks\":" << result.ticks
       << ",\"finished\":" << (result.finished ? "true" : "false") << "}\n";
  return text.str();
}

}  // namespace

void unpack(const std::string& bag, const std::string& folder, const Choice& choice) {
  const Runs runs = readRuns(bag);
  if (choice.only_interventions && runs.empty()) {
    throw ConfigError({bag, 0}, "found no state of a space and no interventions, allowed: a bag of one");
  }
  const Run& run = choose(runs, choice, bag);
  writeInterventions(run, folder);
  if (choice.only_interventions) {
    return;
  }
  if (!run.record) {
    throw ConfigError({bag, 0},
                      "found no record of the run, allowed: a bag that this version of the suite has "
                      "recorded");
  }
  for (const swarmanoid_msgs::RecordedFile& file : run.record->files) {
    refuseOutside(file.name, bag);
    write(folder, file.name, std::string(file.content.begin(), file.content.end()));
  }
  write(folder, "hashes.txt", hashesOf(run));
  if (run.result) {
    write(folder, "result.json", resultOf(*run.result));
  }
}

}  // namespace swarmanoid::unpack
