// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace microslip::experiments {

/// Files that the build puts into the program: experiments/CMakeLists.txt
std::string_view creep_table_bytes();    ///< tables/creep_forces.nc
std::string_view contact_table_bytes();  ///< studies/creep_tables/contact_11.tsv

}  // namespace microslip::experiments
