/// A text that an observer writes: a std::ostream into a file of the run's out folder.
///
/// Buffer  what is written gets to the file when there is much of it, and with flush(), which Observer::flush is
///         for. Numbers are written the same whatever the process's locale is.
/// Errors  a full disk is a std::runtime_error from the next flush(), which names writer, file and reason. It is thrown
///         once; what comes after is dropped.
#pragma once

#include <memory>
#include <ostream>
#include <string>

#include "swarmanoid_space/observer.hpp"
#include "swarmanoid_space/output/out_descriptor.hpp"

namespace swarmanoid {

class OutFile : public std::ostream {
 public:
  OutFile();
  ~OutFile() override;
  OutFile(const OutFile&) = delete;
  OutFile& operator=(const OutFile&) = delete;

  /// Takes the file that the observer's parameter `file` names. In `configure`: it is made, or refused, there;
  /// what an older file of that name holds is replaced when the run begins.
  /// @param id of the observer
  /// @throws ConfigError if it may not or cannot be written, see OutFolder
  void open(const RunContext& context, const Configuration& parameters, const std::string& id);
  bool isOpen() const;
  /// Writes a line that says of which run it is: "# diffusion, seed 3, swarmanoid 0.1.0+cf9a54f42c1e, with
  /// arena.size=9,9,1, framework.threads=2". Nothing if the context had no experiment.
  void describeRun(const Space& space);
  /// Writes a line that says to what the run has come, "# ended after 905 ticks, state hash 97bd80301c3615ae", and
  /// flushes. No line if the run was not described. @pre the space that described it is still there
  /// @throws std::runtime_error as flush
  void describeEnd();
  /// Empties it: what follows is the whole file.
  void restart();
  /// What was written is in the file from here on. @throws std::runtime_error if it is not
  void flush();

 private:
  class Buffer;
  std::unique_ptr<Buffer> buffer_;
  const Experiment* experiment_ = nullptr;
  const Space* described_ = nullptr;  // null: no run
};

/// The file that the parameter `file` of an observer names, for those that write no text.
/// @throws ConfigError as OutFile::open
OutDescriptor openOutFile(const RunContext& context, const Configuration& parameters, const std::string& id);

}  // namespace swarmanoid
