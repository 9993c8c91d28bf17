/// Which files a run may write, and where: nothing that the run reads, nothing twice, nothing through a link, nothing
/// that is there already unless that is wanted, and what the experiment file names only in the folder of the run.
///
/// A run that does not begin leaves nothing behind: folders and files that were made for it go again.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <map>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_space/output/out_descriptor.hpp"

namespace swarmanoid {

class OutFolder {
 public:
  struct Rules {
    bool anywhere = false;  ///< what the experiment file names may be outside the folder
    bool replace = false;   ///< files that are there already are written anew
  };

  /// Who asks for a file.
  struct Writer {
    std::string name;                ///< for messages: "--bag", "text_render 'table'"
    SourceLocation location;         ///< in the experiment file
    bool is_in_experiment = true;    ///< false: a user names the file, who may name any
    const char* parameter = "file";  ///< of the experiment file that names it, for messages
  };

  /// The current folder; files may be anywhere, and are replaced: for code that knows what it does.
  OutFolder() : OutFolder("", "--", {true, true}) {}
  /// @param folder made if it is not there; empty: the current one
  /// @param prefix of options, for messages: "--", "~"
  /// @throws ConfigError if it cannot be made
  OutFolder(const std::string& folder, const std::string& prefix, Rules rules);
  ~OutFolder();
  OutFolder(const OutFolder&) = delete;
  OutFolder& operator=(const OutFolder&) = delete;

  /// The run reads this file.
  void protect(const std::string& file);
  /// The run needs these files: the program and all libraries that are loaded by now.
  void protectLoadedLibraries();

  /// Opens a file for one writer. What a file that is replaced holds stays in it until the writer truncates it.
  /// @param name relative to the folder
  /// @throws ConfigError if it may not or cannot be written
  OutDescriptor open(const std::string& name, const Writer& writer);

  /// Says that the writer will make files while the run goes on, by `writeWhole`: their names are `begin`, a number,
  /// `end`. @throws ConfigError as `open`, for the first and for any that is there, and if another writer has said so
  void promiseSeries(const std::string& begin, const std::string& end, const Writer& writer);
  /// Writes such a file, as a whole or not at all, whoever ends this process.
  /// @throws ConfigError if it has come meanwhile and may not be replaced; std::runtime_error that names writer, file
  /// and reason, such as a full disk
  void writeWhole(const std::string& name, const Writer& writer, const std::vector<char>& content);

  /// Makes a folder, with all that lead to it; one that is there already is as good.
  /// @param name relative to the folder of the run @throws ConfigError if it may not or cannot be made
  void makeFolder(const std::string& name, const Writer& writer);

  /// The run begins: from here on folder and files stay.
  void keep();

 private:
  using Identity = std::pair<dev_t, ino_t>;  // a file has one, however many names

  std::error_code make(const std::filesystem::path& folder);
  std::filesystem::path at(const std::filesystem::path& path) const { return start_ / path; }
  std::filesystem::path placeOf(const std::string& name, const Writer& writer) const;
  bool mayReplace(const std::filesystem::path& path, const std::string& name, const Writer& writer) const;
  [[noreturn]] static void refuse(const Writer& writer, const std::string& name, const std::string& problem);
  [[noreturn]] static void fail(const Writer& writer, const std::string& text);
  std::string option(const std::string& first, const std::string& second = "") const;

  std::filesystem::path start_;  // the current folder when this was made: users' code may go to another one
  std::filesystem::path folder_;
  std::string prefix_ = "--";
  Rules rules_;
  std::map<Identity, std::string> taken_;                  // by whom; "" is this run, which reads it
  std::map<std::filesystem::path, std::string> promised_;  // to whom
  std::vector<std::filesystem::path> made_files_;
  std::vector<std::filesystem::path> made_folders_;  // the innermost first
};

}  // namespace swarmanoid
