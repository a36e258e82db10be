// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/linalg/inverse_norm.hpp"

#include <gsl/gsl_linalg.h>

#include <exception>

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

struct Solves {
  const std::function<void(VectorXd&)>& plain;
  const std::function<void(VectorXd&)>& transposed;
  std::exception_ptr thrown;
};

/// No exception passes through GSL; a status that is not success ends GSL's iteration.
int apply(CBLAS_TRANSPOSE_t transposed, gsl_vector* x, void* solves) noexcept {
  Eigen::Map<VectorXd, Eigen::Unaligned, Eigen::InnerStride<>> values(
      x->data, static_cast<Index>(x->size), Eigen::InnerStride<>(static_cast<Index>(x->stride)));
  auto& [plain, other, thrown] = *static_cast<Solves*>(solves);
  try {
    VectorXd copy = values;
    (transposed == CblasNoTrans ? plain : other)(copy);
    values = copy;
    return GSL_SUCCESS;
  } catch (...) {
    thrown = std::current_exception();
    return GSL_EFAILED;
  }
}

}  // namespace

double inverse_norm(Index n, const std::function<void(VectorXd&)>& solve,
                    const std::function<void(VectorXd&)>& solve_transposed) {
  Solves solves{solve, solve_transposed, nullptr};
  VectorXd work(3 * n);
  double norm = 0;
  gsl_vector_view view = gsl_vector_view_array(work.data(), static_cast<std::size_t>(3 * n));
  gsl_linalg_invnorm1(static_cast<std::size_t>(n), apply, &solves, &norm, &view.vector);
  if (solves.thrown) std::rethrow_exception(solves.thrown);
  return norm;
}

}  // namespace microslip
