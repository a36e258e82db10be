// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/LU>
#include <memory>

#include "bench.hpp"
#include "microslip/halfspace/influence.hpp"
#include "microslip/linalg/circulant_inverse.hpp"
#include "microslip/linalg/gmres.hpp"
#include "microslip/linalg/lu_factors.hpp"
#include "microslip/linalg/toeplitz_inverse.hpp"
#include "microslip/linalg/toeplitz_product.hpp"

namespace microslip::bench {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int most_iterations = 100;

/// The matrix of elements that fill the contact: A, which is symmetric, or A - A' of a step of one
/// element.
Toeplitz coefficients(const BenchParameters& p, const Kernel& kernel, bool difference, Index n) {
  const ShapeFunction shape = constant_basis().shapes().front();
  const double spacing = 2 * p.bound.half_width() / static_cast<double>(n);
  return difference ? influence_difference_toeplitz(kernel, shape, spacing, n, 1)
                    : influence_toeplitz(kernel, shape, spacing, n);
}

/// A method that solves or multiplies, and the matrix that it works on.
template <class Operator>
struct Operation {
  Operator on;
  VectorXd from;
  VectorXd to;
};

template <class Operator, class Apply>
Work repeated(Operator on, const VectorXd& from, Apply apply) {
  auto all = std::make_shared<Operation<Operator>>(std::move(on), from, from);
  return [all, apply] { return apply(all->on, all->from, all->to); };
}

double solve_by_gmres(const Toeplitz& matrix, const VectorXd& b, double tolerance, VectorXd& x) {
  const ToeplitzProduct product(matrix);
  const CirculantInverse circulant(matrix);
  return Gmres(most_iterations)
      .solve([&](const VectorXd& v, VectorXd& y) { product.apply(v, y); },
             [&](const VectorXd& v, VectorXd& y) { circulant.apply(v, y); }, b, tolerance, x)
      .iterations;
}

class ToeplitzCases {
 public:
  explicit ToeplitzCases(const BenchParameters& p) : p_(p) {}

  std::vector<Case> all() {
    for (const Index n : p_.parts) {
      add_coefficients(n);
      add_products(n);
      add_solves(n, false);
      add_solves(n, true);
    }
    return cases_;
  }

 private:
  void add_coefficients(Index n) {
    for (const NamedKernel& named : p_.kernels) {
      for (const bool difference : {false, true}) {
        cases_.push_back(
            {{"influence", named.name, difference ? "difference" : "plain", n}, [=, &p = p_] {
               return Work([=, &p] {
                 coefficients(p, named.kernel, difference, n);
                 return 0;
               });
             }});
      }
    }
  }

  /// \param make   of a Toeplitz matrix the operator
  /// \param apply  (operator, from, to), returns the number of iterations
  template <class Make, class Apply>
  void add(const std::string& quantity, const std::string& method, Index n, bool difference,
           Make make, Apply apply) {
    cases_.push_back({{quantity, "strip", method, n}, [=, &p = p_] {
                        const VectorXd x =
                            VectorXd::LinSpaced(n, -1, 1) * (1 - 1.0 / static_cast<double>(n));
                        return repeated(make(coefficients(p, p.strip(), difference, n)),
                                        (1 - x.array().square()).sqrt(), apply);
                      }});
  }

  void add_products(Index n) {
    const auto product = [](const auto& matrix, const VectorXd& x, VectorXd& y) {
      matrix.apply(x, y);
      return 0;
    };
    add(
        "product", "fft", n, true, [](const Toeplitz& matrix) { return ToeplitzProduct(matrix); },
        product);
    if (n > p_.dense_product) return;
    add(
        "product", "dense", n, true,
        [](const Toeplitz& matrix) { return LinearOperator(matrix.dense()); }, product);
  }

  void add_solves(Index n, bool difference) {
    const std::string quantity = difference ? "solve_difference" : "solve_plain";
    const auto toeplitz = [](const Toeplitz& matrix) { return matrix; };
    add(quantity, "gmres_circulant", n, difference, toeplitz,
        [tolerance = p_.tolerance](const Toeplitz& matrix, const VectorXd& b, VectorXd& x) {
          return solve_by_gmres(matrix, b, tolerance, x);
        });
    add(quantity, "gohberg_semencul", n, difference, toeplitz,
        [](const Toeplitz& matrix, const VectorXd& b, VectorXd& x) {
          const ToeplitzInverse inverse(matrix);
          inverse.apply(b, x);
          return inverse.iterations();
        });
    add(
        quantity, "gohberg_semencul_apply", n, difference,
        [](const Toeplitz& matrix) { return ToeplitzInverse(matrix); },
        [](const ToeplitzInverse& inverse, const VectorXd& b, VectorXd& x) {
          inverse.apply(b, x);
          return 0;
        });
    if (n > p_.dense_solve) return;
    add(quantity, "lu", n, difference, toeplitz,
        [](const Toeplitz& matrix, const VectorXd& b, VectorXd& x) {
          LuFactors(matrix.dense()).solve(b, x);
          return 0;
        });
    add(
        quantity, "lu_apply", n, difference,
        [](const Toeplitz& matrix) { return LuFactors(matrix.dense()); },
        [](const LuFactors& factors, const VectorXd& b, VectorXd& x) {
          factors.solve(b, x);
          return 0;
        });
  }

  const BenchParameters& p_;
  std::vector<Case> cases_;
};

}  // namespace

std::vector<Case> toeplitz_cases(const BenchParameters& p) { return ToeplitzCases(p).all(); }

}  // namespace microslip::bench
