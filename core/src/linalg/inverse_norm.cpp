// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/linalg/inverse_norm.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>

#include <stdexcept>
#include <string>

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

struct Solves {
  const std::function<void(VectorXd&)>& plain;
  const std::function<void(VectorXd&)>& transposed;
};

int apply(CBLAS_TRANSPOSE_t transposed, gsl_vector* x, void* solves) {
  Eigen::Map<VectorXd, Eigen::Unaligned, Eigen::InnerStride<>> values(
      x->data, static_cast<Index>(x->size), Eigen::InnerStride<>(static_cast<Index>(x->stride)));
  VectorXd copy = values;
  const auto& [plain, other] = *static_cast<const Solves*>(solves);
  (transposed == CblasNoTrans ? plain : other)(copy);
  values = copy;
  return GSL_SUCCESS;
}

}  // namespace

double inverse_norm(Index n, const std::function<void(VectorXd&)>& solve,
                    const std::function<void(VectorXd&)>& solve_transposed) {
  Solves solves{solve, solve_transposed};
  VectorXd work(3 * n);
  gsl_vector_view view = gsl_vector_view_array(work.data(), static_cast<std::size_t>(3 * n));
  double norm = 0;
  const int status =
      gsl_linalg_invnorm1(static_cast<std::size_t>(n), apply, &solves, &norm, &view.vector);
  if (status != GSL_SUCCESS) {
    throw std::logic_error(std::string("inverse_norm: ") + gsl_strerror(status));
  }
  return norm;
}

}  // namespace microslip
