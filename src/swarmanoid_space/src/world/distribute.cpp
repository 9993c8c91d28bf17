#include "distribute.hpp"

#include <algorithm>
#include <cmath>

#include "curve_place.hpp"
#include "entities.hpp"
#include "swarmanoid_space/experiment/entity_validation.hpp"

namespace swarmanoid {
namespace {

/// Places the entities of a group one after the other.
class Placing {
 public:
  /// @param is_again the entities exist, and are moved to the places that they would get
  Placing(World& world, const EntityDescription& group, const std::vector<Membership>& memberships, bool is_again)
      : world_(world),
        memberships_(memberships),
        is_again_(is_again),
        distribution_(*group.distribution),
        bounds_(distribution_.bounds()),
        extent_(bounds_.sizes()),
        longer_side_(std::max({extent_.x(), extent_.y(), 1e-9})),
        origin_(originOf(world, group)),
        name_(group.id + "_"),
        model_(is_again ? world.space.entities.model[world.space.entities.find(name_ + "1")] : modelOf(group)),
        random_(world.space.seed, "distribute", group.id),
        entity_(group) {
    entity_.distribution.reset();
    refuseOutside();
  }

  void placeEvenly();
  /// Places each entity at random positions until one is free.
  void placeAtRandom();
  /// Places entities at random so that neighbours in space have close numbers, and so are close in memory: for more
  /// entities than fit into caches. All draw a position; the entities are placed in the order of the positions along
  /// the curve, and those whose position is not free draw again.
  void placeAlongCurve();

 private:
  struct Draw {
    std::uint64_t place = 0;  ///< position along the curve
    Eigen::Vector3d position;
    double heading = 0.0;  ///< rad
  };

  static Eigen::Vector3d originOf(const World& world, const EntityDescription& group);
  /// @throws ConfigError if the area around an entity extends beyond the arena
  void refuseOutside() const;
  /// Returns the position of an entity at even distances.
  Eigen::Vector3d evenPlace(std::size_t number) const;
  Eigen::Vector3d placeInRows(std::size_t number) const;
  Draw nextAtRandom();
  bool tryPlace(const Draw& draw);
  /// Adds the entity, or moves it. @pre the place is free
  void place(const Pose& pose);
  /// Entities that do not count as obstacles of the next one: those that come later, which are not in their places yet.
  Span<const Row> later() const;
  /// rad
  double nextHeading() { return distribution_.random_heading ? random_.uniform(-M_PI, M_PI) : entity_.angles.z(); }
  void nameNext() { entity_.id = name_ + std::to_string(placed_ + 1); }
  [[noreturn]] void refuse() const;

  World& world_;
  const std::vector<Membership>& memberships_;
  bool is_again_;
  const Distribution& distribution_;
  Eigen::AlignedBox3d bounds_;  // of the area [m]
  Eigen::Vector3d extent_;      // of bounds_ [m]
  double longer_side_;          // of the area on the ground [m]
  Eigen::Vector3d origin_;      // of the area's coordinates, in W [m]
  std::string name_;
  std::shared_ptr<const EntityModel> model_;
  RandomStream random_;
  EntityDescription entity_;  // the next one
  std::size_t placed_ = 0;
};

void Placing::refuse() const {
  throw ConfigError(entity_.location, "no free place found for '" + entity_.id + "' of " +
                                          std::to_string(distribution_.quantity) + " in " +
                                          std::to_string(distribution_.max_trials) +
                                          " trials; allow more area or fewer entities");
}

/// Returns the position of the entity at the centre, at height 0.
Eigen::Vector3d Placing::originOf(const World& world, const EntityDescription& group) {
  const std::string& around = group.distribution->around;
  if (around.empty()) {
    return Eigen::Vector3d::Zero();
  }
  const Row row = world.space.entities.find(around);
  if (row == kNoRow) {
    throw ConfigError(group.distribution->location,
                      "around: found '" + around + "', allowed: an entity that stands before this <distribute>");
  }
  const Eigen::Vector3d& position = world.space.entities.pose[row].position;
  return {position.x(), position.y(), 0.0};
}

void Placing::refuseOutside() const {
  if (distribution_.around.empty()) {
    return;  // already checked by validation::check
  }
  for (const Eigen::Vector3d& corner : {bounds_.min(), bounds_.max()}) {
    validation::checkPosition("place around '" + distribution_.around + "'", origin_ + corner, *model_,
                              world_.experiment.arena, distribution_.location);
  }
}

Eigen::Vector3d Placing::evenPlace(std::size_t number) const {
  const auto quantity = static_cast<double>(distribution_.quantity);
  switch (distribution_.area) {
    case Distribution::Area::kDisc:  // refused by the reader
    case Distribution::Area::kBox:
      return placeInRows(number);
    case Distribution::Area::kRing: {
      const double angle = 2.0 * M_PI * static_cast<double>(number) / quantity;
      const double distance = 0.5 * (distribution_.inner_radius + distribution_.radius);
      return distribution_.center + distance * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0);
    }
    case Distribution::Area::kLine:
      break;
  }
  const double share = quantity > 1.0 ? static_cast<double>(number) / (quantity - 1.0) : 0.5;
  return distribution_.pointAt({share, 0.0, 0.0});
}

Eigen::Vector3d Placing::placeInRows(std::size_t number) const {
  const auto quantity = static_cast<double>(distribution_.quantity);
  const double side_by_side = std::ceil(std::sqrt(quantity * extent_.x() / std::max(extent_.y(), 1e-9)));
  const auto columns = static_cast<std::size_t>(std::clamp(side_by_side, 1.0, quantity));
  const std::size_t rows = (distribution_.quantity + columns - 1) / columns;
  const auto middle = [](std::size_t k, std::size_t count) {
    return (static_cast<double>(k) + 0.5) / static_cast<double>(count);
  };
  return distribution_.pointAt({middle(number % columns, columns), middle(number / columns, rows), 0.0});
}

void Placing::placeEvenly() {
  while (placed_ < distribution_.quantity) {
    nameNext();
    random_.startTick(placed_);
    entity_.position = origin_ + evenPlace(placed_);
    entity_.angles.z() = nextHeading();
    if (is_again_) {
      refuseBadPlace(world_, entity_, *model_, poseOf(entity_), memberships_, later());
      place(poseOf(entity_));
    } else {
      addEntity(world_, entity_, memberships_);
      ++placed_;
    }
  }
}

Placing::Draw Placing::nextAtRandom() {
  Draw draw;
  const double u = random_.uniform();
  const double v = random_.uniform();
  const double w = random_.uniform();
  const Eigen::Vector3d point = distribution_.pointAt({u, v, w});
  // for a box, the random shares give the position in the area without rounding errors
  const Eigen::Vector2d within = distribution_.area == Distribution::Area::kBox
                                     ? Eigen::Vector2d(u * extent_.x(), v * extent_.y())
                                     : Eigen::Vector2d((point - bounds_.min()).head<2>().cwiseMax(0.0));
  draw.place = placeOnCurve(within.x() / longer_side_, within.y() / longer_side_);
  draw.position = origin_ + point;
  draw.heading = nextHeading();
  return draw;
}

/// Adds the entity at the drawn place if it is free. @return whether it was
bool Placing::tryPlace(const Draw& draw) {
  entity_.position = draw.position;
  entity_.angles.z() = draw.heading;
  const Pose pose = poseOf(entity_);
  const bool is_free = std::none_of(memberships_.begin(), memberships_.end(), [&](const Membership& membership) {
    return membership.engine->overlap(*model_, pose, later()) != kNoRow;
  });
  if (is_free) {
    place(pose);
  }
  return is_free;
}

void Placing::place(const Pose& pose) {
  if (is_again_) {
    setPose(world_, world_.space.entities.find(entity_.id), pose);
  } else {
    addFreeEntity(world_, entity_, model_, memberships_);
  }
  ++placed_;
}

Span<const Row> Placing::later() const {
  if (!is_again_) {
    return {};
  }
  const std::vector<Row>& order = world_.space.entities.order;
  const auto next = std::find(order.begin(), order.end(), world_.space.entities.find(entity_.id));
  const auto first = static_cast<std::size_t>(next - order.begin());
  return {order.data() + first, order.size() - first};
}

void Placing::placeAtRandom() {
  while (placed_ < distribution_.quantity) {
    nameNext();
    random_.startTick(placed_);
    int trials = 0;
    while (!tryPlace(nextAtRandom())) {
      if (++trials == distribution_.max_trials) {
        refuse();
      }
    }
  }
}

void Placing::placeAlongCurve() {
  std::vector<Draw> draws(distribution_.quantity);
  for (int trial = 0; !draws.empty(); ++trial) {
    nameNext();
    if (trial == distribution_.max_trials) {
      refuse();
    }
    for (std::size_t k = 0; k < draws.size(); ++k) {
      random_.startTick(static_cast<std::uint64_t>(trial) * distribution_.quantity + k);
      draws[k] = nextAtRandom();
    }
    std::stable_sort(draws.begin(), draws.end(),
                     [](const Draw& one, const Draw& other) { return one.place < other.place; });
    for (const Draw& draw : draws) {
      nameNext();
      tryPlace(draw);
    }
    draws.resize(distribution_.quantity - placed_);
  }
}

}  // namespace

void distribute(World& world, const EntityDescription& group, const std::vector<Membership>& memberships,
                bool is_again) {
  constexpr std::size_t kMany = 1000;  // this many robots fit into caches
  Placing placing(world, group, memberships, is_again);
  if (group.distribution->layout == Distribution::Layout::kGrid) {
    placing.placeEvenly();
  } else if (group.distribution->quantity <= kMany) {
    placing.placeAtRandom();
  } else {
    placing.placeAlongCurve();
  }
}

}  // namespace swarmanoid
