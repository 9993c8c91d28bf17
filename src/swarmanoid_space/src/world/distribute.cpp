#include "distribute.hpp"

#include <algorithm>
#include <cmath>

#include "curve_place.hpp"
#include "entities.hpp"

namespace swarmanoid {
namespace {

/// Places the entities of a group one after the other.
class Placing {
 public:
  Placing(World& world, const EntityDescription& group, const std::vector<Membership>& memberships)
      : world_(world),
        memberships_(memberships),
        distribution_(*group.distribution),
        extent_(distribution_.maximum - distribution_.minimum),
        longer_side_(std::max({extent_.x(), extent_.y(), 1e-9})),
        name_(group.id + "_"),
        model_(modelOf(group)),
        random_(world.space.seed, "distribute", group.id),
        entity_(group) {
    entity_.distribution.reset();
  }

  void placeInRows();
  /// Each is tried at random places until it is free somewhere.
  void placeAtRandom();
  /// Likewise, and who is near in space is near in number, and so in memory: for so many that caches do not hold them.
  /// All draw a place, and take these in the order of a curve; those who find theirs taken draw again, and so on.
  void placeAlongCurve();

 private:
  struct Draw {
    std::uint64_t place = 0;  ///< along the curve
    Eigen::Vector3d position;
    double heading = 0.0;  ///< rad
  };

  Draw nextAtRandom();
  bool tryPlace(const Draw& draw);
  /// @param share of the way from minimum to maximum
  Eigen::Vector3d positionAt(const Eigen::Vector3d& share) const {
    return distribution_.minimum + extent_.cwiseProduct(share);
  }
  /// rad
  double nextHeading() { return distribution_.random_heading ? random_.uniform(-M_PI, M_PI) : entity_.angles.z(); }
  void nameNext() { entity_.id = name_ + std::to_string(placed_ + 1); }
  [[noreturn]] void refuse() const;

  World& world_;
  const std::vector<Membership>& memberships_;
  const Distribution& distribution_;
  Eigen::Vector3d extent_;  // m
  double longer_side_;      // of the ground that they are on, m
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

void Placing::placeInRows() {
  const auto quantity = static_cast<double>(distribution_.quantity);
  const double side_by_side = std::ceil(std::sqrt(quantity * extent_.x() / std::max(extent_.y(), 1e-9)));
  const auto columns = static_cast<std::size_t>(std::clamp(side_by_side, 1.0, quantity));
  const std::size_t rows = (distribution_.quantity + columns - 1) / columns;
  const auto middle = [](std::size_t k, std::size_t count) {
    return (static_cast<double>(k) + 0.5) / static_cast<double>(count);
  };
  while (placed_ < distribution_.quantity) {
    nameNext();
    random_.startTick(placed_);
    entity_.position = positionAt({middle(placed_ % columns, columns), middle(placed_ / columns, rows), 0.0});
    entity_.angles.z() = nextHeading();
    addEntity(world_, entity_, memberships_);
    ++placed_;
  }
}

Placing::Draw Placing::nextAtRandom() {
  Draw draw;
  const double u = random_.uniform();
  const double v = random_.uniform();
  const double w = random_.uniform();
  draw.place = placeOnCurve(u * extent_.x() / longer_side_, v * extent_.y() / longer_side_);
  draw.position = positionAt({u, v, w});
  draw.heading = nextHeading();
  return draw;
}

/// Adds the entity there if nothing is in its way.
bool Placing::tryPlace(const Draw& draw) {
  entity_.position = draw.position;
  entity_.angles.z() = draw.heading;
  const Pose pose = poseOf(entity_);
  const bool is_free = std::none_of(memberships_.begin(), memberships_.end(), [&](const Membership& membership) {
    return membership.engine->overlap(*model_, pose, kNoRow) != kNoRow;
  });
  if (is_free) {
    addFreeEntity(world_, entity_, model_, memberships_);
    ++placed_;
  }
  return is_free;
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

void distribute(World& world, const EntityDescription& group, const std::vector<Membership>& memberships) {
  constexpr std::size_t kMany = 1000;  // a thousand robots fit into caches
  Placing placing(world, group, memberships);
  if (group.distribution->layout == Distribution::Layout::kGrid) {
    placing.placeInRows();
  } else if (group.distribution->quantity <= kMany) {
    placing.placeAtRandom();
  } else {
    placing.placeAlongCurve();
  }
}

}  // namespace swarmanoid
