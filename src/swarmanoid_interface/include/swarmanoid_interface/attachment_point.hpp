/// Connects the nodelets of one process with a space: the space lists the parts that its experiment needs, and each
/// nodelet makes one part and attaches it. This file does not use ROS; the name of the space nodelet is the key.
///
/// Both sides share the ownership: the space keeps an engine whose nodelet is unloaded until the run is stopped, and a
/// nodelet keeps the attachment point after the space is destroyed.
///
/// Threads  all functions may be called from any thread.
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
  /// A part that an experiment needs. The attached object is an Engine for kEngine, a ControllerFactory for
  /// kController, an Observer for kObserver.
  struct Request {
    PluginKind kind = PluginKind::kEngine;
    std::string id;
    std::string label;  ///< the label in the registry; the space has checked that it is registered
    Configuration parameters;
    /// For kObserver: the mailbox for commands from outside, or null.
    std::shared_ptr<CommandMailbox> commands = nullptr;
  };

  explicit AttachmentPoint(std::vector<Request> requests);

  // Functions for nodelets.

  /// @throws std::runtime_error that names the needed parts, if this part is not needed
  Request request(PluginKind kind, const std::string& id) const;
  /// @throws std::runtime_error if the part is not needed, or is attached already
  void attach(PluginKind kind, const std::string& id, std::shared_ptr<void> part);
  /// Reports that the part cannot be made; waitForAll throws the reason. The first reason counts.
  void refuse(PluginKind kind, const std::string& id, const std::string& reason);
  /// Returns once the space has stopped using the part. Does nothing if the part is not attached.
  void detach(PluginKind kind, const std::string& id);

  // Functions for the space.

  /// Adds a needed part while the experiment runs; no call waits for it. Does nothing if the part is needed already.
  void expect(Request request);
  /// Removes the part from the needed ones. @pre the part is not attached
  void forget(PluginKind kind, const std::string& id);

  /// Loads a part unless it is attached already, for example by the user's launch file.
  /// @param load loads it; returns the reason of the failure, or ""
  /// @return false if `load` failed and the part is not attached; the part is then refused
  bool bring(const Request& part, const std::function<std::string(const Request& part)>& load);

  /// Waits until all parts are attached or one is refused.
  /// @throws std::runtime_error naming the missing part, or the refused part and the reason
  void waitForAll(std::chrono::milliseconds timeout);
  /// @pre waitForAll has returned
  std::shared_ptr<void> part(PluginKind kind, const std::string& id) const;
  using LossHandler = std::function<void(PluginKind kind, const std::string& id)>;
  /// Sets the handler that is called when a part is detached. It must not return before the part is out of use. After
  /// setLossHandler returns, the former handler is not running and will not be called again.
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

/// Makes the attachment point of a space, which replaces a former one of that name. It can be found as long as a
/// pointer to it exists.
std::shared_ptr<AttachmentPoint> openAttachmentPoint(const std::string& space,
                                                     std::vector<AttachmentPoint::Request> requests);

/// @return null if this process has no such space
std::shared_ptr<AttachmentPoint> findAttachmentPoint(const std::string& space);

}  // namespace swarmanoid
