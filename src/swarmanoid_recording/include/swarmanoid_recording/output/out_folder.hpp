/// The rules for files that a run writes. A run must not write a file that it reads, a file twice, a file through a
/// link, or an existing file unless replacement is allowed. Files that the experiment file names must be in the folder
/// of the run.
///
/// A run that does not begin leaves nothing behind: folders and files that were made for it are removed.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <map>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_recording/output/out_descriptor.hpp"

namespace swarmanoid {

class OutFolder {
 public:
  struct Rules {
    bool anywhere = false;  ///< files that the experiment file names may be outside the folder
    bool replace = false;   ///< existing files may be replaced
  };

  /// The author of a request for a file.
  struct Writer {
    std::string name;                ///< for messages: "--bag", "text_render 'table'"
    SourceLocation location;         ///< in the experiment file
    bool is_in_experiment = true;    ///< false: a user names the file, and may name any
    const char* parameter = "file";  ///< parameter of the experiment file that names it, for messages
  };

  /// The current folder; files may be anywhere, and are replaced. For code that needs no protection.
  OutFolder() : OutFolder("", "--", {true, true}) {}
  /// @param folder created if missing; empty: the current one
  /// @param prefix of options, for messages: "--", "~"
  /// @throws ConfigError if it cannot be made
  OutFolder(const std::string& folder, const std::string& prefix, Rules rules);
  ~OutFolder();
  OutFolder(const OutFolder&) = delete;
  OutFolder& operator=(const OutFolder&) = delete;

  /// Marks a file as read by the run.
  void protect(const std::string& file);
  /// Marks the files that the run needs: the program and all libraries loaded so far.
  void protectLoadedLibraries();

  /// Opens a file for one writer. An existing file keeps its contents until the writer truncates it.
  /// @param name relative to the folder
  /// @throws ConfigError if it may not or cannot be written
  OutDescriptor open(const std::string& name, const Writer& writer);

  /// Announces that the writer will make files by `writeWhole` during the run, with names of `begin`, a number, `end`.
  /// @throws ConfigError as `open`, for the first name and for any existing file, and if another writer did the same
  void promiseSeries(const std::string& begin, const std::string& end, const Writer& writer);
  /// Writes such a file completely or not at all, even if this process is killed.
  /// @throws ConfigError if the file has appeared meanwhile and may not be replaced; std::runtime_error with writer,
  /// file and reason, such as a full disk
  void writeWhole(const std::string& name, const Writer& writer, const std::vector<char>& content);

  /// Makes a folder and its missing parents; an existing folder is accepted.
  /// @param name relative to the folder of the run @throws ConfigError if it may not or cannot be made
  void makeFolder(const std::string& name, const Writer& writer);

  /// Called when the run begins: folder and files are kept from now on.
  void keep();

 private:
  using Identity = std::pair<dev_t, ino_t>;  // identifies a file, whatever its names

  std::error_code make(const std::filesystem::path& folder);
  std::filesystem::path at(const std::filesystem::path& path) const { return start_ / path; }
  std::filesystem::path placeOf(const std::string& name, const Writer& writer) const;
  bool mayReplace(const std::filesystem::path& path, const std::string& name, const Writer& writer) const;
  [[noreturn]] static void refuse(const Writer& writer, const std::string& name, const std::string& problem);
  [[noreturn]] static void fail(const Writer& writer, const std::string& text);
  std::string option(const std::string& first, const std::string& second = "") const;

  std::filesystem::path start_;  // the current folder at construction; users' code may change it later
  std::filesystem::path folder_;
  std::string prefix_ = "--";
  Rules rules_;
  std::map<Identity, std::string> taken_;                  // name of the writer; "": read by this run
  std::map<std::filesystem::path, std::string> promised_;  // name of the writer
  std::vector<std::filesystem::path> made_files_;
  std::vector<std::filesystem::path> made_folders_;  // innermost first
};

}  // namespace swarmanoid
