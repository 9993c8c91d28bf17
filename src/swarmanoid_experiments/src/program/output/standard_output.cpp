#include "standard_output.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <iostream>
#include <stdexcept>
#include <string_view>

namespace swarmanoid::program {
namespace {

int output = STDOUT_FILENO;  // constant once users' libraries are loaded

}  // namespace

bool fillStandardStreams() {
  bool is_output_open = true;
  // the order matters: a file gets the lowest free number
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) == -1 && errno == EBADF) {
      is_output_open = is_output_open && stream != STDOUT_FILENO;
      open("/dev/null", O_RDWR);
    }
  }
  const int own = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  output = own >= 0 ? own : STDOUT_FILENO;
  return is_output_open;
}

void print(const std::string& text) {
  std::cout.flush();  // output of users' code comes before the text
  for (std::string_view rest = text; !rest.empty();) {
    const ssize_t written = ::write(output, rest.data(), rest.size());
    if (written < 0 && errno != EINTR) {
      throw std::runtime_error(std::string("standard output cannot be written: ") + std::strerror(errno));
    }
    rest.remove_prefix(written < 0 ? 0 : static_cast<std::size_t>(written));
  }
}

}  // namespace swarmanoid::program
