/// The ingredients of a run, so that it can be repeated where only the suite is installed: the experiment's text with
/// its overrides applied, the files that it names, seed and length, versions of the software.
/// docs/reference/run_record.md has the layout of a record's folder.
///
/// A record also contains what happened: interventions, the state hash of each tick, the result.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "swarmanoid_space/experiment/experiment.hpp"

namespace swarmanoid {

/// A file of a record. Names are relative to the record's folder.
struct RecordedFile {
  std::string name;
  std::string content;
};

/// A library that the experiment names. The record contains only its hash.
struct RecordedLibrary {
  std::string name;        ///< of the file, without folders
  std::uint64_t hash = 0;  ///< XXH3 of its contents
};

struct RunRecord {
  std::string experiment;           ///< its name
  std::string text;                 ///< XML; names of files are those of the record
  std::vector<RecordedFile> files;  ///< named by the text, in "files"
  std::vector<RecordedLibrary> libraries;
  std::vector<Override> overrides;  ///< already applied to the text
  std::uint64_t seed = 1;
  std::uint64_t max_clock = 0;  ///< [ticks]
  std::uint64_t every = 1;      ///< ticks from one recorded state hash to the next
  std::string version;          ///< of the suite, with the commit
  std::string compiler;
  std::string math_library;
  bool is_open = false;  ///< other processes could command robots, and their commands are not in the record
};

/// The names of a record's files, in addition to those that the experiment names.
namespace record_files {
constexpr const char* kRecord = "record.xml";
constexpr const char* kExperiment = "experiment.xml";
constexpr const char* kInterventions = "interventions.xml";
constexpr const char* kHashes = "hashes.txt";
constexpr const char* kResult = "result.json";
constexpr const char* kNamedFiles = "files";  ///< the folder of the others
}  // namespace record_files

/// Call it after the experiment has loaded its libraries. @param version of the suite
/// @throws ConfigError if a file cannot be read any more
RunRecord recordOf(const Experiment& experiment, const std::string& version);

/// The files of the record that do not change during the run: the list of files and numbers, the experiment, the files
/// that it names.
std::vector<RecordedFile> documentsOf(const RunRecord& record);

/// Possible causes of differences from the recorded run, in sentences: another version, compiler, mathematical library,
/// or other plugin libraries. @param here record of the same run in this process
std::vector<std::string> differences(const RunRecord& recorded, const RunRecord& here);

}  // namespace swarmanoid
