#include "progress_bar.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace swarmanoid::program {

ProgressBar::ProgressBar(std::string title, std::uint64_t total, double tick_s, bool quiet)
    : title_(std::move(title)),
      total_(std::max<std::uint64_t>(total, 1)),
      tick_s_(tick_s),
      quiet_(quiet),
      is_terminal_(isatty(STDERR_FILENO) == 1) {}

void ProgressBar::show(std::uint64_t done) {
  if (quiet_) {
    return;
  }
  const bool is_over = done >= total_;
  if (!is_terminal_) {
    if (done * 10 >= next_tenth_ * total_) {
      draw(done, is_over);
      next_tenth_ = done * 10 / total_ + 1;
    }
    return;
  }
  const auto now = std::chrono::steady_clock::now();
  if (now >= next_draw_) {
    draw(done, is_over);
    next_draw_ = now + std::chrono::milliseconds(100);
  }
}

void ProgressBar::print(const std::string& line) {
  const std::lock_guard<std::mutex> lock(mutex_);
  constexpr const char* kEraseLine = "\r\x1b[K";
  std::fprintf(stderr, "%s%s\n", stands_ ? kEraseLine : "", line.c_str());
  std::fflush(stderr);
  stands_ = false;
}

void ProgressBar::finish(std::uint64_t done) {
  if (!quiet_ && is_terminal_) {
    draw(done, true);
    std::fputc('\n', stderr);
    stands_ = false;
  }
}

void ProgressBar::draw(std::uint64_t done, bool is_over) {
  const std::lock_guard<std::mutex> lock(mutex_);
  constexpr std::uint64_t kWidth = 40;
  const std::uint64_t filled = std::min(kWidth, done * kWidth / total_);
  const std::string bar = std::string(filled, '#') + std::string(kWidth - filled, '.');
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  const double rate = seconds > 0.0 ? static_cast<double>(done) / seconds : 0.0;  // ticks each second
  std::string rest;
  if (!is_over && rate > 0.0) {
    rest = ", about " + durationText(static_cast<double>(total_ - std::min(done, total_)) / rate) + " left";
  }
  // also erases the rest of a longer previous line
  std::fprintf(stderr, "%s%s [%s] %llu of at most %llu ticks, %.1f s simulated, %.0f ticks/s%s%s",
               is_terminal_ ? "\r" : "", title_.c_str(), bar.c_str(), static_cast<unsigned long long>(done),
               static_cast<unsigned long long>(total_), static_cast<double>(done) * tick_s_, rate, rest.c_str(),
               is_terminal_ ? "\x1b[K" : "\n");
  std::fflush(stderr);
  stands_ = is_terminal_;
}

std::string durationText(double seconds) {
  constexpr double kLongest = 1e6 * 86400.0;
  if (!(seconds < kLongest)) {
    return "over 1000000 d";
  }
  struct Unit {
    const char* name;
    long long seconds;
  };
  constexpr Unit kUnits[] = {{"d", 86400}, {"h", 3600}, {"min", 60}, {"s", 1}};
  const long long whole = std::llround(seconds);
  for (const Unit* unit = kUnits; unit->seconds > 1; ++unit) {
    if (whole >= unit->seconds) {
      const Unit* smaller = unit + 1;
      return std::to_string(whole / unit->seconds) + " " + unit->name + " " +
             std::to_string(whole % unit->seconds / smaller->seconds) + " " + smaller->name;
    }
  }
  return std::to_string(whole) + " s";
}

}  // namespace swarmanoid::program
