/// Drawings of an engine's internal state: collision shapes, contacts, joints and forces, as lines in W.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace swarmanoid {

class EngineDrawing {
 public:
  enum class Kind {
    kShape,    ///< outlines of collision shapes
    kContact,  ///< from the contact point along its normal, 5 cm
    kJoint,    ///< grips, ropes, attachments: between the bodies' origins, through the joint
    kForce     ///< forces of drives: kMetresPerNewton long, from the point where they act
  };
  static constexpr std::size_t kKinds = 4;
  static constexpr double kMetresPerNewton = 0.01;

  using Line = std::pair<Eigen::Vector3d, Eigen::Vector3d>;  ///< from, to [m]

  void add(Kind kind, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    lines_[static_cast<std::size_t>(kind)].emplace_back(from, to);
  }
  const std::vector<Line>& lines(Kind kind) const { return lines_[static_cast<std::size_t>(kind)]; }
  /// Keeps its memory.
  void clear() {
    for (std::vector<Line>& lines : lines_) {
      lines.clear();
    }
  }

 private:
  std::array<std::vector<Line>, kKinds> lines_;
};

}  // namespace swarmanoid
