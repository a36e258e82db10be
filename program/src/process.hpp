// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

namespace microslip::program {

/// status_of for the whole process. Errors of files and standard streams become a failed write with
/// one line on stderr, not the end by a signal: a reader that has gone (SIGPIPE), a limit of the
/// file size (SIGXFSZ), a full disk behind standard output.
int run_process(const std::string& name, const std::function<int()>& action);

}  // namespace microslip::program
