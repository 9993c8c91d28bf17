/// What a run was made of, so that it can be made again where nothing but the suite is: the experiment's text with what
/// overrides have changed, the files that it names, seed and length, who has built what. docs/reference/run_record.md
/// has the layout of a record's folder.
///
/// Beside it a record has what happened: interventions, the state hash of each tick, the result.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "swarmanoid_space/experiment_file/experiment.hpp"

namespace swarmanoid {

/// A file of a record. Names are relative to its folder.
struct RecordedFile {
  std::string name;
  std::string content;
};

/// A library that the experiment names. It is not in the record, its hash is.
struct RecordedLibrary {
  std::string name;        ///< of the file, without folders
  std::uint64_t hash = 0;  ///< XXH3 of what was in it
};

struct RunRecord {
  std::string experiment;           ///< its name
  std::string text;                 ///< XML; names of files are those of the record
  std::vector<RecordedFile> files;  ///< that the text names, in "files"
  std::vector<RecordedLibrary> libraries;
  std::vector<Override> overrides;  ///< that the text has in it
  std::uint64_t seed = 1;
  std::uint64_t max_clock = 0;  ///< [ticks]
  std::uint64_t every = 1;      ///< ticks from one recorded state hash to the next
  std::string version;          ///< of the suite, with the commit
  std::string compiler;
  std::string math_library;
  bool is_open = false;  ///< other processes could command robots, and what they commanded is not in the record
};

/// The names of a record's files, beside those that the experiment names.
namespace record_files {
constexpr const char* kRecord = "record.xml";
constexpr const char* kExperiment = "experiment.xml";
constexpr const char* kInterventions = "interventions.xml";
constexpr const char* kHashes = "hashes.txt";
constexpr const char* kResult = "result.json";
constexpr const char* kNamedFiles = "files";  ///< the folder of the others
}  // namespace record_files

/// To be asked for when the experiment has loaded its libraries. @param version of the suite
/// @throws ConfigError if a file cannot be read any more
RunRecord recordOf(const Experiment& experiment, const std::string& version);

/// The files of the record that do not change while the run is made: the list of them and of all numbers, the
/// experiment, the files that it names.
std::vector<RecordedFile> documentsOf(const RunRecord& record);

/// What may make a run differ from the recorded one, in sentences: another version, compiler, library of mathematics,
/// or other libraries. @param here what the same run would be made of in this process
std::vector<std::string> differences(const RunRecord& recorded, const RunRecord& here);

}  // namespace swarmanoid
