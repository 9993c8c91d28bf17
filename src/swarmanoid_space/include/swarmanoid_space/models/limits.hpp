/// The limits of the simulation in one place: of every length, position, mass, angle and count that enters the space by
/// file, by --set, by service or from code. Within them, engines and the index compute correctly; beyond them, single
/// precision, integers or memory do not suffice. docs/reference/experiment_file.md has them as a table.
///
/// SI units; angles as files have them, in degrees.
#pragma once

#include <chrono>
#include <cstddef>

#include "swarmanoid_interface/configuration.hpp"

namespace swarmanoid::limits {

// Positions and lengths [m].

/// Side of the arena. Below the minimum no robot fits in; at 10 km a double still resolves 2 pm, so contacts and rays
/// are exact, and the grids of the look-ups have cells of at most 10 m.
constexpr Range kArenaSide{0.1, 10000.0};
/// Any coordinate: of the surroundings of the arena, of planes, grounds and boxes. On both sides as large as the
/// maximum side of the arena.
constexpr Range kCoordinate{-10000.0, 10000.0};
/// Lengths of bodies and heightfields. The minimum is the thickness of a sheet of paper; no arena has room for lengths
/// above the maximum. Engines with coarser tolerances refuse bodies that are too thin for them.
constexpr Range kLength{0.0001, 10000.0};
/// Size of a floor patch or a hole; 0 if it is not used. Nothing collides with it, so it may be arbitrarily thin.
constexpr Range kPatch{0.0, 10000.0};
/// Minimum distance of neighbouring vertices of a heightfield: a robot then stands on some ten thousand triangles.
constexpr double kLeastTerrainStep = 0.001;
/// Half-life of paint on the floor [s]; 0: it does not fade.
constexpr Range kHalfLife{0.0, 1e9};
/// Height of white over black in a heightfield.
constexpr Range kTerrainHeight{0.0, 1000.0};

/// A turn [deg]: a hundred full turns. Larger numbers of degrees would lose significant digits.
constexpr Range kTurn{-36000.0, 36000.0};

/// Mass of a movable body [kg]. Solvers add masses in contact: with forces in between, the fifteen digits of a double
/// can represent at most a thousand tonnes beside a gram.
constexpr Range kMass{0.001, 1e6};
/// Minimum of parameters of engines that are multiplied with each other (frictions, gravity, strengths), unless they
/// are 0. Smaller values have no visible effect, and products of several would leave the range of a double.
constexpr double kLeastFactor = 1e-9;
/// Gravity [m/s2]: up to ten times that of the Earth. Above, steps of 10 ms are too long for resting bodies.
constexpr Range kGravity{0.0, 100.0, kLeastFactor};
/// Strength of a grip, a hand or a magnet [N].
constexpr Range kStrength{0.0, 1e6, kLeastFactor};
/// Coefficients of Coulomb friction.
constexpr Range kFriction{0.0, 10.0, kLeastFactor};
/// Restitution: ratio of the speeds after and before an impact.
constexpr Range kRestitution{0.0, 1.0, kLeastFactor};

// Counts.

/// Entities in one arena: a million robots take 2 GB.
constexpr std::size_t kMostEntities = 1000000;
/// Engines in one experiment, each with a world of its own.
constexpr std::size_t kMostEngines = 100;
/// Characters of an experiment file; a file that lists a million entities has half of them.
constexpr std::size_t kLongestText = std::size_t{1} << 28U;

/// Ticks of a run in files, options and parameters. They are transported as double, which represents all of them.
constexpr Range kTicks{1.0, 1e15};
/// The number of a tick; 0: before the first.
constexpr Range kTick{0.0, kTicks.maximum};
/// Seeds in files and parameters, for the same reason. `--seed` takes any number of 64 bits.
constexpr Range kSeed{0.0, 9e15};
/// Threads of a run.
constexpr Range kThreads{1.0, 1024.0};

/// How long a run may be, in simulated time: a hundred years of 365 days. Nanoseconds fit 292 years, ROS time 136.
constexpr std::chrono::hours kLongestRun{24 * 365 * 100};

/// Whether a real-time factor is allowed: 0 means as fast as possible; below 1e-6 a run would wait for days between
/// two ticks.
constexpr bool isRealTimeFactor(double factor) { return factor == 0.0 || (factor >= 1e-6 && factor <= 1e6); }
constexpr const char* kRealTimeFactors = "0, or a number from 1e-06 to 1000000";

}  // namespace swarmanoid::limits
