/// Calls services of a space without blocking the window: each call runs in its own thread.
///
/// Threads  all functions must be called from Qt's GUI thread, which calls `then`, too.
/// Ends     the destructor waits up to 1 s for pending calls and drops their answers.
#pragma once

#include <ros/service.h>

#include <QMetaObject>
#include <QObject>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

namespace swarmanoid {

class Requests {
 public:
  /// @param space name of the node: "/space"
  explicit Requests(std::string space) : space_(std::move(space)) { post_->receiver = &here_; }
  ~Requests() {
    std::unique_lock<std::mutex> lock(post_->mutex);
    post_->receiver = nullptr;
    // no call may be inside ROS when ROS shuts down, unless the space does not answer
    constexpr auto kPatience = std::chrono::seconds(1);
    post_->is_done.wait_for(lock, kPatience, [this] { return post_->under_way == 0; });
  }
  Requests(const Requests&) = delete;
  Requests& operator=(const Requests&) = delete;

  const std::string& space() const { return space_; }
  void setSpace(const std::string& space) { space_ = space; }

  /// @param service name relative to the space
  /// @param then takes the answer; without an answer `success` is false and `message` has the reason
  template <class Service>
  void call(const std::string& service, const typename Service::Request& request,
            std::function<void(const typename Service::Response&)> then) {
    {
      const std::lock_guard<std::mutex> lock(post_->mutex);
      ++post_->under_way;
    }
    const auto ask = [post = post_, name = space_ + "/" + service, request, then = std::move(then)] {
      const auto answer = answerOf<Service>(name, request);
      const std::lock_guard<std::mutex> lock(post->mutex);
      if (post->receiver != nullptr) {
        QMetaObject::invokeMethod(
            post->receiver, [then, answer] { then(answer); }, Qt::QueuedConnection);
      }
      --post->under_way;
      post->is_done.notify_all();
    };
    std::thread(ask).detach();
  }

 private:
  /// Receiver of answers, shared with the threads of the calls; `receiver` is null after destruction.
  struct Post {
    std::mutex mutex;
    QObject* receiver = nullptr;
    int under_way = 0;
    std::condition_variable is_done;
  };

  template <class Service>
  static typename Service::Response answerOf(const std::string& name, const typename Service::Request& request) {
    Service exchange;
    exchange.request = request;
    std::string problem = "no answer from " + name;
    try {
      if (ros::service::call(name, exchange)) {
        return exchange.response;
      }
    } catch (const std::exception& error) {  // an invalid name
      problem = error.what();
    }
    exchange.response = {};
    exchange.response.message = problem;
    return exchange.response;
  }

  std::string space_;
  QObject here_;  // in the GUI thread; its destructor discards queued answers
  std::shared_ptr<Post> post_ = std::make_shared<Post>();
};

}  // namespace swarmanoid
