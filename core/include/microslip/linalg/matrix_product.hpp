// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace microslip {

/// Returns the product of two matrices by Eigen, compiled once: Eigen's own operator takes the
/// compiler one to three seconds for each pair of types. The result is allocated. A matrix is
/// copied if its columns do not lie one after the other; the transpose of one whose rows do is not.
/// \param left   m x k
/// \param right  k x n
/// \return       m x n
Eigen::MatrixXd matrix_product(const Eigen::Ref<const Eigen::MatrixXd>& left,
                               const Eigen::Ref<const Eigen::MatrixXd>& right);

}  // namespace microslip
