/// The faces of the geometries in a Collada file. Assimp does not check that they have positions, and reserves and
/// copies as much as their counts say.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

#include "xml_tags.hpp"

namespace swarmanoid {

class ColladaShapes {
 public:
  /// @param most upper bound of counts and indices: each item needs a byte of the file
  explicit ColladaShapes(std::size_t most) : most_(most) {}

  /// A tag begins: a <geometry>, its <vertices>, faces such as <triangles>, or a part of these; ignores all others.
  /// @param parent element around it @throws std::runtime_error "line N: found ..."
  void open(const XmlTag& tag, std::string_view parent);
  /// A tag ends. @throws std::runtime_error for a wrong number of lists of indices
  void close(const XmlTag& tag);

  /// Number of corners of each geometry, by id; an upper bound.
  const std::map<std::string, std::size_t>& corners() const { return corners_; }

 private:
  struct Shape {
    std::string_view name;
    std::size_t count = 0;   ///< of faces, as stated in the file
    std::size_t width = 1;   ///< indices per corner
    std::size_t inputs = 0;  ///< without those of <vertices>
    std::size_t lists = 0;   ///< of indices
    bool has_corners = false;
    bool has_vertices = false;
  };

  void openInput(const XmlTag& tag, std::string_view parent);
  void openIndices(const XmlTag& tag);
  void openCorners(const XmlTag& tag);
  void addCorners(std::size_t indices, int line);

  std::size_t most_;
  std::string geometry_;           ///< id of the last <geometry>
  std::size_t vertex_inputs_ = 0;  ///< of its <vertices>, so far
  bool has_positions_ = false;     ///< of the last <mesh>, so far
  Shape shape_;                    ///< around the current tag
  std::size_t all_corners_ = 0;    ///< without copies
  std::map<std::string, std::size_t> corners_;
};

}  // namespace swarmanoid
