/// Replaces this process by another program.
#pragma once

#include <string>
#include <vector>

namespace swarmanoid::program {

/// Returns only on failure, with errno set. @param program its path @param arguments without the program's name
void becomeProgram(const std::string& program, const std::vector<std::string>& arguments);

}  // namespace swarmanoid::program
