/// A progress bar on the standard error stream: redrawn in place on a terminal, a line each tenth elsewhere.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace swarmanoid::program {

class ProgressBar {
 public:
  /// @param total of ticks, and the simulated duration of each [s]; @param quiet draws nothing
  ProgressBar(std::string title, std::uint64_t total, double tick_s, bool quiet);
  void show(std::uint64_t done);
  /// Ends the line.
  void finish(std::uint64_t done);

 private:
  void draw(std::uint64_t done, bool is_over) const;

  std::string title_;
  std::uint64_t total_;
  double tick_s_;
  bool quiet_;
  bool is_terminal_;
  std::uint64_t next_tenth_ = 1;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point next_draw_ = start_;
};

/// A duration for people, rounded: "4 s", "2 min 5 s", "3 h 20 min", "5 d 3 h".
std::string durationText(double seconds);

}  // namespace swarmanoid::program
