#include "standard_output.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <iostream>
#include <stdexcept>

namespace swarmanoid::program {

bool fillStandardStreams() {
  bool is_output_open = true;
  // in this order: a file gets the lowest number that is free
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) == -1 && errno == EBADF) {
      is_output_open = is_output_open && stream != STDOUT_FILENO;
      open("/dev/null", O_RDWR);
    }
  }
  return is_output_open;
}

void print(const std::string& text) {
  errno = 0;
  std::cout << text << std::flush;
  if (!std::cout) {
    throw std::runtime_error(std::string("standard output cannot be written: ") + std::strerror(errno));
  }
}

}  // namespace swarmanoid::program
