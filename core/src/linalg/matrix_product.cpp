// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/linalg/matrix_product.hpp"

namespace microslip {

using Eigen::MatrixXd;

MatrixXd matrix_product(const Eigen::Ref<const MatrixXd>& left,
                        const Eigen::Ref<const MatrixXd>& right) {
  return left * right;
}

}  // namespace microslip
