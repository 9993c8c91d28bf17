/// The two-dimensional kinematic engine (thesis 3.5.1): bodies in a plane go where their velocities take them.
///
/// There are no masses and no forces. Bodies move one after another, in the order of their entity numbers, so results
/// do not depend on anything else; those that cannot meet in a step do so at once, on all threads, which comes to the
/// same. A body that would overlap another advances to contact and slides along it: its new
/// pose is pushed out of what it overlaps by the shortest way, so that a robot with its nose at a wall can turn, and
/// slips back by as much as its nose needs. Where there is no room for that, it goes as much of its way, and then makes
/// as much of its turn, as is free. Nothing overlaps after a tick. A mirror (an entity that another engine moves) may
/// come to overlap a body through no doing of this engine; such a pair hinders a body only from going deeper. Where
/// others are near, a body moves in pieces of half its inner radius, so nothing fast jumps through a thin wall.
///
/// Wheels are integrated exactly along the arc. What would lead out of the plane is dropped: an eyebot flies the part
/// of its velocity that lies in the plane. A footbot can grip a prey, or a robot without a drive, such as a handbot,
/// not another footbot, nor what flies. There are no chains: who is gripped grips nothing, and who grips is not
/// gripped. A prey is gripped by one footbot at a time, a handbot by any number; both keep their place in the gripper
/// to the last digits. What several hold goes the mean of the ways, and makes the mean of the turns, that each of them
/// alone would give it; they go along, all of them as far as all have room.
///
/// Turrets turn after all bodies have moved, at the commanded speed; what the gripper holds turns with them
/// around the robot, unless others hold it too: then the turret stands. One that would overlap another with its gripper
/// or with what that holds turns as far as is free. What a passive one holds trails behind the robot like a trailer:
/// its centre is never moved to the side.
///
/// Rays hit bodies as prisms over their planar shapes. A mirror of what another engine moves is not hit: that engine
/// answers for it.
#pragma once

#include <algorithm>
#include <vector>

#include "kinematics2d/huddles.hpp"
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

constexpr double kMostPush = 0.005;  ///< of a body out of what it overlaps, beyond the way of its step [m]: a nose that
                                     ///< turns at a wall needs less

/// How long a body need not look around, since all were so far away when it last did. Distances are those by which any
/// body can have moved since the engine began, as Kinematics2d counts them.
struct Clearance {
  double free_until = -1.0;            ///< up to this distance nothing can have come near
  double look_ahead = kMostLookAhead;  ///< how far the next look goes [m]
  bool at_all_heights = false;         ///< also nothing above or below
};

/// The state of a body in this engine, beside its pose and its clearance. Of those that move without looking around
/// it is not read.
struct Motion {
  planar::PlanarPose pose_at_start;  ///< of the tick

  // Gripping: a gripped body goes where its gripper goes. Who grips has no clearance.
  BodyIndex gripped = kNoBody;
  BodyIndex gripped_by = kNoBody;       ///< the first of its grippers, by entity number
  BodyIndex next_gripper = kNoBody;     ///< that grips the same, by entity number
  planar::PlanarPose place_of_gripped;  ///< in this gripper's frame, from the moment of gripping
};

class Kinematics2d final : public planar::PlanarEngine {
 public:
  static PluginDescription describe();

  std::string unsupportedGripReason(const Space& space, Row gripper) const override;
  void add(Space& space, Row row, Role role) override;
  void remove(Space& space, Row row) override;
  void place(Space& space, Row row) override;
  void clear() override {
    bodies_.clear();
    motions_.clear();
    clearances_.clear();
    neighbours_.clear();
    is_somebody_new_ = true;
    are_lists_old_ = true;
  }
  void takeWorkers(const Parallel& workers) override {
    workers_ = &workers;
    are_lists_old_ = true;
  }
  /// How many bodies a thread moves at least, if there are several; 0: all move one after another. Results do not
  /// depend on it.
  void setLeastBlock(std::size_t size) {
    least_block_ = size;
    are_lists_old_ = true;
  }
  void readMirrors(const Space& space) override;
  void move(Space& space, Duration dt) override;
  void connect(Space& space) override;
  bool mayHit(const RayBundle& rays) const override;
  void findObstacles(const RayBundle& rays, Obstacles& found) const override;
  void raycast(const RayBundle& rays, Span<RayHit> hits) const override;
  void draw(EngineDrawing& drawing) const override;

 private:
  /// A stretch of movers_, which one thread looks at, and moves, in a step.
  struct Block {
    std::size_t first = 0;         ///< in movers_
    std::size_t last = 0;          ///< one more than the last
    std::size_t other_count = 0;   ///< of others_, from `first` on: they move once all blocks have
    std::size_t stray_count = 0;   ///< of strays_, from `first` on: they have come into other cells
    double fastest_squared = 0.0;  ///< [m2/s2]
    double detour = 0.0;           ///< beyond the stride, by who was pushed out in this step, at most [m]
  };
  struct Contact {
    planar::Penetration way_out;
    EntityNumber with = kNoEntity;  ///< the other one
  };
  static constexpr std::int32_t kNoPlace = -1;

  // free_motion.cpp
  void listBodies();
  void listBlocks();
  template <class Work>
  void forBlocks(Work work);
  double readAllCommands(const Space& space);
  /// Who grips has no clearance. @param room what a clearance must hold for who moves freely [m]
  bool hasRoomOrStands(BodyIndex index, double room) const {
    return clearance(index).free_until >= room ||
           (bodies_[index].isCommandedToStand() && motion(index).gripped == kNoBody);
  }
  /// Who may move with its block: who has no drive may be carried, and cells do not hold what is large.
  static bool movesByItself(const Body& body) { return body.isDriven() && !body.is_large; }
  void moveBlocks(Space& space, double step, double tick);
  void moveBlock(Space& space, double step, double tick, double room, Block& block);
  void finishTick(Space& space, double tick);
  void finishBody(Space& space, BodyIndex index, const planar::PlanarPose& before, double tick) const;
  /// Calls visit(index) for those who did not move with their block in this step, by entity number.
  template <class Visit>
  void visitOthers(Visit visit) const {
    for (const Block& block : blocks_) {
      for (std::size_t k = 0; k < block.other_count; ++k) {
        visit(others_[block.first + k]);
      }
    }
  }

  // huddles.cpp
  void findRoom(double room, const Block& block);
  void lookAround(std::size_t k, double detour, const Block& block);
  void joinHuddle(std::size_t k, BodyIndex other, const Block& block);
  bool knowsWhoIsNear(BodyIndex index, double detour);
  bool isHeldOrHolds(BodyIndex index) const {
    return motion(index).gripped != kNoBody || motion(index).gripped_by != kNoBody;
  }
  /// In movers_.
  std::int32_t place(BodyIndex index) const { return places_[static_cast<std::size_t>(index)]; }
  /// Whether a body moves while another block does.
  bool isOfOtherBlock(BodyIndex index, const Block& block) const {
    const std::int32_t at = place(index);
    return at != kNoPlace && (static_cast<std::size_t>(at) < block.first || static_cast<std::size_t>(at) >= block.last);
  }

  // motion.cpp. Parameters `block`: that of the body, while all blocks move at once; all_, while nobody else moves.
  void startTick(const Space& space, double step);
  void moveBody(BodyIndex index, double dt, Block& block);
  int piecesOf(const Body& body, double dt) const;
  /// Where a body comes if nobody is in its way: to the last bit the same whether it looks around, in pieces, or not,
  /// for that depends on the number of threads.
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
  /// Calls visit(other) for those that may be so near to a position, until it returns false; while blocks move, for
  /// those that the body may meet. @param near of a body there; null: there is no list
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
  /// Up to the end of the step under way, as far as is known while blocks move [m].
  double travelled(const Block& block) const { return travelled_ + block.detour; }
  /// Up to what distance travelled others leave so wide a gap, into which both sides go [m].
  double freeUntil(double gap, const Block& block) const {
    constexpr double kMargin = 1e-6;  // m, for rounding
    return travelled(block) + 0.5 * (gap - kMargin);
  }
  /// How far to look the next time, if somebody is that near [m].
  double lookAheadFor(double nearest) const {
    return std::min(kMostLookAhead, 2.0 * (std::max(0.0, nearest) + stride_));
  }
  /// A mirror that moves may change its height before the body comes.
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
  void finishTurrets(Space& space, double dt);

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
  void grip(Space& space, BodyIndex gripper, BodyIndex gripped);
  void join(BodyIndex gripper, BodyIndex gripped);
  void takeOverGrips(const Space& space, BodyIndex index);
  void release(Space& space, BodyIndex gripper);
  void letGo(BodyIndex gripper);
  void forgetGrips(BodyIndex index);
  /// What a body grips, or else itself.
  BodyIndex objectOf(BodyIndex index) const {
    const BodyIndex gripped = motion(index).gripped;
    return gripped == kNoBody ? index : gripped;
  }
  bool areConnected(BodyIndex a, BodyIndex b) const { return objectOf(a) == objectOf(b); }
  /// Whether a body grips what others grip too.
  bool isInGroup(BodyIndex gripper) const {
    const BodyIndex gripped = motion(gripper).gripped;
    return gripped != kNoBody && motion(motion(gripped).gripped_by).next_gripper != kNoBody;
  }

  const Parallel* workers_ = nullptr;   // null: there is one thread
  std::vector<Motion> motions_;         // by body
  std::vector<Clearance> clearances_;   // by body, apart because all of them are read in every step
  std::vector<Neighbours> neighbours_;  // by body

  // Bodies by what is to be done with them in a tick, by entity number.
  bool are_lists_old_ = true;
  std::vector<BodyIndex> movers_;       // drive, or grip: these may take along others, or be taken
  std::vector<BodyIndex> idle_;         // may be moved by others
  std::vector<BodyIndex> mirrors_;      // that may move
  std::vector<BodyIndex> grippers_;     // with grippers that are commanded, or that hold something
  double smallest_inner_radius_ = 0.0;  // of those that are driven [m]

  std::size_t least_block_ = 1024;    // some 100 microseconds of work
  std::vector<Block> blocks_;         // of movers_
  Block all_;                         // that they move in once all blocks have moved
  std::vector<BodyIndex> others_;     // see Block
  std::vector<BodyIndex> strays_;     // see Block
  std::vector<std::int32_t> places_;  // by body: in movers_
  Huddles huddles_;                   // of movers_, in the step under way

  // Bounds on how far any body moves: most bodies then need not look around in most steps (see Clearance).
  double mirrors_moved_ = 0.0;    // by at most, before this tick [m]
  double stride_ = 0.0;           // in one step of this tick [m]
  double most_pieces_ = 1.0;      // that any way of such a step is gone in
  double travelled_ = 0.0;        // up to the end of the step under way, but for detours in it [m]
  bool is_somebody_new_ = false;  // clearances hold no longer: a body came, or was put elsewhere
};

}  // namespace swarmanoid::kinematics2d
