#include "end_on_signals.hpp"

#include <ros/init.h>

#include <csignal>

namespace swarmanoid {
namespace {

void shutDown(int) { ros::requestShutdown(); }

}  // namespace

void shutDownOnSignals() {
  for (const int signal : {SIGTERM, SIGHUP}) {
    struct sigaction current {};
    if (sigaction(signal, nullptr, &current) == 0 && current.sa_handler == SIG_DFL) {
      struct sigaction action {};
      action.sa_handler = shutDown;
      action.sa_flags = SA_RESTART;
      sigemptyset(&action.sa_mask);
      sigaction(signal, &action, nullptr);
    }
  }
  std::signal(SIGXFSZ, SIG_IGN);
}

bool isRosEnding() { return !ros::ok() || ros::isShuttingDown(); }

}  // namespace swarmanoid
