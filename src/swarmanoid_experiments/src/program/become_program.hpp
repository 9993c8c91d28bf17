/// Replaces this process by another program.
#pragma once

#include <string>
#include <vector>

namespace swarmanoid::program {

/// Returns only if it cannot be started; errno then says why. @param program its path @param arguments without its name
void becomeProgram(const std::string& program, const std::vector<std::string>& arguments);

}  // namespace swarmanoid::program
