/// The nodes of a Collada file: assimp copies them as often as they are instanced, without a limit, and runs out of
/// stack where a copy contains itself.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "xml_tags.hpp"

namespace swarmanoid {

class ColladaNodes {
 public:
  static constexpr std::size_t kMostNodes = 100000;  ///< and what they instance, with all copies

  /// A <node> begins, or a <visual_scene>, which assimp reads as a node.
  /// @param is_in_library assimp searches these for an id before all other nodes
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
  /// What a node draws, with all that is in it.
  struct Drawn {
    std::size_t nodes = 0;  ///< 0: not known yet
    std::size_t corners = 0;
    std::size_t height = 0;  ///< nodes on the longest way down
  };
  struct Node {
    int line = 0;
    std::vector<std::size_t> children;
    std::vector<std::string> nodes;       ///< instances: ids or names
    std::vector<std::string> geometries;  ///< instances: ids
    std::size_t instances = 0;            ///< of anything
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
  std::vector<std::size_t> around_;  ///< nodes that are open
};

}  // namespace swarmanoid
