/// What a controller must not do, by name.
#pragma once

#include <string>
#include <vector>

namespace swarmanoid::test {

/// Does it. Some deeds return, some throw, some end the process, some never end.
/// @throws std::runtime_error beginning with "no such deed" and naming all, if there is none of that name
void commit(const std::string& deed);

/// All names, sorted.
std::vector<std::string> deeds();

}  // namespace swarmanoid::test
