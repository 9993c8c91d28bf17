#include "dynamics2d/solver/island.hpp"

#include <algorithm>
#include <limits>

namespace swarmanoid::dynamics2d {
namespace {

/// Islands of at most this many constraints, by countConstraints, are solved and corrected more exactly than others.
constexpr std::size_t kSmall = 24;
/// Limit of the force of a mirror, since nothing can hold it back [N].
constexpr double kMirrorForce = 500.0;

template <class Visit>
void visitShapes(const Island::Outline& a, const Island::Outline& b, Visit visit) {
  for (std::size_t i = 0; i < a.shapes->size(); ++i) {
    for (std::size_t k = 0; k < b.shapes->size(); ++k) {
      if ((*a.shapes)[i].band.overlaps((*b.shapes)[k].band, a.along, b.along)) {
        visit(i, k);
      }
    }
  }
}

template <class Constraints>
void startAll(Constraints& constraints, SolverBodies& bodies) {
  for (auto& constraint : constraints) {
    constraint.start(bodies);
  }
}

/// Whether one of a constraint's bodies has changed since the constraint was solved in the last sweep.
bool mayChange(const SolverBody& body, int sweep) { return body.last_change >= sweep - 1; }
bool mayChange(const ContactConstraint& contact, const SolverBodies& bodies, int sweep) {
  return mayChange(bodies[static_cast<std::size_t>(contact.a)], sweep) ||
         mayChange(bodies[static_cast<std::size_t>(contact.b)], sweep);
}
bool mayChange(const GripConstraint& grip, const SolverBodies& bodies, int sweep) {
  return mayChange(bodies[static_cast<std::size_t>(grip.gripper)], sweep) ||
         mayChange(bodies[static_cast<std::size_t>(grip.held)], sweep);
}
template <class Constraint>
bool mayChange(const Constraint& constraint, const SolverBodies& bodies, int sweep) {
  return mayChange(bodies[static_cast<std::size_t>(constraint.body)], sweep);
}

void noteChange(const ContactConstraint& contact, SolverBodies& bodies, int sweep) {
  bodies[static_cast<std::size_t>(contact.a)].noteChange(sweep);
  bodies[static_cast<std::size_t>(contact.b)].noteChange(sweep);
}
void noteChange(const GripConstraint& grip, SolverBodies& bodies, int sweep) {
  bodies[static_cast<std::size_t>(grip.gripper)].noteChange(sweep);
  bodies[static_cast<std::size_t>(grip.held)].noteChange(sweep);
}
template <class Constraint>
void noteChange(const Constraint& constraint, SolverBodies& bodies, int sweep) {
  bodies[static_cast<std::size_t>(constraint.body)].noteChange(sweep);
}

/// @return whether a constraint has changed a velocity by more than `settled` [m/s]
template <class Constraints>
bool solveAll(Constraints& constraints, SolverBodies& bodies, int sweep, double settled) {
  bool has_changed = false;
  for (auto& constraint : constraints) {
    if (mayChange(constraint, bodies, sweep) && constraint.solve(bodies) > settled) {
      noteChange(constraint, bodies, sweep);
      has_changed = true;
    }
  }
  return has_changed;
}

/// Gap between facing shapes, at most `margin` [m].
double gapBetween(const ContactShape& shape_a, const planar::PlacedPose& a, const ContactShape& shape_b,
                  const planar::PlacedPose& b, double margin) {
  const ContactPatch patch = findPatch(shape_a, a, shape_b, b, margin);
  double gap = margin;
  for (int i = 0; i < patch.count; ++i) {
    gap = std::min(gap, facingAt(patch, i, a, b).gap);
  }
  return gap;
}

}  // namespace

void Island::clear() {
  bodies.clear();
  treels.clear();
  supports.clear();
  flights.clear();
  grips.clear();
  pairs.clear();
  outlines_.clear();
  contacts_.clear();
}

int Island::add(const SolverBody& body, const Outline& outline) {
  bodies.push_back(body);
  outlines_.push_back(outline);
  return static_cast<int>(bodies.size()) - 1;
}

void Island::move(double step, const IslandRules& rules) {
  constexpr double kSlowestBounce = 0.01;  // m/s
  findContacts(step, rules);
  startFromLastStep();
  solve(rules.iterations);
  for (SolverBody& body : bodies) {
    body.advance(step);
    body.shifted = 0.0;
  }
  if (rules.restitution > 0.0) {
    for (ContactConstraint& contact : contacts_) {
      contact.bounce(bodies, rules.restitution, kSlowestBounce);
    }
  }
  correct();
}

void Island::findContacts(double step, const IslandRules& rules) {
  // a body that is hit may be as fast as the fastest
  double fastest = highest_speed;
  for (const SolverBody& body : bodies) {
    fastest = std::max(fastest, body.velocity.norm());
  }
  reach_ = 2.0 * fastest * step + kContactMargin;
  std::swap(contacts_, last_);
  contacts_.clear();
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    findContactsOf(static_cast<int>(i), step, rules);
  }
}

void Island::findContactsOf(int pair_index, double step, const IslandRules& rules) {
  const BodyPair& pair = pairs[static_cast<std::size_t>(pair_index)];
  const Outline& a = outlines_[static_cast<std::size_t>(pair.a)];
  const Outline& b = outlines_[static_cast<std::size_t>(pair.b)];
  const planar::PlacedPose& pose_a = bodies[static_cast<std::size_t>(pair.a)].pose;
  const planar::PlacedPose& pose_b = bodies[static_cast<std::size_t>(pair.b)].pose;
  visitShapes(a, b, [&](std::size_t i, std::size_t k) {
    ContactConstraint contact;
    contact.patch = findPatch((*a.shapes)[i], pose_a, (*b.shapes)[k], pose_b, reach_);
    if (contact.patch.count == 0) {
      return;
    }
    contact.a = pair.a;
    contact.b = pair.b;
    contact.pair = pair_index;
    contact.shapes = static_cast<std::uint32_t>(i << 16U | k);
    contact.friction = rules.friction;
    contact.most = pair.kind == BodyPair::Kind::kMirror ? kMirrorForce * step : std::numeric_limits<double>::infinity();
    contact.prepare(bodies, step);
    contacts_.push_back(contact);
  });
}

void Island::startFromLastStep() {
  startAll(treels, bodies);
  startAll(supports, bodies);
  startAll(flights, bodies);
  startAll(grips, bodies);
  auto before = last_.cbegin();
  for (ContactConstraint& contact : contacts_) {
    while (before != last_.cend() && before->pair < contact.pair) {
      ++before;
    }
    for (auto same = before; same != last_.cend() && same->pair == contact.pair; ++same) {
      if (same->shapes == contact.shapes) {
        contact.startFrom(*same, bodies);
      }
    }
  }
  last_.clear();
}

std::size_t Island::countConstraints() const {
  return contacts_.size() + grips.size() + 2 * treels.size() + 4 * supports.size() + flights.size() + 1;
}

bool Island::isLarge() const { return countConstraints() > kSmall; }

void Island::solve(int most_sweeps) {
  // Errors that remain in a large island at the limit of sweeps are corrected in positions; the next step continues.
  constexpr double kExact = 1e-6;    // m/s
  constexpr double kSettled = 2e-5;  // m/s
  constexpr std::size_t kMostWork = 4000;
  constexpr std::size_t kLeastSweeps = 12;
  const bool is_large = isLarge();
  const double settled = is_large ? kSettled : kExact;
  const std::size_t fit = is_large ? kMostWork / countConstraints() : static_cast<std::size_t>(most_sweeps);
  const int sweeps = std::min(most_sweeps, static_cast<int>(std::max(kLeastSweeps, fit)));
  for (SolverBody& body : bodies) {
    body.last_change = 0;
  }
  for (TreelConstraint& treel : treels) {
    treel.is_exact = !is_large;
  }
  bool has_changed = true;
  for (int i = 0; i < sweeps && has_changed; ++i) {
    has_changed = solveAll(treels, bodies, i, settled);
    has_changed = solveAll(supports, bodies, i, settled) || has_changed;
    has_changed = solveAll(flights, bodies, i, settled) || has_changed;
    has_changed = solveAll(grips, bodies, i, settled) || has_changed;
    has_changed = solveAll(contacts_, bodies, i, settled) || has_changed;
  }
}

void Island::correct() {
  constexpr int kMostCorrections = 40;
  constexpr double kExact = 2e-5;   // m
  constexpr double kEnough = 1e-4;  // m
  const bool is_large = isLarge();
  if (is_large && grips.empty()) {
    crowd_correction_.correct(bodies, contacts_, kEnough);
    return;
  }
  const double allowed = is_large ? kEnough : kExact;
  for (int i = 0; i < kMostCorrections; ++i) {
    double wrong = 0.0;
    for (const GripConstraint& grip : grips) {
      wrong = std::max(wrong, grip.correct(bodies));
    }
    for (ContactConstraint& contact : contacts_) {
      wrong = std::max(wrong, contact.correct(bodies));
    }
    if (wrong <= allowed) {
      return;
    }
  }
}

double Island::gapOf(const BodyPair& pair, double margin) const {
  const Outline& a = outlines_[static_cast<std::size_t>(pair.a)];
  const Outline& b = outlines_[static_cast<std::size_t>(pair.b)];
  double gap = margin;
  visitShapes(a, b, [&](std::size_t i, std::size_t k) {
    gap = std::min(gap, gapBetween((*a.shapes)[i], bodies[static_cast<std::size_t>(pair.a)].pose, (*b.shapes)[k],
                                   bodies[static_cast<std::size_t>(pair.b)].pose, margin));
  });
  return gap;
}

double Island::gapAround(int body, const std::vector<ContactShape>& shapes, double margin) const {
  const Outline own{&shapes, outlines_[static_cast<std::size_t>(body)].along};
  double gap = margin;
  for (const BodyPair& pair : pairs) {
    if (pair.a != body && pair.b != body) {
      continue;
    }
    const int other = pair.a == body ? pair.b : pair.a;
    const Outline& outline = outlines_[static_cast<std::size_t>(other)];
    visitShapes(own, outline, [&](std::size_t i, std::size_t k) {
      gap = std::min(gap, gapBetween(shapes[i], bodies[static_cast<std::size_t>(body)].pose, (*outline.shapes)[k],
                                     bodies[static_cast<std::size_t>(other)].pose, margin));
    });
  }
  return gap;
}

}  // namespace swarmanoid::dynamics2d
