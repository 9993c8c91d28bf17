/// A progress bar on the standard error stream: redrawn in place on a terminal, a line each tenth elsewhere. Whatever
/// else is said while it stands there is printed through it, so that the bar neither hides a line nor leaves a gap.
#pragma once

#include <chrono>
#include <cstdint>
#include <mutex>
#include <string>

namespace swarmanoid::program {

class ProgressBar {
 public:
  /// @param total of ticks, and the simulated duration of each [s]; @param quiet draws nothing
  ProgressBar(std::string title, std::uint64_t total, double tick_s, bool quiet);
  void show(std::uint64_t done);
  /// Prints a whole line in place of the bar, which is drawn again later; `quiet` or not. From any thread.
  void print(const std::string& line);
  /// Ends the line.
  void finish(std::uint64_t done);

 private:
  void draw(std::uint64_t done, bool is_over);

  std::mutex mutex_;  // of the stream: controllers in several threads print
  std::string title_;
  std::uint64_t total_;
  double tick_s_;
  bool quiet_;
  bool is_terminal_;
  bool stands_ = false;  // on a terminal, without the end of its line
  std::uint64_t next_tenth_ = 1;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point next_draw_ = start_;
};

/// A duration for people, rounded: "4 s", "2 min 5 s", "3 h 20 min", "5 d 3 h".
std::string durationText(double seconds);

}  // namespace swarmanoid::program
