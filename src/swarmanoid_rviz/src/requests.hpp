/// Calls services of a space without holding up the window: in threads of their own, with the answers in the window's.
///
/// Threads  all functions from the thread of Qt's windows, which `then` is called in too.
#pragma once

#include <ros/service.h>

#include <QObject>
#include <QThreadPool>
#include <functional>
#include <string>

namespace swarmanoid {

class Requests {
 public:
  /// @param space the name of its node: "/space"
  explicit Requests(std::string space) : space_(std::move(space)) { pool_.setMaxThreadCount(kMostAtOnce); }
  /// Waits for the answers that are under way; nobody is told of them.
  ~Requests() { pool_.waitForDone(); }
  Requests(const Requests&) = delete;
  Requests& operator=(const Requests&) = delete;

  const std::string& space() const { return space_; }
  void setSpace(const std::string& space) { space_ = space; }

  /// @param service its name below the space
  /// @param then takes the answer; `success` is false and `message` says so if nobody gives one
  template <class Service>
  void call(const std::string& service, const typename Service::Request& request,
            std::function<void(const typename Service::Response&)> then) {
    const std::string name = space_ + "/" + service;
    pool_.start([this, name, request, then = std::move(then)] {
      Service exchange;
      exchange.request = request;
      if (!ros::service::call(name, exchange)) {
        exchange.response = {};
        exchange.response.message = "no answer from " + name;
      }
      QMetaObject::invokeMethod(
          &here_, [then, response = exchange.response] { then(response); }, Qt::QueuedConnection);
    });
  }

 private:
  // a pause has to get through while a step and a poll wait for their answers
  static constexpr int kMostAtOnce = 4;

  std::string space_;
  QObject here_;  // in the window's thread; what is queued for it goes with it
  QThreadPool pool_;
};

}  // namespace swarmanoid
