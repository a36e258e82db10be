// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace microslip {

/// Returns the product of two matrices, by Eigen, for code that is not called in each step: it allocates. Eigen's own
/// operator is compiled anew for each pair of types, in one to three seconds; this one is compiled once.
/// \param left   m x k
/// \param right  k x n
/// \return       m x n
Eigen::MatrixXd matrix_product(const Eigen::Ref<const Eigen::MatrixXd>& left,
                               const Eigen::Ref<const Eigen::MatrixXd>& right);

}  // namespace microslip
