// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/prctl.h>
#include <unistd.h>

#include <boost/process.hpp>
#include <boost/process/extend.hpp>

namespace thalweg {

/// For boost::process::child: the child gets this signal when we are gone before it, be it by `kill -9`. The
/// thread that starts the child must wait for it: the signal comes at the end of the thread.
inline auto ends_after_us(int signal) {
  return boost::process::extend::on_exec_setup([signal, parent = getpid()](auto&) {
    prctl(PR_SET_PDEATHSIG, signal);
    if (getppid() != parent) _exit(1);  // gone already
  });
}

}  // namespace thalweg
