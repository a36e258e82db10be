// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/halfspace/influence.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "microslip/support/format.hpp"
#include "microslip/support/require.hpp"
#include "microslip/support/work.hpp"

namespace microslip {

namespace {

/// The range of distances z = gap + t, t >= 0, over which a weight acts on a point, all in units
/// of dx. The weight is a polynomial in t between the breakpoints. Counting t from the gap keeps
/// its digits when the gap is a million elements.
struct Reach {
  double gap;
  std::vector<double> breakpoints;  ///< values of t, in any order; 0 is always one

  void add(double t) { breakpoints.push_back(t); }
};

/// Length over which a kernel's decay has no more waves than 15 Gauss points integrate  [dx]
constexpr double most_waves = 1000;  // largest wave number times dx

double longest_panel_of(double largest_wave_number, double spacing) {
  constexpr double longest_phase = 5;
  require(largest_wave_number * spacing <= most_waves, "wave_number", largest_wave_number, [&] {
    return fmt::format("at most {} with elements of {} mm", format_short(most_waves / spacing),
                       format_short(spacing));
  });
  return longest_phase / (largest_wave_number * spacing);
}

/// Integral of decay(dx z) weight(t) over one polynomial piece of the weight; if the piece begins
/// at z = 0, where the decay is infinite, the weight must vanish there. A panel is never longer
/// than its distance to the nearest singularity: 15 Gauss points then leave less than rounding; 7
/// do when it is four times shorter.
template <class K, class Weight>
double integrate_piece(const K& kernel, double spacing, double gap, double begin, double end,
                       const Weight& weight) {
  using boost::math::quadrature::gauss;
  const auto integrand = [&](double t) { return kernel.decay(spacing * (gap + t)) * weight(t); };
  const double clear = kernel.clear_distance() / spacing;
  const double longest = longest_panel_of(kernel.largest_wave_number(), spacing);
  const bool regular_at_zero = gap + begin == 0;
  double sum = 0;
  for (double t = begin; t < end;) {
    const double distance = std::min(longest, regular_at_zero ? std::hypot(t, clear) : gap + t);
    const double next = distance < end - t ? t + distance : end;
    count_work(kernel_work * (4 * (next - t) <= distance ? 7 : 15));
    sum += 4 * (next - t) <= distance ? gauss<double, 7>::integrate(integrand, t, next)
                                      : gauss<double, 15>::integrate(integrand, t, next);
    t = next;
  }
  return sum;
}

template <class Weight>
double integrate_decay(const Kernel& kernel, double spacing, Reach reach, const Weight& weight) {
  std::vector<double>& ends = reach.breakpoints;
  std::sort(ends.begin(), ends.end());
  const auto integrate = [&](const auto& k) {
    double sum = 0;
    for (std::size_t i = 1; i < ends.size(); ++i) {
      sum += integrate_piece(k, spacing, reach.gap, ends[i - 1], ends[i], weight);
    }
    return sum;
  };
  return kernel.visit(integrate);
}

bool is_constant(const ShapeFunction& shape) {
  return std::ranges::all_of(shape.pieces(), [](const ShapeFunction::Piece& piece) {
    return piece.c[1] == 0 && piece.c[2] == 0;
  });
}

/// Returns the function that a layer feels in the place of a basis function.
ShapeFunction felt(const ShapeFunction& shape) {
  return is_constant(shape) ? linear_shape() : shape;
}

/// felt(offset) - felt(offset + shift), without cancellation within a piece.
double felt_difference(const ShapeFunction& shape, double offset, double shift) {
  const ShapeFunction layer = felt(shape);
  const auto* piece = layer.piece_over(offset, offset + shift);
  if (piece == nullptr) return layer.value(offset) - layer.value(offset + shift);
  return -shift * (piece->c[1] + piece->c[2] * (2 * offset + shift));
}

double spread_influence(const Kernel& kernel, const ShapeFunction& shape, double spacing,
                        double offset) {
  if (!kernel.spreads()) return 0;
  // Integration by parts of K(|offset - s|) shape(s): the weight is the traction within a distance
  // z of the point, which at the farthest breakpoint is all of it. All shapes are reached from
  // either side by the same rule, so a point beyond the support is mirrored to its right.
  const double first = shape.breakpoints().front();
  const double last = shape.breakpoints().back();
  const auto by_parts = [&](const Reach& reach, const auto& weight) {
    const double farthest =
        reach.gap + *std::max_element(reach.breakpoints.begin(), reach.breakpoints.end());
    return spacing * (kernel.displacement(spacing * farthest) * shape.weight() +
                      spacing * integrate_decay(kernel, spacing, reach, weight));
  };
  if (offset >= last) {
    const ShapeFunction local = shape.about(last);
    Reach reach{offset - last, {}};
    for (const double s : local.breakpoints()) reach.add(-s);
    return by_parts(reach, [&](double t) { return local.integral(-t, t); });
  }
  if (offset <= first) {
    const ShapeFunction local = shape.about(first);
    Reach reach{first - offset, {}};
    for (const double s : local.breakpoints()) reach.add(s);
    return by_parts(reach, [&](double t) { return local.integral(0, t); });
  }
  const ShapeFunction local = shape.about(offset);
  Reach reach{0, {0}};
  for (const double s : local.breakpoints()) reach.add(std::abs(s));
  return by_parts(reach, [&](double t) { return local.integral(-t, 2 * t); });
}

double spread_difference(const Kernel& kernel, const ShapeFunction& shape, double spacing,
                         double offset, double shift) {
  if (!kernel.spreads()) return 0;
  // Integration by parts of both weights leaves the tractions that an interval of length `shift`
  // covers at a distance z on either side.
  const double first = shape.breakpoints().front();
  const double last = shape.breakpoints().back();
  const double scale = spacing * spacing;
  if (offset >= last) {
    const ShapeFunction local = shape.about(last);
    Reach reach{offset - last, {}};
    for (const double s : local.breakpoints()) {
      reach.add(-s);
      reach.add(-s + shift);
    }
    return scale * integrate_decay(kernel, spacing, reach,
                                   [&](double t) { return local.integral(-t, shift); });
  }
  if (offset + shift <= first) {
    const ShapeFunction local = shape.about(first);
    Reach reach{first - (offset + shift), {}};
    for (const double s : local.breakpoints()) {
      reach.add(s);
      reach.add(s + shift);
    }
    return -scale * integrate_decay(kernel, spacing, reach,
                                    [&](double t) { return local.integral(t - shift, shift); });
  }
  const ShapeFunction here = shape.about(offset);
  const ShapeFunction there = shape.about(offset + shift);
  Reach reach{0, {0, shift / 2}};
  for (const double s : here.breakpoints()) reach.add(std::abs(s));
  for (const double s : there.breakpoints()) reach.add(std::abs(s));
  // The same remains of the tractions within z of either point. The shorter intervals are taken:
  // what the longer ones share would cancel, as the values would where the function is smooth.
  return scale * integrate_decay(kernel, spacing, reach, [&](double t) {
           if (const auto* piece = here.piece_over(-t, t + shift)) {
             return -2 * t * shift * (piece->c[1] + piece->c[2] * shift);
           }
           return 2 * t < shift ? here.integral(-t, 2 * t) - there.integral(-t, 2 * t)
                                : here.integral(-t, shift) - here.integral(t, shift);
         });
}

}  // namespace

bool resolves_waves(const Kernel& kernel, double spacing) {
  return kernel.largest_wave_number() * spacing <= most_waves;
}

void require_step_ratio(double step_ratio, std::string_view name) {
  require(step_ratio >= min_step_ratio, name, step_ratio, "a number >= 1e-15");
}

bool is_within_relaxation(double step_ratio, double relaxation) {
  constexpr double rounding = 1e-12;
  return step_ratio <= relaxation * (1 + rounding);
}

double influence(const Kernel& kernel, const ShapeFunction& shape, double spacing, double offset) {
  const double spread = spread_influence(kernel, shape, spacing, offset);
  const double compliance = kernel.layer_compliance();
  return compliance == 0 ? spread : spread + compliance * felt(shape).value(offset);
}

double influence_difference(const Kernel& kernel, const ShapeFunction& shape, double spacing,
                            double offset, double shift) {
  const double spread = spread_difference(kernel, shape, spacing, offset, shift);
  const double compliance = kernel.layer_compliance();
  return compliance == 0 ? spread : spread + compliance * felt_difference(shape, offset, shift);
}

Toeplitz influence_toeplitz(const Kernel& kernel, const ShapeFunction& shape, double spacing,
                            Eigen::Index n) {
  const auto entry = [&](Eigen::Index k) {
    return influence(kernel, shape, spacing, static_cast<double>(k));
  };
  const Eigen::VectorXd column = Eigen::VectorXd::NullaryExpr(n, entry);
  if (shape.is_even()) return {column, column};
  return {column, Eigen::VectorXd::NullaryExpr(n, [&](Eigen::Index k) { return entry(-k); })};
}

Toeplitz influence_difference_toeplitz(const Kernel& kernel, const ShapeFunction& shape,
                                       double spacing, Eigen::Index n, double step_ratio) {
  require_step_ratio(step_ratio);
  const auto entry = [&](Eigen::Index k) {
    return influence_difference(kernel, shape, spacing, static_cast<double>(k), step_ratio);
  };
  const Eigen::VectorXd column = Eigen::VectorXd::NullaryExpr(n, entry);
  if (shape.is_even() && step_ratio == 1) {
    Eigen::VectorXd row(n);
    row << column[0], -column.head(n - 1);
    return {column, row};
  }
  return {column, Eigen::VectorXd::NullaryExpr(n, [&](Eigen::Index k) { return entry(-k); })};
}

namespace {

/// Column j of the matrix is column j of the Toeplitz matrix of node j's shape.
template <class ToeplitzOf>
Eigen::MatrixXd assemble(const Basis& basis, Eigen::Index n, const ToeplitzOf& toeplitz_of) {
  std::vector<Toeplitz> matrices;
  for (const ShapeFunction& shape : basis.shapes()) matrices.push_back(toeplitz_of(shape));
  return Eigen::MatrixXd::NullaryExpr(
      n, n, [&](Eigen::Index i, Eigen::Index j) { return matrices[basis.shape_of(j, n)](i, j); });
}

}  // namespace

Eigen::MatrixXd influence_matrix(const Kernel& kernel, const Basis& basis, double spacing,
                                 Eigen::Index n) {
  return assemble(basis, n, [&](const ShapeFunction& shape) {
    return influence_toeplitz(kernel, shape, spacing, n);
  });
}

Eigen::MatrixXd influence_difference_matrix(const Kernel& kernel, const Basis& basis,
                                            double spacing, Eigen::Index n, double step_ratio) {
  return assemble(basis, n, [&](const ShapeFunction& shape) {
    return influence_difference_toeplitz(kernel, shape, spacing, n, step_ratio);
  });
}

namespace {

/// \param toeplitz_of  of a shape
template <class ToeplitzOf>
LinearOperator arranged(const Basis& basis, Eigen::Index n, const Solver& solver,
                        const ToeplitzOf& toeplitz_of) {
  if (by_fft(solver, basis, n)) return toeplitz_of(basis.shapes().front());
  require_dense(n);
  return assemble(basis, n, toeplitz_of);
}

}  // namespace

bool by_fft(const Solver& solver, const Basis& basis, Eigen::Index n) {
  const bool equal = basis.shapes().size() == 1;
  if (!equal && solver.type == Solver::Type::fft) {
    reject("solver", "fft",
           fmt::format("auto or dense for the basis {}, the functions of which are not all equal",
                       basis.name()));
  }
  return equal && by_fft(solver, n);
}

LinearOperator influence_operator(const Kernel& kernel, const Basis& basis, double spacing,
                                  Eigen::Index n, const Solver& solver) {
  return arranged(basis, n, solver, [&](const ShapeFunction& shape) {
    return influence_toeplitz(kernel, shape, spacing, n);
  });
}

LinearOperator influence_difference_operator(const Kernel& kernel, const Basis& basis,
                                             double spacing, Eigen::Index n, double step_ratio,
                                             const Solver& solver) {
  return arranged(basis, n, solver, [&](const ShapeFunction& shape) {
    return influence_difference_toeplitz(kernel, shape, spacing, n, step_ratio);
  });
}

Solver strain_solver(const Solver& wanted, Eigen::Index n, double step_ratio) {
  constexpr double least_step_ratio = 0.01;
  Solver solver = wanted;
  const bool chooses = wanted.type == Solver::Type::automatic;
  if (chooses && step_ratio < least_step_ratio && n <= Solver::most_dense) {
    solver.type = Solver::Type::dense;
  }
  return solver;
}

LinearOperator strain_operator(const Kernel& kernel, const Basis& basis, double spacing,
                               Eigen::Index n, double step_ratio, const Solver& wanted) {
  return arranged(basis, n, strain_solver(wanted, n, step_ratio), [&](const ShapeFunction& shape) {
    return influence_difference_toeplitz(kernel, shape, spacing, n, step_ratio)
        .times(1 / (step_ratio * spacing));
  });
}

}  // namespace microslip
