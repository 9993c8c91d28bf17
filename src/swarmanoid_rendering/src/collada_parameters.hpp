/// The parameters of an effect in a Collada file. Each refers to another parameter or to an image, and assimp follows
/// circular references without end.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>

#include "xml_tags.hpp"

namespace swarmanoid {

class ColladaParameters {
 public:
  /// A <newparam> begins. @throws std::runtime_error if it has no sid
  void open(const XmlTag& tag);
  /// The last opened parameter refers to a parameter or an image. If it has several references, all are followed: the
  /// version of the file decides which one assimp takes.
  void refer(const std::string& name);

  /// Checks the parameters at the end of an effect, and clears them.
  /// @throws std::runtime_error "line N: found ..." for circular references and for chains that are too long
  void check(int line);

 private:
  struct Parameter {
    std::set<std::string> references;
    bool is_entered = false;
    bool is_checked = false;
  };

  void follow(const std::string& name, int line, std::size_t depth);

  std::map<std::string, Parameter> parameters_;  ///< by sid
  std::string last_;                             ///< sid
};

}  // namespace swarmanoid
