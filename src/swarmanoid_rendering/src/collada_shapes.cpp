#include "collada_shapes.hpp"

#include <algorithm>
#include <set>

#include "mesh_checks.hpp"
#include "xml_values.hpp"

namespace swarmanoid {
namespace {

constexpr std::size_t kMostOffset = 1000;  // of an input within the indices of a corner
constexpr std::size_t kMostInputs = 32;    // assimp copies a value per input and corner

bool isShape(std::string_view name) {
  static const std::set<std::string_view> kShapes{"triangles",  "polylist", "polygons", "lines",
                                                  "linestrips", "trifans",  "tristrips"};
  return kShapes.count(name) != 0;
}

/// Whether assimp reads this input; it ignores the offset of others.
bool isSemantic(std::string_view name) {
  static const std::set<std::string_view> kSemantics{"BINORMAL",    "COLOR",      "NORMAL",   "POSITION", "TANGENT",
                                                     "TEXBINORMAL", "TEXTANGENT", "TEXCOORD", "VERTEX"};
  return kSemantics.count(name) != 0;
}

}  // namespace

void ColladaShapes::open(const XmlTag& tag, std::string_view parent) {
  if (tag.name == "geometry") {
    geometry_ = attributeOf(tag, "id");
    vertex_inputs_ = 0;
  } else if (tag.name == "mesh") {
    has_positions_ = false;
  } else if (isShape(tag.name)) {
    if (!has_positions_) {
      refuseAt(tag.line,
               "<" + std::string(tag.name) + "> before positions, allowed: after <vertices> with an input POSITION");
    }
    shape_ = Shape{tag.name, numberOf(tag, "count", 0, most_)};
  } else if (tag.name == "input") {
    openInput(tag, parent);
  } else if (tag.name == "p") {
    openIndices(tag);
  } else if (tag.name == "vcount") {
    openCorners(tag);
  }
}

void ColladaShapes::openInput(const XmlTag& tag, std::string_view parent) {
  const std::size_t offset = numberOf(tag, "offset", 0, kMostOffset);
  if (attributeOf(tag, "source") == "#") {
    refuseAt(tag.line, "source='#' of <input>, allowed: '#' and an id");
  }
  const std::string semantic = attributeOf(tag, "semantic");
  if (!isSemantic(semantic)) {
    return;
  }
  std::size_t& inputs = parent == "vertices" ? vertex_inputs_ : shape_.inputs;
  if (++inputs > kMostInputs) {
    refuseAt(tag.line, "more than " + std::to_string(kMostInputs) + " <input>, allowed: fewer");
  }
  has_positions_ = has_positions_ || (parent == "vertices" && semantic == "POSITION");
  shape_.has_vertices = shape_.has_vertices || semantic == "VERTEX";
  shape_.width = std::max(shape_.width, offset + 1);
}

void ColladaShapes::openIndices(const XmlTag& tag) {
  if (shape_.name == "polylist" && !shape_.has_corners) {
    refuseAt(tag.line, "<p> without <vcount> before it, allowed: after the numbers of corners");
  }
  std::size_t indices = 0;
  forWords(textOf(tag), [&](std::string_view word) {
    numberIn(word, "an index", tag.line, most_);  // assimp never returns from another word
    ++indices;
  });
  if (shape_.name.empty()) {
    return;
  }
  if (indices > 0 && !shape_.has_vertices) {
    refuseAt(tag.line, "<p> without an input VERTEX before it, allowed: after it");
  }
  // only triangles and polylists with count 0 may have lists without indices
  shape_.lists += indices > 0 || shape_.count > 0 || shape_.name == "polygons" ? 1 : 0;
  if ((shape_.name == "trifans" || shape_.name == "tristrips") && indices < 3 * shape_.width) {
    refuseAt(tag.line, std::to_string(indices) + " indices in <" + std::string(shape_.name) + ">, allowed: at least " +
                           std::to_string(3 * shape_.width) + ", for three corners");
  }
  addCorners(indices, tag.line);
}

void ColladaShapes::addCorners(std::size_t indices, int line) {
  const std::size_t shared = shape_.name == "tristrips" ? 3 : shape_.name == "linestrips" ? 2 : 1;
  // strips copy shared corners; a list without corners still becomes a face in memory
  const std::size_t corners = std::max<std::size_t>(1, indices / shape_.width * shared);
  corners_[geometry_] += corners;
  all_corners_ += corners;
  if (all_corners_ > kMostDrawnCorners) {
    refuseAt(line, "more than " + std::to_string(kMostDrawnCorners) + " corners, allowed: fewer");
  }
}

void ColladaShapes::openCorners(const XmlTag& tag) {
  shape_.has_corners = true;
  std::size_t corners = 0;
  forWords(textOf(tag), [&](std::string_view word) {
    const std::size_t number = numberIn(word, "a number of corners", tag.line, kMostCorners);
    if (number == 0) {
      refuseAt(tag.line, "a face of 0 corners, allowed: from 1 to " + std::to_string(kMostCorners));
    }
    corners += number;
  });
  if (corners > most_) {
    refuseAt(tag.line, std::to_string(corners) + " corners, allowed: as many as there are");
  }
}

void ColladaShapes::close(const XmlTag& tag) {
  if (!isShape(tag.name)) {
    return;
  }
  // another number of lists fails an assertion of assimp
  const bool has_one_list = shape_.name == "triangles" || shape_.name == "polylist";
  const std::size_t lists = has_one_list ? std::min<std::size_t>(shape_.count, 1) : shape_.count;
  if ((has_one_list || shape_.name == "polygons") && shape_.lists != lists) {
    refuseAt(tag.line, std::to_string(shape_.lists) + " <p> in <" + std::string(shape_.name) + "> of count " +
                           std::to_string(shape_.count) + ", allowed: " + std::to_string(lists));
  }
  shape_ = Shape{};
}

}  // namespace swarmanoid
