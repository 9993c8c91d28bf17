#include "swarmanoid_hosts/ros/process.hpp"

#include <ros/this_node.h>
#include <ros/xmlrpc_manager.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>

namespace swarmanoid::process {
namespace {

std::atomic<bool> is_end_asked_for{false};
std::atomic<ExitCode> exit_code{ExitCode::kFinished};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler writes it");

void takeSignal(int) {
  is_end_asked_for = true;
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

/// Does the same as roscpp's handler, but does not end the process.
void takeShutdown(XmlRpc::XmlRpcValue&, XmlRpc::XmlRpcValue& result) {
  is_end_asked_for = true;
  constexpr int kSuccess = 1;
  result[0] = kSuccess;
  result[1] = "";
  result[2] = 0;
}

/// Runs after main has returned; static objects still exist.
void leave() {
  std::fflush(nullptr);
  std::_Exit(toNumber(exit_code));
}

}  // namespace

bool isStandalone(const std::string& nodelet) { return nodelet == ros::this_node::getName(); }

void takeOverSignals() {
  std::signal(SIGINT, takeSignal);
  std::signal(SIGTERM, takeSignal);
  ros::XMLRPCManager::instance()->unbind("shutdown");
  ros::XMLRPCManager::instance()->bind("shutdown", takeShutdown);
}

bool isEndAskedFor() { return is_end_asked_for; }

void endWith(ExitCode code) {
  ExitCode none = ExitCode::kFinished;
  if (code != none && exit_code.compare_exchange_strong(none, code)) {
    std::atexit(leave);
  }
}

}  // namespace swarmanoid::process
