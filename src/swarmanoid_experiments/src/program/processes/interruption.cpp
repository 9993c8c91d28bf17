#include "interruption.hpp"

#include <csignal>

#include "swarmanoid_interface/process/user_code_watch.hpp"

namespace swarmanoid::program {
namespace {

volatile std::sig_atomic_t interrupted = 0;

void note(int signal) {
  if (interrupted != 0 && signal != SIGHUP) {  // a closing terminal may send SIGHUP several times
    UserCodeWatch::askToEndNow();
  }
  interrupted = 1;
}

bool isIgnored(int signal) {
  struct sigaction current {};
  return sigaction(signal, nullptr, &current) == 0 && current.sa_handler == SIG_IGN;
}

}  // namespace

void noteInterruptions() {
  struct sigaction action {};
  action.sa_handler = note;
  action.sa_flags = SA_RESTART;  // a write in progress must not fail
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  if (!isIgnored(SIGHUP)) {
    sigaction(SIGHUP, &action, nullptr);
  }
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

bool isInterrupted() { return interrupted != 0; }

}  // namespace swarmanoid::program
