/// Provides the devices of robots as topics: each selected robot has a nodelet that makes them. It is loaded when the
/// robot is added (at the start, by a spawn, by a reset) and unloaded when the robot is removed.
///
/// It is an observer like any other: it reads the space, and changes nothing. Whether the nodelet of a spawned robot
/// loads or not, the run goes on; the log says so if not.
///
/// Threads  draw() and follow() run on the simulation's thread. Nodelets are loaded and unloaded on a separate thread,
///          which waits for manager and tick boundary: neither a tick nor a service waits for them.
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
#include "swarmanoid_recording/messages/world_state.hpp"
#include "swarmanoid_space/simulation/simulation_thread.hpp"

namespace swarmanoid {

class RobotTopics final : public Observer {
 public:
  /// Selects the robots that have topics.
  struct Selection {
    bool is_all = false;          ///< every robot with a controller, including those that are added later
    std::set<std::string> names;  ///< the robots of these names, whenever they exist
  };

  /// @param space the name of its node @param loader, point outlive this object @param commands mailbox for commands
  RobotTopics(std::string space, Selection selection, NodeletLoader& loader, AttachmentPoint& point,
              std::shared_ptr<CommandMailbox> commands);
  ~RobotTopics() override;

  /// Takes over the nodelets that were loaded with all others before the run. It is called before start().
  void adopt(const std::vector<AttachmentPoint::Request>& parts);
  /// Begins to load and unload nodelets. @param thread outlives stop()
  void start(SimulationThread& thread);
  /// Ends loading and unloading of nodelets. After the simulation thread is stopped no call here waits for long.
  void stop();

  /// Is called between ticks: robots may have been added or removed.
  void follow(const Space& space);

  void configure(const std::string&, const Configuration&, const RunContext&) override {}
  void draw(const Space& space) override;

 private:
  using Robots = std::map<std::string, EntityNumber>;  ///< by number as well, for a later robot may have the same name

  void work();
  /// Returns the name of the first robot that is in only one of the lists, or has another number in the other.
  /// @return "" if there is none
  std::string difference() const;
  void load(const std::string& robot);
  void unload(const std::string& robot);

  const std::string space_;
  const Selection selection_;
  NodeletLoader& loader_;
  AttachmentPoint& point_;
  const std::shared_ptr<CommandMailbox> commands_;
  OutsideChanges changes_;

  std::mutex mutex_;  // guards the members below
  std::condition_variable wake_;
  Robots wanted_;
  Robots served_;  // robots that have a nodelet, or whose nodelet could not be loaded
  std::map<std::string, std::shared_ptr<Observer>> topics_;
  bool is_over_ = false;

  SimulationThread* simulation_ = nullptr;
  std::thread worker_;
};

}  // namespace swarmanoid
