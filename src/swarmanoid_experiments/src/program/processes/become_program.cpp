#include "become_program.hpp"

#include <unistd.h>

namespace swarmanoid::program {

void becomeProgram(const std::string& program, const std::vector<std::string>& arguments) {
  std::vector<char*> words{const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments) {
    words.push_back(const_cast<char*>(argument.c_str()));  // execv changes nothing, but its type lacks the const
  }
  words.push_back(nullptr);
  execv(words[0], words.data());
}

}  // namespace swarmanoid::program
