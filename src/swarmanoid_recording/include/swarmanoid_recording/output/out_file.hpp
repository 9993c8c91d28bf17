/// A text output of an observer: a std::ostream into a file of the run's out folder.
///
/// Buffer  data go to the file when the buffer is full, and with flush(), which Observer::flush should call. Numbers
///         have the same format in every locale of the process.
/// Errors  a full disk is a std::runtime_error from the next flush(), with writer, file and reason. It is thrown once;
///         later output is dropped.
#pragma once

#include <memory>
#include <ostream>
#include <string>

#include "swarmanoid_recording/output/out_descriptor.hpp"
#include "swarmanoid_space/observer.hpp"

namespace swarmanoid {

class OutFile : public std::ostream {
 public:
  OutFile();
  ~OutFile() override;
  OutFile(const OutFile&) = delete;
  OutFile& operator=(const OutFile&) = delete;

  /// Opens the file that the observer's parameter `file` names; call it in `configure`. The file is created or refused
  /// at once; the contents of an older file of that name are replaced when the run begins.
  /// @param id of the observer
  /// @throws ConfigError if the file may not or cannot be written, see OutFolder
  void open(const RunContext& context, const Configuration& parameters, const std::string& id);
  bool isOpen() const;
  /// Writes a line that describes the run: "# diffusion, seed 3, swarmanoid 0.1.0+cf9a54f42c1e, with arena.size=9,9,1,
  /// framework.threads=2". Writes nothing if the context had no experiment.
  void describeRun(const Space& space);
  /// Writes a line with the end of the run, "# ended after 905 ticks, state hash 97bd80301c3615ae", and flushes. No
  /// line if the run was not described. @pre the space passed to describeRun still exists
  /// @throws std::runtime_error as flush
  void describeEnd();
  /// Empties the file; later output is its whole content.
  void restart();
  /// Writes the buffer to the file. @throws std::runtime_error on failure
  void flush();

 private:
  class Buffer;
  std::unique_ptr<Buffer> buffer_;
  const Experiment* experiment_ = nullptr;
  const Space* described_ = nullptr;  // null: no run
};

/// Opens the file that the parameter `file` of an observer names, for observers whose output is not text.
/// @throws ConfigError as OutFile::open
OutDescriptor openOutFile(const RunContext& context, const Configuration& parameters, const std::string& id);

}  // namespace swarmanoid
