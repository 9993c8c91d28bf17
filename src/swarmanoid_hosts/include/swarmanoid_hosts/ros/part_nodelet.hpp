/// The base of engine, controller and device nodelets: each brings one part of an experiment to the space that runs in
/// the same nodelet manager.
///
/// Private parameters: `space`, the name of the space nodelet; `id`, the id of this part in its experiment. A part that
/// cannot be made is reported to the space, and the nodelet does not load.
#pragma once

#include <nodelet/nodelet.h>

#include <memory>
#include <string>

#include "swarmanoid_interface/attachment_point.hpp"

namespace swarmanoid {

class PartNodelet : public nodelet::Nodelet {
 public:
  /// Waits for the tick boundary; a space that cannot continue without this part is stopped there.
  ~PartNodelet() override;

 protected:
  explicit PartNodelet(PluginKind kind) : kind_(kind) {}

  /// @return an Engine, ControllerFactory or Observer, by kind
  /// @throws std::exception if the part cannot be made; the nodelet does not load then
  virtual std::shared_ptr<void> makePart(const AttachmentPoint::Request& request) = 0;

  /// Runs without a space in this process. @return false if the nodelet is to attach to a space
  virtual bool runAlone() { return false; }

 private:
  void onInit() final;

  PluginKind kind_;
  std::string id_;
  std::shared_ptr<AttachmentPoint> point_;
};

}  // namespace swarmanoid
