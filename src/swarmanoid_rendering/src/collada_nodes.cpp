#include "collada_nodes.hpp"

#include <algorithm>

#include "mesh_checks.hpp"
#include "xml_values.hpp"

namespace swarmanoid {
namespace {

constexpr std::size_t kDeepest = 1000;  // nesting depth of nodes, with all copies

}  // namespace

void ColladaNodes::open(const XmlTag& tag, bool is_in_library) {
  const std::size_t index = nodes_.size();
  countOne(tag.line);
  nodes_.emplace_back();
  nodes_.back().line = tag.line;
  if (!around_.empty()) {
    nodes_[around_.back()].children.push_back(index);
    nodes_.back().is_nested = true;
  }
  around_.push_back(index);
  const std::string id = attributeOf(tag, "id");
  all_[id].push_back(index);
  if (is_in_library) {
    library_[id].push_back(index);
  }
  const bool is_default = tag.name == "visual_scene" && tag.attributes.count("name") == 0;
  const std::string name = is_default ? "Scene" : attributeOf(tag, "name");  // the default of assimp
  if (name != id) {
    all_[name].push_back(index);
  }
}

void ColladaNodes::close() { around_.pop_back(); }

void ColladaNodes::instance(const XmlTag& tag) {
  if (around_.empty()) {
    return;
  }
  countOne(tag.line);
  Node& node = nodes_[around_.back()];
  ++node.instances;
  const std::string url = attributeOf(tag, "url");
  if (url.empty() || url.front() != '#') {
    return;  // assimp reads no other files
  }
  if (url == "#") {  // assimp would resolve it to elements without an id; geometries fail an assertion
    refuseAt(tag.line, "url='#' of <" + std::string(tag.name) + ">, allowed: '#' and an id");
  }
  if (tag.name == "instance_node") {
    node.nodes.push_back(url.substr(1));
  } else if (tag.name == "instance_geometry" || tag.name == "instance_controller") {
    node.geometries.push_back(url.substr(1));
  }
}

void ColladaNodes::check(const std::map<std::string, std::size_t>& corners) {
  Drawn all;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (!nodes_[i].is_nested) {
      add(drawnBy(i, corners, 0), all, nodes_[i].line);
    }
  }
}

void ColladaNodes::countOne(int line) { add({1, 0, 0}, found_, line); }

void ColladaNodes::add(const Drawn& part, Drawn& whole, int line) {
  whole.nodes += part.nodes;
  whole.corners += part.corners;
  whole.height = std::max(whole.height, part.height);
  if (whole.nodes > kMostNodes) {
    refuseAt(line, "more than " + std::to_string(kMostNodes) + " nodes and instances with all copies, allowed: fewer");
  }
  if (whole.corners > kMostDrawnCorners) {
    refuseAt(line, "more than " + std::to_string(kMostDrawnCorners) + " corners with all copies, allowed: fewer");
  }
}

const std::vector<std::size_t>& ColladaNodes::nodesOf(const std::string& name) const {
  static const std::vector<std::size_t> kNone;
  for (const Ids* const ids : {&library_, &all_}) {
    if (const auto found = ids->find(name); found != ids->end()) {
      return found->second;
    }
  }
  return kNone;
}

// NOLINTNEXTLINE(misc-no-recursion): not deeper than kDeepest
const ColladaNodes::Drawn& ColladaNodes::drawnBy(std::size_t index, const std::map<std::string, std::size_t>& corners,
                                                 std::size_t depth) {
  Node& node = nodes_[index];
  if (node.drawn.nodes > 0) {
    return node.drawn;
  }
  const auto refuseDepth = [&node] {
    refuseAt(node.line, "a node that is copied into itself, or in more than " + std::to_string(kDeepest) +
                            " steps, allowed: neither");
  };
  if (node.is_entered || depth > kDeepest) {
    refuseDepth();
  }
  node.is_entered = true;
  Drawn drawn{1 + node.instances, 0, 0};
  for (const std::size_t child : node.children) {
    add(drawnBy(child, corners, depth + 1), drawn, node.line);
  }
  for (const std::string& name : node.nodes) {
    for (const std::size_t copied : nodesOf(name)) {
      add(drawnBy(copied, corners, depth + 1), drawn, node.line);
    }
  }
  for (const std::string& id : node.geometries) {
    if (const auto found = corners.find(id); found != corners.end()) {
      add({0, found->second, 0}, drawn, node.line);
    }
  }
  if (++drawn.height > kDeepest) {
    refuseDepth();
  }
  return node.drawn = drawn;
}

}  // namespace swarmanoid
