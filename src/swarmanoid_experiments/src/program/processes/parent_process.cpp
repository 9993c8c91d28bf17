#include "parent_process.hpp"

#include <signal.h>
#include <sys/prctl.h>
#include <unistd.h>

namespace swarmanoid::program {

void endWithParent() {
  const pid_t parent = getppid();
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) {
    raise(SIGKILL);  // the parent has ended in the meantime
  }
}

}  // namespace swarmanoid::program
