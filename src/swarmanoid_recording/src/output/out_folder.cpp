#include "swarmanoid_recording/output/out_folder.hpp"

#include <fcntl.h>
#include <link.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "swarmanoid_recording/output/inside_folder.hpp"

namespace swarmanoid {

namespace fs = std::filesystem;

namespace {

/// Replaces the descriptor of a file if it is that of a standard stream, which users' code may have closed: everything
/// printed would be written to the file. @param descriptor of a file, or negative @return the new descriptor, or the
/// same
int besideStandardStreams(int descriptor) {
  if (descriptor < 0 || descriptor > STDERR_FILENO) {
    return descriptor;
  }
  const int moved = fcntl(descriptor, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  const int reason = errno;
  // occupies the number, so that no other file gets it
  const int nothing = open("/dev/null", O_RDWR | O_CLOEXEC);
  dup2(nothing, descriptor);
  close(nothing);
  errno = reason;
  return moved;
}

/// Returns whether a name is `begin`, digits, `end`.
bool isOfSeries(const std::string& name, const std::string& begin, const std::string& end) {
  if (name.size() <= begin.size() + end.size() || name.compare(0, begin.size(), begin) != 0 ||
      name.compare(name.size() - end.size(), end.size(), end) != 0) {
    return false;
  }
  return std::all_of(name.begin() + static_cast<std::ptrdiff_t>(begin.size()),
                     name.end() - static_cast<std::ptrdiff_t>(end.size()),
                     [](char letter) { return letter >= '0' && letter <= '9'; });
}

}  // namespace

OutFolder::OutFolder(const std::string& folder, const std::string& prefix, Rules rules)
    : start_(realPath("")), folder_(folder), prefix_(prefix), rules_(rules) {
  if (folder.empty()) {
    return;
  }
  if (const std::error_code problem = make(folder)) {
    throw ConfigError({prefix + "out", 0}, "cannot make the folder '" + folder + "': " + problem.message());
  }
}

/// Creates the folder and its missing parents, and remembers which ones it created.
std::error_code OutFolder::make(const fs::path& folder) {
  std::error_code problem;
  std::vector<fs::path> made;
  fs::path missing = at(folder).lexically_normal();
  while (!problem && !missing.empty() && !fs::exists(missing, problem) && missing != missing.parent_path()) {
    made.push_back(missing);
    missing = missing.parent_path();
  }
  made_folders_.insert(made_folders_.begin(), made.begin(), made.end());
  problem.clear();
  fs::create_directories(at(folder), problem);
  if (!problem && !fs::is_directory(at(folder))) {
    problem = std::make_error_code(std::errc::not_a_directory);
  }
  return problem;
}

void OutFolder::makeFolder(const std::string& name, const Writer& writer) {
  if (name.empty()) {
    refuse(writer, name, "allowed: a folder");
  }
  if (writer.is_in_experiment && !rules_.anywhere && !isInside(at(folder_ / name), at(folder_))) {
    refuse(writer, name,
           "allowed: a folder in " + realPath(at(folder_)).string() + ", or " + option("write", "anywhere"));
  }
  if (const std::error_code problem = make(folder_ / name)) {
    fail(writer, "cannot make the folder '" + name + "': " + problem.message());
  }
}

OutFolder::~OutFolder() {
  std::error_code ignored;
  for (const fs::path& file : made_files_) {
    fs::remove(file, ignored);
  }
  for (const fs::path& folder : made_folders_) {
    fs::remove(folder, ignored);  // fails if the folder is no longer empty
  }
}

void OutFolder::keep() {
  made_files_.clear();
  made_folders_.clear();
}

void OutFolder::protect(const std::string& file) {
  struct stat found {};
  if (stat(file.c_str(), &found) == 0) {
    taken_.emplace(Identity{found.st_dev, found.st_ino}, "");
  }
}

void OutFolder::protectLoadedLibraries() {
  protect("/proc/self/exe");
  const auto protectOne = [](dl_phdr_info* info, std::size_t, void* self) {
    static_cast<OutFolder*>(self)->protect(info->dlpi_name);
    return 0;
  };
  dl_iterate_phdr(protectOne, this);
}

void OutFolder::refuse(const Writer& writer, const std::string& name, const std::string& problem) {
  const std::string text = "found '" + name + "', " + problem;
  fail(writer, writer.is_in_experiment ? std::string(writer.parameter) + ": " + text : text);
}

void OutFolder::fail(const Writer& writer, const std::string& text) {
  if (writer.is_in_experiment) {
    throw ConfigError(writer.location, writer.name + ": " + text);
  }
  throw ConfigError({writer.name, 0}, text);
}

std::string OutFolder::option(const std::string& first, const std::string& second) const {
  return prefix_ + first + (second.empty() ? "" : (prefix_ == "--" ? "-" : "_") + second);
}

fs::path OutFolder::placeOf(const std::string& name, const Writer& writer) const {
  if (name.empty()) {
    refuse(writer, name, "allowed: a file");
  }
  fs::path path = folder_ / name;
  const fs::path last = path.filename();
  const bool is_name = !last.empty() && last != "." && last != "..";
  if (writer.is_in_experiment && !rules_.anywhere && !(is_name && isInside(at(path.parent_path()), at(folder_)))) {
    refuse(writer, name,
           "allowed: a file in " + realPath(at(folder_)).string() + ", or " + option("write", "anywhere"));
  }
  return path;
}

/// @return whether the file exists; throws if it may not be replaced
bool OutFolder::mayReplace(const fs::path& path, const std::string& name, const Writer& writer) const {
  struct stat found {};
  if (lstat(path.c_str(), &found) != 0) {
    return false;
  }
  if (S_ISLNK(found.st_mode) && (stat(path.c_str(), &found) != 0 || S_ISREG(found.st_mode) || S_ISDIR(found.st_mode))) {
    refuse(writer, name, "which is a link, allowed: a name that is none");
  }
  if (S_ISDIR(found.st_mode) || S_ISBLK(found.st_mode)) {
    refuse(writer, name,
           std::string("which is a ") + (S_ISDIR(found.st_mode) ? "folder" : "disk") + ", allowed: a file");
  }
  if (!S_ISREG(found.st_mode)) {
    return true;  // a device or a pipe has no data to lose
  }
  const auto taken = taken_.find({found.st_dev, found.st_ino});
  if (taken != taken_.end()) {
    refuse(writer, name,
           (taken->second.empty() ? "which this run reads" : "which " + taken->second + " writes") +
               ", allowed: another name");
  }
  if (!rules_.replace) {
    refuse(writer, name,
           "which is there already, allowed: another name, " +
               (writer.is_in_experiment ? "another folder (" + option("out") + "), " : "") + "or " + option("force") +
               " to replace it");
  }
  return true;
}

OutDescriptor OutFolder::open(const std::string& name, const Writer& writer) {
  const fs::path shown = placeOf(name, writer);
  const fs::path path = at(shown);
  const bool is_there = mayReplace(path, name, writer);
  std::error_code ignored;
  const bool is_file = !is_there || fs::is_regular_file(path, ignored);
  // opening does not block for a pipe without a reader, and fails if the file has become a link meanwhile
  const int flags = O_CLOEXEC | O_NOCTTY |
                    (is_file ? O_RDWR | O_NOFOLLOW | (is_there ? 0 : O_CREAT | O_EXCL) : O_WRONLY | O_NONBLOCK);
  constexpr mode_t kMode = 0666;
  const int descriptor = besideStandardStreams(::open(path.c_str(), flags, kMode));
  struct stat opened {};
  if (descriptor < 0 || fstat(descriptor, &opened) != 0) {
    fail(writer, "cannot write " + shown.string() + ": " + std::strerror(errno));
  }
  // another process may have replaced the file since the check
  const bool is_what_was_there = S_ISREG(opened.st_mode) == is_file && !S_ISBLK(opened.st_mode);
  if (is_file && !is_there) {
    taken_.erase(Identity{opened.st_dev, opened.st_ino});  // a new file: the former one with this number is deleted
  }
  if (!is_what_was_there || (is_file && !taken_.emplace(Identity{opened.st_dev, opened.st_ino}, writer.name).second)) {
    close(descriptor);
    refuse(writer, name, "which changes while it is opened, allowed: a file of this run alone");
  }
  if (!is_file) {
    fcntl(descriptor, F_SETFL, fcntl(descriptor, F_GETFL) & ~O_NONBLOCK);
  }
  if (!is_there) {
    made_files_.push_back(path);
  }
  return {descriptor, shown.string(), writer.name};
}

void OutFolder::promiseSeries(const std::string& begin, const std::string& end, const Writer& writer) {
  const fs::path first = placeOf(begin + "0" + end, writer);
  const fs::path folder = at(first).parent_path();
  if (access(folder.c_str(), W_OK | X_OK) != 0) {
    fail(writer, "cannot write " + first.string() + ": " + std::strerror(errno));
  }
  const std::string start = fs::path(begin + "0").filename().string();
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().filename().string();
    if (isOfSeries(name, start.substr(0, start.size() - 1), end)) {
      mayReplace(entry.path(), (fs::path(begin + "0").parent_path() / name).string(), writer);
    }
  }
  const auto [promised, is_new] = promised_.emplace(realPath(at(first)), writer.name);
  if (!is_new) {
    refuse(writer, begin, "as " + promised->second + " names its files, allowed: another name");
  }
}

void OutFolder::writeWhole(const std::string& name, const Writer& writer, const std::vector<char>& content) {
  const fs::path shown = placeOf(name, writer);
  const fs::path path = at(shown);
  mayReplace(path, name, writer);
  const fs::path part = path.parent_path() / ("." + path.filename().string() + ".part");
  constexpr mode_t kMode = 0666;
  OutDescriptor file(::open(part.c_str(), O_CLOEXEC | O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW, kMode), shown.string(),
                     writer.name);
  if (!file.isOpen()) {
    fail(writer, "cannot write " + shown.string() + ": " + std::strerror(errno));
  }
  try {
    file.write(content.data(), content.size());
    fs::rename(part, path);
  } catch (...) {
    std::error_code ignored;
    fs::remove(part, ignored);
    throw;
  }
}

}  // namespace swarmanoid
