#include "swarmanoid_interface/process/last_seconds.hpp"

#include <unistd.h>

#include <chrono>
#include <string_view>
#include <system_error>
#include <thread>

namespace swarmanoid {

void endWithinSeconds(ExitCode code) {
  try {
    // no alarm: the thread that ends the process may have closed itself to signals
    std::thread([code] {
      constexpr std::chrono::seconds kPatience{10};
      std::this_thread::sleep_for(kPatience);
      constexpr std::string_view kText = "swarmanoid: a library does not let the process end: it is left there\n";
      [[maybe_unused]] const ssize_t ignored = write(STDERR_FILENO, kText.data(), kText.size());
      _exit(toNumber(code));
    }).detach();
  } catch (const std::system_error&) {
    // nothing is lost where there are no more threads
  }
}

}  // namespace swarmanoid
