#include "swarmanoid_interface/command_mailbox.hpp"

namespace swarmanoid {

void CommandMailbox::open(const std::string& robot) {
  const std::lock_guard<std::mutex> lock(mutex_);
  open_.insert(robot);
}

void CommandMailbox::close(const std::string& robot) {
  const std::lock_guard<std::mutex> lock(mutex_);
  open_.erase(robot);
}

std::string CommandMailbox::put(const std::string& robot, const std::string& device, Bytes command) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (accepted_.count(robot) == 0) {
    return "'" + robot + "' is not commanded over topics; its command source says by whom";
  }
  commands_[{robot, device}] = std::move(command);
  return "";
}

bool CommandMailbox::isOpen(const std::string& robot) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return open_.count(robot) > 0;
}

void CommandMailbox::accept(std::set<std::string> robots) {
  const std::lock_guard<std::mutex> lock(mutex_);
  accepted_ = std::move(robots);
  for (auto command = commands_.begin(); command != commands_.end();) {
    command = accepted_.count(command->first.first) == 0 ? commands_.erase(command) : std::next(command);
  }
}

bool CommandMailbox::isIdle() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return accepted_.empty();
}

CommandMailbox::Commands CommandMailbox::take() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(commands_, {});
}

}  // namespace swarmanoid
