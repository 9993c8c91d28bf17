/// The parameters of an effect in a Collada file: each refers to another one or to an image, and assimp follows
/// references in circles for ever.
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

  /// At the end of an effect; forgets its parameters.
  /// @throws std::runtime_error "line N: found ..." for references in a circle, or through too many parameters
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
