/// A progress bar on the standard error stream: redrawn in place on a terminal, a line each tenth elsewhere. All other
/// output during that time is printed through it, so that the bar neither hides a line nor leaves a gap.
#pragma once

#include <chrono>
#include <cstdint>
#include <mutex>
#include <string>

namespace swarmanoid::program {

class ProgressBar {
 public:
  /// @param total number of ticks @param tick_s simulated duration of a tick [s] @param quiet draws nothing
  ProgressBar(std::string title, std::uint64_t total, double tick_s, bool quiet);
  void show(std::uint64_t done);
  /// Prints a whole line in place of the bar, even if `quiet` is set; the bar is drawn again later. Callable from any
  /// thread.
  void print(const std::string& line);
  /// Ends the line of the bar.
  void finish(std::uint64_t done);

 private:
  void draw(std::uint64_t done, bool is_over);

  std::mutex mutex_;  // guards the stream: controllers in several threads print
  std::string title_;
  std::uint64_t total_;
  double tick_s_;
  bool quiet_;
  bool is_terminal_;
  bool stands_ = false;  // whether the bar is on a terminal, without a line end
  std::uint64_t next_tenth_ = 1;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point next_draw_ = start_;
};

/// Returns a rounded duration for people: "4 s", "2 min 5 s", "3 h 20 min", "5 d 3 h".
std::string durationText(double seconds);

}  // namespace swarmanoid::program
