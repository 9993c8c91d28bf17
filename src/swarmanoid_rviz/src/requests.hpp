/// Calls services of a space without holding up the window: each in a thread of its own, with the answer in the
/// window's.
///
/// Threads  all functions from the thread of Qt's windows, which `then` is called in too.
/// Ends     answers that are under way when this object ends come to nobody, and nobody waits for late ones.
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
  /// @param space the name of its node: "/space"
  explicit Requests(std::string space) : space_(std::move(space)) { post_->receiver = &here_; }
  ~Requests() {
    std::unique_lock<std::mutex> lock(post_->mutex);
    post_->receiver = nullptr;
    // so that no thread is in ROS when that ends, unless its space does not answer
    constexpr auto kPatience = std::chrono::seconds(1);
    post_->is_done.wait_for(lock, kPatience, [this] { return post_->under_way == 0; });
  }
  Requests(const Requests&) = delete;
  Requests& operator=(const Requests&) = delete;

  const std::string& space() const { return space_; }
  void setSpace(const std::string& space) { space_ = space; }

  /// @param service its name below the space
  /// @param then takes the answer; `success` is false and `message` says why if nobody gives one
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
  /// Where answers are delivered, for as long as there is somebody.
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
    } catch (const std::exception& error) {  // a name that is none
      problem = error.what();
    }
    exchange.response = {};
    exchange.response.message = problem;
    return exchange.response;
  }

  std::string space_;
  QObject here_;  // in the window's thread; what is queued for it goes with it
  std::shared_ptr<Post> post_ = std::make_shared<Post>();
};

}  // namespace swarmanoid
