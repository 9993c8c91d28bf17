/// The two-dimensional kinematic engine (thesis 3.5.1): bodies in a plane follow their velocities.
///
/// There are no masses and no forces. Bodies move one after another, in the order of their entity numbers, so results
/// do not depend on anything else. Bodies that cannot meet in a step move at once, on all threads, with the same
/// results. A body that would overlap another advances to contact and slides along it: its new pose is pushed out of
/// the overlap by the shortest way. So a robot with its nose at a wall can turn, and slips back by as much as its nose
/// needs. Without room for that, the body goes the free part of its way, then makes the free part of its turn. Nothing
/// overlaps after a tick, with one exception: a mirror (an entity that another engine moves) may come to overlap a
/// body; such a pair hinders the body only from going deeper. With neighbours near, a body moves in pieces of half its
/// inner radius, so fast bodies do not tunnel through thin walls.
///
/// Wheels are integrated exactly along the arc. Velocity out of the plane is dropped: an eyebot flies with the part of
/// its velocity that lies in the plane. A footbot can grip a prey, or a robot without a drive, such as a handbot, but
/// neither another footbot nor a flying robot. Grips form no chains: a gripped body grips nothing, and a gripping body
/// cannot be gripped. A prey has at most one gripper at a time, a handbot any number; both keep their place in the
/// gripper to the last digits. A body with several grippers moves by the mean of the ways, and turns by the mean of the
/// turns, that each of them alone would give it; the grippers go along, as far as all of them have room.
///
/// Turrets turn after all bodies have moved, at the commanded speed, and the gripped body turns with its turret around
/// the robot. A turret stands if its gripped body has other grippers too. A turret turns only as far as its gripper and
/// the gripped body are free of overlap. A body held by a passive turret trails behind the robot like a trailer: its
/// centre never moves sideways.
///
/// Rays hit bodies as prisms over their planar shapes. Rays do not hit mirrors of entities that another engine moves:
/// that engine reports those hits.
#pragma once

#include <algorithm>
#include <vector>

#include "kinematics2d/islands.hpp"
#include "kinematics2d/neighbours.hpp"
#include "planar/body_overlap.hpp"
#include "planar/placed_pose.hpp"
#include "planar/planar_engine.hpp"
#include "swarmanoid_space/parallel.hpp"

namespace swarmanoid::kinematics2d {

using planar::Body;
using planar::BodyIndex;
using planar::kNoBody;
using planar::PlacedPose;

constexpr double kMostPush = 0.005;  ///< limit of the push out of an overlap, beyond the way of the step [m]; a nose
                                     ///< that turns at a wall needs less

/// How long a body need not search for neighbours, since all were far away in its last search. Distances are counted as
/// the motion that any body can have made since the engine began, see Kinematics2d::travelled_.
struct Clearance {
  double free_until = -1.0;            ///< up to this distance travelled no other body can have come near
  double look_ahead = kMostLookAhead;  ///< range of the next search [m]
  bool at_all_heights = false;         ///< true if no body is near at other heights either
};

/// State of a body in this engine, besides its pose and its clearance. Not read for bodies that move without a search.
struct Motion {
  planar::PlanarPose pose_at_start;  ///< of the tick

  // Grips: a gripped body moves with its gripper. Gripping bodies have no clearance.
  BodyIndex gripped = kNoBody;
  BodyIndex gripped_by = kNoBody;       ///< the first of its grippers, by entity number
  BodyIndex next_gripper = kNoBody;     ///< next gripper of the same body, by entity number
  planar::PlanarPose place_of_gripped;  ///< of the gripped body in this gripper's frame, from the moment of gripping
};

class Kinematics2d final : public planar::PlanarEngine {
 public:
  static PluginDescription describe();

  std::string unsupportedStateReason(const Space& space, Row row) const override;
  void add(const Space& space, Row row, Role role) override;
  void remove(const Space& space, Row row) override;
  void place(const Space& space, Row row) override;
  void clear() override {
    bodies_.clear();
    motions_.clear();
    clearances_.clear();
    neighbours_.clear();
    is_somebody_new_ = true;
    are_lists_old_ = true;
  }
  void prepare(const EngineResources& resources) override {
    workers_ = resources.workers;
    are_lists_old_ = true;
  }
  /// Smallest number of bodies that a thread moves, if there are several threads; 0: all bodies move one after another.
  /// Results do not depend on it.
  void setLeastBlock(std::size_t size) {
    least_block_ = size;
    are_lists_old_ = true;
  }
  void readMirrors(const Space& space) override;
  void move(const Space& space, const MoveAccess& access, Duration dt) override;
  void connect(const Space& space, const ConnectAccess& access) override;
  bool mayHit(const RayBundle& rays) const override;
  void findObstacles(const RayBundle& rays, Obstacles& found) const override;
  void raycast(const RayBundle& rays, Span<RayHit> hits) const override;
  void archive(const Space& space, StateArchive& state) override;
  void draw(EngineDrawing& drawing) const override;

 private:
  /// A range of movers_ that one thread handles in a step.
  struct Block {
    std::size_t first = 0;         ///< in movers_
    std::size_t last = 0;          ///< one past the last
    std::size_t other_count = 0;   ///< number in others_, from `first` on: bodies that move after all blocks
    std::size_t stray_count = 0;   ///< number in strays_, from `first` on: bodies that have changed their cell
    double fastest_squared = 0.0;  ///< of the fastest body [m2/s2]
    double slide_allowance = 0.0;  ///< largest way of a body beyond the step length, by pushes in this step [m]
  };
  struct Contact {
    planar::Penetration way_out;
    EntityNumber with = kNoEntity;  ///< the other body
  };
  static constexpr std::int32_t kNoPlace = -1;

  // free_motion.cpp
  void listBodies();
  void listBlocks();
  template <class Work>
  void forBlocks(Work work);
  double readAllCommands(const Space& space);
  /// Whether a body moves freely, or not at all. Gripping bodies have no clearance. @param room `free_until` that free
  /// motion needs [m]
  bool hasRoomOrStands(BodyIndex index, double room) const {
    return clearance(index).free_until >= room ||
           (bodies_[index].isCommandedToStand() && motion(index).gripped == kNoBody);
  }
  /// Whether a body may move with its block: undriven bodies may be carried, and the grid does not hold large ones.
  static bool movesByItself(const Body& body) { return body.isDriven() && !body.is_large; }
  void moveBlocks(const Space& space, const MoveAccess& access, double step, double tick);
  void moveBlock(const Space& space, const MoveAccess& access, double step, double tick, double room, Block& block);
  void finishTick(const Space& space, const MoveAccess& access, double tick);
  void finishBody(const Space& space, const MoveAccess& access, BodyIndex index, const planar::PlanarPose& before,
                  double tick) const;
  /// Calls visit(index) for the bodies that did not move with their block in this step, by entity number.
  template <class Visit>
  void visitOthers(Visit visit) const {
    for (const Block& block : blocks_) {
      for (std::size_t k = 0; k < block.other_count; ++k) {
        visit(others_[block.first + k]);
      }
    }
  }

  // islands.cpp
  void findRoom(double room, const Block& block);
  void lookAround(std::size_t k, double slide_allowance, const Block& block);
  void joinIsland(std::size_t k, BodyIndex other, const Block& block);
  bool knowsWhoIsNear(BodyIndex index, double slide_allowance);
  bool isHeldOrHolds(BodyIndex index) const {
    return motion(index).gripped != kNoBody || motion(index).gripped_by != kNoBody;
  }
  /// Position of a body in movers_, or kNoPlace.
  std::int32_t place(BodyIndex index) const { return places_[static_cast<std::size_t>(index)]; }
  /// Whether a body moves with another block than `block`.
  bool isOfOtherBlock(BodyIndex index, const Block& block) const {
    const std::int32_t at = place(index);
    return at != kNoPlace && (static_cast<std::size_t>(at) < block.first || static_cast<std::size_t>(at) >= block.last);
  }

  // motion.cpp. Parameters `block`: the block of the body while all blocks move at once; all_ when no other body moves.
  void startTick(const Space& space, double step);
  void moveBody(BodyIndex index, double dt, Block& block);
  int piecesOf(const Body& body, double dt) const;
  /// Pose of an unobstructed body after a step. Equal to the last bit whether or not the body searches for neighbours
  /// and moves in pieces, because that depends on the number of threads.
  PlacedPose unhindered(const Body& body, double dt) const {
    return most_pieces_ == 1.0 ? planar::integrate(body.pose, body.velocity, body.turn_rate, dt)
                               : unhinderedInPieces(body, dt);
  }
  PlacedPose unhinderedInPieces(const Body& body, double dt) const;
  bool moveUnseen(BodyIndex index, double dt, const Block& block);
  void put(BodyIndex index, const PlacedPose& pose, const Block& block);
  bool tryPose(BodyIndex index, const PlacedPose& pose, const Block& block);
  bool tryCarry(BodyIndex index, const PlacedPose& pose, const planar::PlanarPose& place);
  static PlacedPose carriedPose(const PlacedPose& gripper, const planar::PlanarPose& place);
  bool isFree(BodyIndex index, const PlacedPose& pose, Clearance& around, const Block& block);
  const Neighbours* neighboursAt(BodyIndex index, const Eigen::Vector2d& position, const Block& block);
  /// Calls visit(other) for bodies that may be within `distance` of a position, until it returns false; while blocks
  /// move, only for those that the body may meet in the step. @param near neighbours of a body there; null: there is no
  /// list
  template <class Visit>
  void visitNear(const Neighbours* near, const Eigen::Vector2d& position, double distance, const Block& block,
                 Visit visit) const {
    if (near == nullptr) {
      bodies_.visitNear(position, distance, visit);
      return;
    }
    std::uint32_t chosen = areAllInOne(block) ? near->all() : near->meeting;
    while (chosen != 0 && visit(near->bodies[static_cast<std::size_t>(__builtin_ctz(chosen))])) {
      chosen &= chosen - 1;
    }
  }
  bool areAllInOne(const Block& block) const { return &block == &all_; }
  /// Bound on motion up to the end of the current step, as far as is known while blocks move [m].
  double travelled(const Block& block) const { return travelled_ + block.slide_allowance; }
  /// Distance travelled up to which a gap to others cannot close, with both sides moving into it [m].
  double freeUntil(double gap, const Block& block) const {
    constexpr double kMargin = 1e-6;  // m, for rounding
    return travelled(block) + 0.5 * (gap - kMargin);
  }
  /// Range of the next search if the nearest body is that far away [m].
  double lookAheadFor(double nearest) const {
    return std::min(kMostLookAhead, 2.0 * (std::max(0.0, nearest) + step_length_));
  }
  /// False for mirrors that may move: their height may change before the body arrives.
  static bool isAtOtherHeights(const Body& body, const Body& other) {
    const bool keeps_height = other.role == Role::kMove || !other.is_movable;
    return keeps_height && !body.model->band.overlaps(other.model->band, body.along, other.along);
  }
  bool isHindering(BodyIndex index, const PlacedPose& pose, const Body& other);

  // group.cpp
  double fastestOfGroups() const;
  void moveGroup(BodyIndex gripped, double dt);
  planar::PlanarPose wayOfGroup(BodyIndex gripped, double dt) const;
  bool tryGroup(BodyIndex gripped, const PlacedPose& pose);

  // contact.cpp
  void movePiece(BodyIndex index, double dt, const Block& block);
  void turnPiece(BodyIndex index, double turn, const Block& block);
  bool tryPushedOut(BodyIndex index, const PlacedPose& target, const Block& block);
  planar::Penetration deepestContact(BodyIndex index, const PlacedPose& pose, const Block& block);
  void findDeeper(BodyIndex index, const PlacedPose& pose, const Block& block, Contact& deepest);

  // turret.cpp
  double startTurrets(double step);
  void turn(planar::Turret& turret, double dt);
  bool tryTurned(planar::Turret& turret, const PlacedPose& pose, double angle);
  planar::PlanarPose placeOfHeld(const planar::Turret& turret, double angle) const;
  double trailingAngle(const planar::Turret& turret, const PlacedPose& pose) const;
  void finishTurrets(const MoveAccess& access, double dt);

  bool areAllOutOfReach(const RayBundle& rays) const;
  BodyIndex casterOf(const RayBundle& rays) const;
  double reachBeyond(BodyIndex index, const RayBundle& rays) const;
  bool isClear(BodyIndex index, double distance) const;
  Clearance& clearance(BodyIndex index) { return clearances_[static_cast<std::size_t>(index)]; }
  const Clearance& clearance(BodyIndex index) const { return clearances_[static_cast<std::size_t>(index)]; }
  Neighbours& neighbours(BodyIndex index) { return neighbours_[static_cast<std::size_t>(index)]; }
  const Neighbours& neighbours(BodyIndex index) const { return neighbours_[static_cast<std::size_t>(index)]; }
  Motion& motion(BodyIndex index) { return motions_[static_cast<std::size_t>(index)]; }
  const Motion& motion(BodyIndex index) const { return motions_[static_cast<std::size_t>(index)]; }

  // gripping.cpp
  BodyIndex findGrippable(BodyIndex gripper) const;
  bool mayGrip(BodyIndex index) const;
  bool mayBeGripped(BodyIndex index) const;
  void grip(const Space& space, const ConnectAccess& access, BodyIndex gripper, BodyIndex gripped);
  void join(BodyIndex gripper, BodyIndex gripped);
  void takeOverGrips(const Space& space, BodyIndex index);
  void release(const Space& space, const ConnectAccess& access, BodyIndex gripper);
  void letGo(BodyIndex gripper);
  void forgetGrips(BodyIndex index);
  /// The body that a body grips, or else itself.
  BodyIndex objectOf(BodyIndex index) const {
    const BodyIndex gripped = motion(index).gripped;
    return gripped == kNoBody ? index : gripped;
  }
  bool areConnected(BodyIndex a, BodyIndex b) const { return objectOf(a) == objectOf(b); }
  /// Whether a body grips an object that has other grippers too.
  bool isInGroup(BodyIndex gripper) const {
    const BodyIndex gripped = motion(gripper).gripped;
    return gripped != kNoBody && motion(motion(gripped).gripped_by).next_gripper != kNoBody;
  }

  const Parallel* workers_ = nullptr;   // null: there is one thread
  std::vector<Motion> motions_;         // by body
  std::vector<Clearance> clearances_;   // by body; apart because every step reads all of them
  std::vector<Neighbours> neighbours_;  // by body

  // Bodies by their handling in a tick; each list by entity number.
  bool are_lists_old_ = true;
  std::vector<BodyIndex> movers_;       // driven or gripping; they may carry others, or be carried
  std::vector<BodyIndex> idle_;         // undriven; others may move them
  std::vector<BodyIndex> mirrors_;      // mirrors that may move
  std::vector<BodyIndex> grippers_;     // with a commanded gripper, or holding something
  double smallest_inner_radius_ = 0.0;  // of driven bodies [m]

  std::size_t least_block_ = 1024;    // some 100 microseconds of work
  std::vector<Block> blocks_;         // of movers_
  Block all_;                         // for bodies that move after all blocks
  std::vector<BodyIndex> others_;     // see Block
  std::vector<BodyIndex> strays_;     // see Block
  std::vector<std::int32_t> places_;  // by body: position in movers_
  Islands islands_;                   // of movers_, in the current step

  // Bounds on the motion of any body. With them most bodies need no search in most steps (see Clearance).
  double mirrors_moved_ = 0.0;    // by mirrors, before this tick [m]
  double step_length_ = 0.0;      // in one step of this tick [m]
  double most_pieces_ = 1.0;      // largest number of pieces of such a way
  double travelled_ = 0.0;        // up to the end of the current step, without slides in it [m]
  bool is_somebody_new_ = false;  // clearances are invalid: a body was added, removed or placed
};

}  // namespace swarmanoid::kinematics2d
