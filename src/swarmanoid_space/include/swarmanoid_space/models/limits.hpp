/// The bounds of what can be simulated, in one place: of every length, place, mass, angle and count that enters the
/// space, by file, by --set, by service or from code. Within them engines and the index compute; beyond them single
/// precision, integers or memory end. docs/reference/experiment_file.md has them as a table.
///
/// SI units; angles as files have them, in degrees.
#pragma once

#include <chrono>
#include <cstddef>

#include "swarmanoid_interface/configuration.hpp"

namespace swarmanoid::limits {

// Places and lengths [m].

/// Of a side of the arena. Below, no robot has room; at 10 km a double still resolves 2 pm, so contacts and rays are
/// exact, and the grids of the look-ups have cells of 10 m at most.
constexpr Range kArenaSide{0.1, 10000.0};
/// Of any coordinate: of what stands around the arena, of planes, grounds and boxes. As far on either side as the arena
/// may be long.
constexpr Range kCoordinate{-10000.0, 10000.0};
/// Of bodies and heightfields. A sheet of paper is as thin as the least; what is longer than the most fits into no
/// arena. Engines with coarser tolerances refuse what is too thin for them.
constexpr Range kLength{0.0001, 10000.0};
/// Of a floor patch or a hole; 0 where it is not used. Nothing collides with it, so it may be as thin as it likes.
constexpr Range kPatch{0.0, 10000.0};
/// Between neighbours of a heightfield's vertices: a robot stands on some ten thousand triangles then.
constexpr double kLeastTerrainStep = 0.001;
/// Of paint on the floor [s]; 0: it does not fade.
constexpr Range kHalfLife{0.0, 1e9};
/// Of white over black in a heightfield.
constexpr Range kTerrainHeight{0.0, 1000.0};

/// Of a turn [deg]: a hundred times around. Beyond, degrees would lose digits that count.
constexpr Range kTurn{-36000.0, 36000.0};

/// Of what can move [kg]. Solvers add up masses that touch: a thousand tonnes beside a gram is the most that the
/// fifteen digits of a double keep apart with forces in between.
constexpr Range kMass{0.001, 1e6};
/// Of parameters of engines that are multiplied with each other (frictions, gravity, strengths), unless they are 0:
/// below it they change nothing that can be seen, and products of several would leave the range of a double.
constexpr double kLeastFactor = 1e-9;
/// Of gravity [m/s2]: ten times that of the Earth. Beyond, steps of 10 ms are too long for what rests.
constexpr Range kGravity{0.0, 100.0, kLeastFactor};
/// That a grip, a hand or a magnet holds [N].
constexpr Range kStrength{0.0, 1e6, kLeastFactor};
/// Coefficients of Coulomb friction.
constexpr Range kFriction{0.0, 10.0, kLeastFactor};
/// Part of the speed of an impact that comes back.
constexpr Range kRestitution{0.0, 1.0, kLeastFactor};

// Counts.

/// Entities in one arena: a million robots take 2 GB.
constexpr std::size_t kMostEntities = 1000000;
/// Engines in one experiment, each with a world of its own.
constexpr std::size_t kMostEngines = 100;
/// Characters of an experiment file; one with a million entities spelled out has half of them.
constexpr std::size_t kLongestText = std::size_t{1} << 28U;

/// Ticks of a run, as files, options and parameters may ask for them: a double, as which they travel, counts them all.
constexpr Range kTicks{1.0, 1e15};
/// Seeds in files and parameters, likewise. `--seed` takes any number of 64 bits.
constexpr Range kSeed{0.0, 9e15};
/// Threads of a run.
constexpr Range kThreads{1.0, 1024.0};

/// How long a run may be, in simulated time: a hundred years of 365 days. Nanoseconds fit 292 years, ROS time 136.
constexpr std::chrono::hours kLongestRun{24 * 365 * 100};

/// Whether simulated time may go so many times as fast as real time: 0 stands for as fast as possible, and a factor
/// below 1e-6 would wait for days between ticks.
constexpr bool isRealTimeFactor(double factor) { return factor == 0.0 || (factor >= 1e-6 && factor <= 1e6); }
constexpr const char* kRealTimeFactors = "0, or a number from 1e-06 to 1000000";

}  // namespace swarmanoid::limits
