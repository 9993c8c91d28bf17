#include "swarmanoid_recording/records/run_record.hpp"

#include <link.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "content_hash.hpp"
#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_experiment_files/recorded_text.hpp"
#include "swarmanoid_experiment_files/xml/element_text.hpp"
#include "swarmanoid_interface/plain_text.hpp"
#include "swarmanoid_interface/process/math_library.hpp"

namespace swarmanoid {
namespace {

namespace fs = std::filesystem;

/// Returns the names of libraries in the experiment.
std::set<std::string> namedLibraries(const Experiment& experiment) {
  std::set<std::string> names;
  for (const ControllerDescription& controller : experiment.controllers) {
    names.insert(controller.library);
    for (const auto* devices : {&controller.actuators, &controller.sensors}) {
      for (const DeviceDescription& device : *devices) {
        names.insert(device.library);
      }
    }
  }
  for (const auto* uses : {&experiment.engines, &experiment.rules, &experiment.visualisations}) {
    for (const PluginUse& use : *uses) {
      names.insert(use.library);
    }
  }
  names.erase("");
  return names;
}

/// Returns the files of all loaded libraries, by their names without folders.
std::map<std::string, std::string> loadedLibraries() {
  std::map<std::string, std::string> files;
  const auto add = [](dl_phdr_info* info, std::size_t, void* all) {
    const std::string file = info->dlpi_name;
    static_cast<std::map<std::string, std::string>*>(all)->emplace(fs::path(file).filename().string(), file);
    return 0;
  };
  dl_iterate_phdr(add, &files);
  return files;
}

std::vector<RecordedLibrary> librariesOf(const Experiment& experiment) {
  const std::map<std::string, std::string> loaded = loadedLibraries();
  std::map<std::string, std::uint64_t> hashes;  // by file, because two names may refer to one library
  for (const std::string& name : namedLibraries(experiment)) {
    const fs::path path(name);
    const auto found = loaded.find(path.extension() == ".so" ? path.filename().string() : "lib" + name + ".so");
    if (found != loaded.end()) {
      hashes.emplace(found->first, records::contentHash(experiment::textOf(found->second)));
    }
  }
  std::vector<RecordedLibrary> libraries;
  for (const auto& [name, hash] : hashes) {
    libraries.push_back({name, hash});
  }
  return libraries;
}

/// Returns new names in the order of the experiment's files, without the experiment file itself. A file that is listed
/// twice gets the same name twice.
std::vector<std::string> newNames(const Experiment& experiment) {
  std::vector<std::string> names;
  for (std::size_t i = 1; i < experiment.files.size(); ++i) {
    const auto first = std::find(experiment.files.begin() + 1, experiment.files.end(), experiment.files[i]);
    const auto number = first - experiment.files.begin();
    names.push_back(std::string(record_files::kNamedFiles) + "/" + std::to_string(number) + "_" +
                    fs::path(*first).filename().string());
  }
  return names;
}

void appendFile(ElementText& text, const std::string& name, const std::string& content) {
  text.begin("file");
  text.attribute("name", name);
  text.attribute("hash", hashText(records::contentHash(content)));
  text.end();
}

std::string listOf(const RunRecord& record) {
  ElementText text(0);
  text.begin("run_record");
  text.attribute("format", "1");
  text.attribute("experiment", record.experiment);
  text.attribute("seed", std::to_string(record.seed));
  text.attribute("maxclock", std::to_string(record.max_clock));
  text.attribute("every", std::to_string(record.every));
  text.attribute("open", record.is_open ? "true" : "false");
  text.attribute("version", record.version);
  text.attribute("compiler", record.compiler);
  text.attribute("math_library", record.math_library);
  appendFile(text, record_files::kExperiment, record.text);
  for (const RecordedFile& file : record.files) {
    appendFile(text, file.name, file.content);
  }
  for (const Override& override : record.overrides) {
    text.begin("override");
    text.attribute("path", override.path);
    text.attribute("value", override.value);
    text.end();
  }
  for (const RecordedLibrary& library : record.libraries) {
    text.begin("library");
    text.attribute("name", library.name);
    text.attribute("hash", hashText(library.hash));
    text.end();
  }
  text.end();
  return text.text();
}

}  // namespace

RunRecord recordOf(const Experiment& experiment, const std::string& version) {
  RunRecord record;
  record.experiment = experiment.name;
  const std::vector<std::string> names = newNames(experiment);
  record.text = experiment::recordedText(experiment, names);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const bool is_new = std::none_of(record.files.begin(), record.files.end(),
                                     [&](const RecordedFile& file) { return file.name == names[i]; });
    if (is_new) {
      record.files.push_back({names[i], experiment::textOf(experiment.files[i + 1])});
    }
  }
  record.libraries = librariesOf(experiment);
  record.overrides = experiment.overrides;
  record.seed = experiment.framework.seed;
  record.max_clock = experiment.framework.max_clock;
  record.version = version;
  record.compiler = std::string("g++ ") + __VERSION__;
  record.math_library = mathLibrary();
  return record;
}

std::vector<RecordedFile> documentsOf(const RunRecord& record) {
  std::vector<RecordedFile> documents{{record_files::kRecord, listOf(record)},
                                      {record_files::kExperiment, record.text}};
  documents.insert(documents.end(), record.files.begin(), record.files.end());
  return documents;
}

std::vector<std::string> differences(const RunRecord& recorded, const RunRecord& here) {
  std::vector<std::string> sentences;
  const auto compare = [&](const char* what, const std::string& then, const std::string& now) {
    if (then != now) {
      sentences.push_back("recorded with " + std::string(what) + " " + then + ", made again with " + now);
    }
  };
  compare("the version", recorded.version, here.version);
  compare("the compiler", recorded.compiler, here.compiler);
  compare("the library of mathematics", recorded.math_library, here.math_library);
  for (const RecordedLibrary& library : recorded.libraries) {
    const auto found = std::find_if(here.libraries.begin(), here.libraries.end(),
                                    [&](const RecordedLibrary& other) { return other.name == library.name; });
    if (found == here.libraries.end()) {
      sentences.push_back("recorded with the library " + library.name + ", made again without it");
    } else if (found->hash != library.hash) {
      sentences.push_back("recorded with another " + library.name + ": its hash was " + hashText(library.hash) +
                          ", and is " + hashText(found->hash));
    }
  }
  return sentences;
}

}  // namespace swarmanoid
