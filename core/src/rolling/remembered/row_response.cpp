// SPDX-License-Identifier: GPL-3.0-or-later
#include "row_response.hpp"

#include <cmath>
#include <variant>

#include "microslip/halfspace/influence.hpp"
#include "microslip/rolling/edge_calibration.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

LinearOperator response_of(const Kernel& kernel, const RowNodes& nodes, Index size,
                           const Solver& solver) {
  return influence_operator(kernel, constant_basis(), nodes.spacing, size, solver);
}

VectorXd lengths(const RowNodes& nodes, Index size) {
  return VectorXd::Constant(size, nodes.spacing);
}

/// Returns the displacement by the pressure; it is zero in the middle of a symmetric contact.
/// \param x         of the nodes  [mm]
/// \param backward  whether x is mirrored
/// \return at nodes, entry and exit  [mm]
VectorXd pressed_at(const TransientProblem& problem, const VectorXd& x, double spacing,
                    bool backward) {
  const Index n = x.size();
  if (problem.contact.pressure_strain == 0) return VectorXd::Zero(n + 2);
  const double total = full_sliding_force(problem.contact.bound);
  const auto integral = [&](double place) {
    const auto up_to = [&](double end) {
      return std::visit([&](const auto& bound) { return bound.integral(end); },
                        problem.contact.bound);
    };
    return backward ? total - up_to(-place) : up_to(place);
  };
  VectorXd pressed(n + 2);
  for (Index i = 0; i < n; ++i) pressed[i] = integral(x[i]);
  pressed[n] = std::lerp(pressed[n - 1], integral(x[n - 1] + spacing), pressure_seen_at_edge);
  pressed[n + 1] = integral(x[0] - spacing);
  return problem.contact.pressure_strain * (pressed.array() - total / 2);
}

}  // namespace

VectorXd mirrored_means(const TractionBound& bound, const VectorXd& x, const VectorXd& lengths) {
  return element_means(bound, -x.reverse(), lengths.reverse()).reverse();
}

RowResponse::RowResponse(const TransientProblem& problem, const Grid& grid, const RowEdges& edges)
    : nodes_{.size = grid.size(),
             .spacing = grid.spacing(),
             .first = grid.nodes()[0] / grid.spacing()},
      kernel_(problem.contact.kernel),
      solver_(problem.solver),
      active_set_(response_of(kernel_, nodes_, nodes_.size, solver_), lengths(nodes_, nodes_.size),
                  solver_),
      exit_(edges.exit()),
      facings_{facing_of(problem, grid, false), facing_of(problem, grid, true)},
      pressure_strain_(problem.contact.pressure_strain) {
  set_influence(kernel_);
}

RowResponse::Facing RowResponse::facing_of(const TransientProblem& problem, const Grid& grid,
                                           bool backward) {
  const VectorXd x = grid.nodes();
  const VectorXd lengths = VectorXd::Constant(x.size(), grid.spacing());
  return {.bound = backward ? mirrored_means(problem.contact.bound, x, lengths)
                            : element_means(problem.contact.bound, x, lengths),
          .pressed = pressed_at(problem, x, grid.spacing(), backward)};
}

void RowResponse::set_influence(const Kernel& kernel) {
  influence_ = VectorXd::NullaryExpr(nodes_.size + 2, [&](Index distance) {
    return influence(kernel, constant_shape(), nodes_.spacing, static_cast<double>(distance));
  });
}

void RowResponse::set_half_width(double half_width) {
  const bool is_other = half_width != half_width_;
  half_width_ = half_width;
  if (kernel_.is_plane()) {
    common_ = -kernel_.log_factor() * std::log(half_width);
    return;
  }
  if (!is_other) return;
  const Kernel kernel = kernel_.in_units_of(half_width);
  active_set_ = ActiveSet(response_of(kernel, nodes_, nodes_.size, solver_),
                          lengths(nodes_, nodes_.size), solver_);
  set_influence(kernel);
  ++version_;
}

ActiveSet RowResponse::with_entry() const {
  const Kernel kernel = kernel_.is_plane() ? kernel_ : kernel_.in_units_of(half_width_);
  const Index n = nodes_.size + 1;
  return {response_of(kernel, nodes_, n, solver_), lengths(nodes_, n), solver_};
}

VectorXd RowResponse::displaced_by(const VectorXd& traction) const {
  VectorXd displacement =
      (active_set_.response() * traction).array() + common_ * active_set_.weights().dot(traction);
  displacement[0] += exit_.compliance * traction[0];
  return displacement;
}

VectorXd RowResponse::displaced_by_entry(double entry) const {
  return entry * (influence_.segment(1, nodes_.size).reverse().array() + nodes_.spacing * common_);
}

void RowResponse::displace_ends(RowPoints& nodes, const VectorXd& traction, double entry) const {
  const auto from_next = influence_.segment(1, nodes_.size);
  const double common = common_ * (active_set_.weights().dot(traction) + nodes_.spacing * entry);
  nodes.at[nodes_.size] = from_next.reverse().dot(traction) + entry * influence_[0] + common;
  nodes.exit = from_next.dot(traction) + entry * influence_[nodes_.size + 1] + common;
}

}  // namespace microslip
