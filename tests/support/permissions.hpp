#pragma once

#include <linux/capability.h>
#include <linux/securebits.h>
#include <stdexcept>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace manifuzz::test {

/// While it lives, permissions of files bind this process and the programs that it starts, though
/// they be root's. Throws std::runtime_error where that is not to be had.
class BoundByPermissions {
 public:
  BoundByPermissions() {
    __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
    if (syscall(SYS_capget, &header, before_) != 0) throw std::runtime_error("capget failed");
    __user_cap_data_struct bound[2] = {before_[0], before_[1]};
    bound[0].effective &= ~(CAP_TO_MASK(CAP_DAC_OVERRIDE) | CAP_TO_MASK(CAP_DAC_READ_SEARCH));
    if (bound[0].effective == before_[0].effective) return;  // not root
    // Else a program that root starts has every capability again.
    if (prctl(PR_SET_SECUREBITS, SECBIT_NOROOT) != 0) throw std::runtime_error("prctl failed");
    syscall(SYS_capset, &header, bound);
  }
  ~BoundByPermissions() {
    __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
    syscall(SYS_capset, &header, before_);
    prctl(PR_SET_SECUREBITS, 0);
  }
  BoundByPermissions(const BoundByPermissions&) = delete;
  BoundByPermissions& operator=(const BoundByPermissions&) = delete;

 private:
  __user_cap_data_struct before_[2]{};
};

}  // namespace manifuzz::test
