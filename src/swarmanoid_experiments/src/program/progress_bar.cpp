#include "progress_bar.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace swarmanoid::program {

ProgressBar::ProgressBar(std::string title, std::uint64_t total, bool quiet)
    : title_(std::move(title)),
      total_(std::max<std::uint64_t>(total, 1)),
      quiet_(quiet),
      is_terminal_(isatty(STDERR_FILENO) == 1) {}

void ProgressBar::show(std::uint64_t done) {
  if (quiet_) {
    return;
  }
  if (!is_terminal_) {
    if (done * 10 >= next_tenth_ * total_) {
      draw(done);
      next_tenth_ = done * 10 / total_ + 1;
    }
    return;
  }
  const auto now = std::chrono::steady_clock::now();
  if (now >= next_draw_) {
    draw(done);
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
    draw(done);
    std::fputc('\n', stderr);
    stands_ = false;
  }
}

void ProgressBar::draw(std::uint64_t done) {
  const std::lock_guard<std::mutex> lock(mutex_);
  constexpr std::uint64_t kWidth = 40;
  const std::uint64_t filled = std::min(kWidth, done * kWidth / total_);
  const std::string bar = std::string(filled, '#') + std::string(kWidth - filled, '.');
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  std::fprintf(stderr, "%s%s [%s] %llu of at most %llu ticks, %.0f ticks/s%s", is_terminal_ ? "\r" : "", title_.c_str(),
               bar.c_str(), static_cast<unsigned long long>(done), static_cast<unsigned long long>(total_),
               seconds > 0.0 ? static_cast<double>(done) / seconds : 0.0, is_terminal_ ? " " : "\n");
  std::fflush(stderr);
  stands_ = is_terminal_;
}

}  // namespace swarmanoid::program
