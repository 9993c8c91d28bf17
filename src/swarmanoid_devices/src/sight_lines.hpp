/// Lines of sight from one robot to many points around it: which are free is what Space::isOccluded says, at a fraction
/// of the cost. Most lines pass by everything that is near, which is known by its outline in the positional index.
/// Where one does not, the silhouettes of that one thing say most of the time whether it stands in the way; else its
/// engine is asked (Engine::blocks).
///
/// Threads  each needs a SightLines of its own, and keeps it: its room grows to what was needed, and stays.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "swarmanoid_space/space.hpp"

namespace swarmanoid::devices {

class SightLines {
 public:
  using Place = PositionalIndex::Place;

  /// Looks from another eye, or in another tick. @param self whose eye it is, which hides nothing @param eye in W [m]
  /// @param reach of a sphere around the eye that all points are in [m]
  /// @param near what PositionalIndex::collectPlaces finds in that sphere, made larger by PositionalIndex::prismMargin
  void begin(const Space& space, Row self, const Eigen::Vector3d& eye, double reach, const std::vector<Place>& near);
  /// The same, for those who have not asked the index themselves.
  void begin(const Space& space, Row self, const Eigen::Vector3d& eye, double reach);

  /// Whether something other than self and the owner stands between the eye and a point. @param point in W [m]
  /// @pre begin was called in this tick
  bool isOccluded(const Eigen::Vector3d& point, Row owner);

 private:
  enum class Verdict { kFree, kBlocked, kUnsure };

  bool isBlocked(const PositionalIndex::Outline& outline, const Segment& line, Row owner) const;
  Verdict judge(const PositionalIndex::Outline& outline, const Segment& line) const;

  std::vector<Place> near_;  // scratch of begin
  const Space* space_ = nullptr;
  Row self_ = kNoRow;
  Eigen::Vector3d eye_ = Eigen::Vector3d::Zero();
  double prism_reach_ = 1.0;

  // Outlines of what could hide something, seen from above, column by column so that a line is compared with several at
  // once: in single precision, and larger by what that rounds. The columns are as long as they have ever been; the
  // first `count_` places are in use.
  std::size_t count_ = 0;
  std::vector<const PositionalIndex::Outline*> outlines_;
  std::vector<float> x_;       // of the axes, from the eye [m]
  std::vector<float> y_;       // likewise
  std::vector<float> radius_;  // [m]
  std::vector<float> excess_;  // of the line that is asked about: it passes by if positive
  std::vector<const PositionalIndex::LargeOutline*> large_;
};

}  // namespace swarmanoid::devices
