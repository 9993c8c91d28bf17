/// Where the nodelets of one process meet a space: the space says which parts its experiment needs, each nodelet makes
/// one and attaches it. No ROS here; the space nodelet's name is the key.
///
/// Both sides own what they share, so neither may outlive it: the space keeps an engine whose nodelet is gone until the
/// run is stopped, a nodelet keeps its place when the space is gone.
///
/// Threads  all functions from any thread.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "swarmanoid_interface/command_mailbox.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/registry.hpp"

namespace swarmanoid {

/// The part that a controller nodelet attaches: it makes one controller for each robot.
using ControllerFactory = std::function<std::shared_ptr<Controller>()>;

class AttachmentPoint {
 public:
  /// A part that an experiment needs. What is attached as kEngine is an Engine, as kController a ControllerFactory, as
  /// kObserver an Observer.
  struct Request {
    PluginKind kind = PluginKind::kEngine;
    std::string id;
    std::string label;  ///< in the registry, where the space has seen to it that it is
    Configuration parameters;
    /// Of kObserver: where commands from outside may be put; or null.
    std::shared_ptr<CommandMailbox> commands = nullptr;
  };

  explicit AttachmentPoint(std::vector<Request> requests);

  // For nodelets.

  /// @throws std::runtime_error naming what is needed, if that is not
  Request request(PluginKind kind, const std::string& id) const;
  /// @throws std::runtime_error if the part is not needed, or there already
  void attach(PluginKind kind, const std::string& id, std::shared_ptr<void> part);
  /// The part cannot be made; whoever waits for it learns why. The first reason counts.
  void refuse(PluginKind kind, const std::string& id, const std::string& reason);
  /// Returns once the space has stopped using the part. Nothing happens if it is not attached.
  void detach(PluginKind kind, const std::string& id);

  // For the space.

  /// One more part is needed while the experiment runs; nobody waits for it. Nothing happens if it is needed already.
  void expect(Request request);
  /// The part is needed no more. @pre nothing is attached as that part
  void forget(PluginKind kind, const std::string& id);

  /// Waits until all parts are there or one is refused.
  /// @throws std::runtime_error naming who is missing, or who was refused and why
  void waitForAll(std::chrono::milliseconds timeout);
  /// @pre waitForAll has returned
  std::shared_ptr<void> part(PluginKind kind, const std::string& id) const;
  using LossHandler = std::function<void(PluginKind kind, const std::string& id)>;
  /// Called when a part is detached; it must not return before the part is out of use. After setLossHandler returns,
  /// the former handler is not running and will not be called again.
  void setLossHandler(LossHandler handler);

 private:
  using Key = std::pair<PluginKind, std::string>;
  struct Slot {
    Request request;
    std::shared_ptr<void> part;
    std::string refusal;
  };
  const Slot& slot(PluginKind kind, const std::string& id) const;
  bool isDecided() const;

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::map<Key, Slot> slots_;
  std::mutex handler_mutex_;
  LossHandler loss_handler_;
};

/// The attachment point of a space, findable as long as somebody holds it. A former one of that name is replaced.
std::shared_ptr<AttachmentPoint> openAttachmentPoint(const std::string& space,
                                                     std::vector<AttachmentPoint::Request> requests);

/// @return null if this process has no such space
std::shared_ptr<AttachmentPoint> findAttachmentPoint(const std::string& space);

}  // namespace swarmanoid
