#include "swarmanoid_interface/process/last_seconds.hpp"

#include <unistd.h>

#include <chrono>
#include <string_view>
#include <system_error>
#include <thread>

namespace swarmanoid {

void endWithinSeconds(ExitCode code) {
  try {
    // alarm() is not used: the thread that ends the process may have blocked signals
    std::thread([code] {
      constexpr std::chrono::seconds kPatience{10};
      std::this_thread::sleep_for(kPatience);
      constexpr std::string_view kText = "swarmanoid: a library does not let the process end: it is left there\n";
      [[maybe_unused]] const ssize_t ignored = write(STDERR_FILENO, kText.data(), kText.size());
      _exit(toNumber(code));
    }).detach();
  } catch (const std::system_error&) {
    // the limit is not essential where no thread can be started
  }
}

}  // namespace swarmanoid
