/// The nodes of a Collada file. Assimp copies a node for each instance of it, without a limit, and overflows the stack
/// if a node contains itself.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "xml_tags.hpp"

namespace swarmanoid {

class ColladaNodes {
 public:
  static constexpr std::size_t kMostNodes = 100000;  ///< nodes and instances, with all copies

  /// A <node> begins, or a <visual_scene>, which assimp reads as a node.
  /// @param is_in_library whether assimp searches this node for an id before all others
  /// @throws std::runtime_error as check
  void open(const XmlTag& tag, bool is_in_library);
  /// The innermost open node ends.
  void close();
  /// An <instance_node>, <instance_geometry>, <instance_light>, ... in the innermost open node.
  /// @throws std::runtime_error as check, or if the url is only '#'
  void instance(const XmlTag& tag);

  /// After all nodes of the file. @param corners of each geometry, by id
  /// @throws std::runtime_error "line N: found ...": too many nodes or corners, or a node that contains itself
  void check(const std::map<std::string, std::size_t>& corners);

 private:
  /// Content of a node, with its children and instances.
  struct Drawn {
    std::size_t nodes = 0;  ///< 0: not computed yet
    std::size_t corners = 0;
    std::size_t height = 0;  ///< depth of the tree below, in nodes
  };
  struct Node {
    int line = 0;
    std::vector<std::size_t> children;
    std::vector<std::string> nodes;       ///< instances: ids or names
    std::vector<std::string> geometries;  ///< instances: ids
    std::size_t instances = 0;            ///< of any kind
    Drawn drawn;
    bool is_entered = false;
    bool is_nested = false;
  };
  using Ids = std::map<std::string, std::vector<std::size_t>>;

  void countOne(int line);
  static void add(const Drawn& part, Drawn& whole, int line);
  const std::vector<std::size_t>& nodesOf(const std::string& name) const;
  const Drawn& drawnBy(std::size_t index, const std::map<std::string, std::size_t>& corners, std::size_t depth);

  std::vector<Node> nodes_;
  Drawn found_;                      ///< nodes and instances in the file
  Ids library_;                      ///< by id
  Ids all_;                          ///< by id and by name
  std::vector<std::size_t> around_;  ///< open nodes, outermost first
};

}  // namespace swarmanoid
