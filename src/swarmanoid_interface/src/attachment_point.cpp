#include "swarmanoid_interface/attachment_point.hpp"
#include "swarmanoid_interface/plain_text.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace swarmanoid {
namespace {

std::string title(PluginKind kind, const std::string& id) { return std::string(toString(kind)) + " '" + id + "'"; }

struct Directory {
  std::mutex mutex;
  std::map<std::string, std::weak_ptr<AttachmentPoint>> points;
};

Directory& directory() {
  static Directory directory;
  return directory;
}

}  // namespace

AttachmentPoint::AttachmentPoint(std::vector<Request> requests) {
  for (Request& request : requests) {
    const Key key{request.kind, request.id};
    slots_[key].request = std::move(request);
  }
}

const AttachmentPoint::Slot& AttachmentPoint::slot(PluginKind kind, const std::string& id) const {
  const auto found = slots_.find({kind, id});
  if (found == slots_.end()) {
    std::vector<std::string> needed;
    for (const auto& [key, unused] : slots_) {
      needed.push_back(title(key.first, key.second));
    }
    throw std::runtime_error("the experiment has no " + title(kind, id) + "; there are: " + joinNames(needed));
  }
  return found->second;
}

AttachmentPoint::Request AttachmentPoint::request(PluginKind kind, const std::string& id) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return slot(kind, id).request;
}

void AttachmentPoint::attach(PluginKind kind, const std::string& id, std::shared_ptr<void> part) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (slot(kind, id).part != nullptr) {
    throw std::runtime_error(title(kind, id) + " is attached already");
  }
  Slot& free_slot = slots_[{kind, id}];
  free_slot.part = std::move(part);
  free_slot.refusal.clear();
  changed_.notify_all();
}

void AttachmentPoint::refuse(PluginKind kind, const std::string& id, const std::string& reason) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = slots_.find({kind, id});
  if (found != slots_.end() && found->second.part == nullptr && found->second.refusal.empty()) {
    found->second.refusal = reason.empty() ? "no reason given" : reason;
    changed_.notify_all();
  }
}

void AttachmentPoint::detach(PluginKind kind, const std::string& id) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = slots_.find({kind, id});
    if (found == slots_.end() || found->second.part == nullptr) {
      return;
    }
  }
  {
    // the part is still attached here: the space uses it until the handler returns
    const std::lock_guard<std::mutex> lock(handler_mutex_);
    if (loss_handler_) {
      loss_handler_(kind, id);
    }
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = slots_.find({kind, id});
  if (found != slots_.end()) {
    found->second.part.reset();
  }
}

bool AttachmentPoint::bring(const Request& part, const std::function<std::string(const Request& part)>& load) {
  const auto is_there = [&] { return this->part(part.kind, part.id) != nullptr; };
  if (is_there()) {
    return true;
  }
  const std::string reason = load(part);
  if (reason.empty() || is_there()) {
    return true;  // attached by another nodelet meanwhile
  }
  // a nodelet that failed by itself has reported its reason already, and the first reason counts
  refuse(part.kind, part.id, reason);
  return false;
}

bool AttachmentPoint::isDecided() const {
  const auto has_refused = [](const auto& item) { return !item.second.refusal.empty(); };
  const auto is_there = [](const auto& item) { return item.second.part != nullptr; };
  return std::any_of(slots_.begin(), slots_.end(), has_refused) || std::all_of(slots_.begin(), slots_.end(), is_there);
}

void AttachmentPoint::expect(Request request) {
  const std::lock_guard<std::mutex> lock(mutex_);
  Slot slot;
  const Key key{request.kind, request.id};
  slot.request = std::move(request);
  slots_.emplace(key, std::move(slot));
}

void AttachmentPoint::forget(PluginKind kind, const std::string& id) {
  const std::lock_guard<std::mutex> lock(mutex_);
  slots_.erase({kind, id});
}

void AttachmentPoint::waitForAll(std::chrono::milliseconds timeout) {
  std::unique_lock<std::mutex> lock(mutex_);
  changed_.wait_for(lock, timeout, [this] { return isDecided(); });
  std::vector<std::string> missing;
  for (const auto& [key, slot] : slots_) {
    if (!slot.refusal.empty()) {
      throw std::runtime_error(title(key.first, key.second) + " cannot take part: " + slot.refusal);
    }
    if (slot.part == nullptr) {
      missing.push_back(title(key.first, key.second));
    }
  }
  if (!missing.empty()) {
    PlainTextStream message;
    message << "still missing after " << static_cast<double>(timeout.count()) * 1e-3 << " s: " << joinNames(missing);
    throw std::runtime_error(message.str());
  }
}

std::shared_ptr<void> AttachmentPoint::part(PluginKind kind, const std::string& id) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return slot(kind, id).part;
}

void AttachmentPoint::setLossHandler(LossHandler handler) {
  const std::lock_guard<std::mutex> lock(handler_mutex_);
  loss_handler_ = std::move(handler);
}

std::shared_ptr<AttachmentPoint> openAttachmentPoint(const std::string& space,
                                                     std::vector<AttachmentPoint::Request> requests) {
  auto point = std::make_shared<AttachmentPoint>(std::move(requests));
  const std::lock_guard<std::mutex> lock(directory().mutex);
  directory().points[space] = point;
  return point;
}

std::shared_ptr<AttachmentPoint> findAttachmentPoint(const std::string& space) {
  const std::lock_guard<std::mutex> lock(directory().mutex);
  const auto found = directory().points.find(space);
  return found == directory().points.end() ? nullptr : found->second.lock();
}

}  // namespace swarmanoid
