/// The devices of robots as topics: each robot that is to have them has a nodelet that makes them. It is loaded when
/// the robot comes (at the start, by a spawn, by a reset) and unloaded when the robot goes.
///
/// An observer like any other: it looks, and changes nothing. Whether the nodelet of a spawned robot loads or not,
/// the run goes on; the log says so if not.
///
/// Threads  draw() and follow() on the simulation's. Nodelets come and go on a thread of its own, which waits for
///          manager and tick boundary: neither a tick nor a service waits for them.
#pragma once

#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "space_parts.hpp"
#include "swarmanoid_space/ros/world_state.hpp"
#include "swarmanoid_space/simulation/simulation_thread.hpp"

namespace swarmanoid {

class RobotTopics final : public Observer {
 public:
  /// Which robots have topics.
  struct Selection {
    bool is_all = false;          ///< every robot with a controller, those too that come later
    std::set<std::string> names;  ///< these, whenever they are there
  };

  /// @param space the name of its node @param loader, point outlive this @param commands where commands go
  RobotTopics(std::string space, Selection selection, NodeletLoader& loader, AttachmentPoint& point,
              std::shared_ptr<CommandMailbox> commands);
  ~RobotTopics() override;

  /// The nodelets that were loaded with all others before the run. Before start().
  void adopt(const std::vector<AttachmentPoint::Request>& parts);
  /// From now on nodelets are loaded and unloaded. @param thread outlives stop()
  void start(SimulationThread& thread);
  /// No nodelet is loaded or unloaded any more. Once the simulation thread is stopped nothing here waits for long.
  void stop();

  /// Between ticks: robots may have come or gone.
  void follow(const Space& space);

  void configure(const std::string&, const Configuration&, const RunContext&) override {}
  void draw(const Space& space) override;

 private:
  using Robots = std::map<std::string, EntityNumber>;  ///< a robot of the same name that comes later is another one

  void work();
  /// The first robot that is in one of them only, or another one there. @return "" if there is none
  std::string difference() const;
  void load(const std::string& robot);
  void unload(const std::string& robot);

  const std::string space_;
  const Selection selection_;
  NodeletLoader& loader_;
  AttachmentPoint& point_;
  const std::shared_ptr<CommandMailbox> commands_;
  OutsideChanges changes_;

  std::mutex mutex_;  // guards what follows
  std::condition_variable wake_;
  Robots wanted_;
  Robots served_;  // they have a nodelet, or could not get one
  std::map<std::string, std::shared_ptr<Observer>> topics_;
  bool is_over_ = false;

  SimulationThread* simulation_ = nullptr;
  std::thread worker_;
};

}  // namespace swarmanoid
