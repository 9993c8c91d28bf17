/// Pictures of a world in memory, for programs that show or store them themselves.
///
/// A visualisation that can take them derives from this class besides Observer; programs find it by dynamic_cast. It
/// is configured as for files, with size and camera, but without `write_frames`.
///
/// Threads  one call at a time.
#pragma once

#include <cstdint>
#include <vector>

#include "swarmanoid_space/space.hpp"

namespace swarmanoid {

class PictureSource {
 public:
  /// Red, green and blue of each pixel, row by row from the top: height x width x 3.
  struct Pixels {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb;
  };

  virtual ~PictureSource() = default;
  /// The space as it is. @throws std::runtime_error if a mesh of a robot cannot be read
  virtual Pixels take(const Space& space) = 0;

 protected:
  PictureSource() = default;
  PictureSource(const PictureSource&) = default;
  PictureSource& operator=(const PictureSource&) = default;
};

}  // namespace swarmanoid
