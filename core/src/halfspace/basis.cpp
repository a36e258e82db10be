// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/halfspace/basis.hpp"

#include <algorithm>
#include <stdexcept>

#include "microslip/support/nearest.hpp"
#include "microslip/support/require.hpp"

namespace microslip {

namespace {

ShapeFunction bubble() { return ShapeFunction({{-1, 1, {1, 0, -1}}}); }

/// The function (B.5), cut to [-reach, reach]; the whole function has reach 2.
ShapeFunction vertex(double reach) {
  return ShapeFunction({{-reach, 0, {1, 1.5, 0.5}}, {0, reach, {1, -1.5, 0.5}}});
}

}  // namespace

Basis::Basis(std::string name, Pattern pattern, std::vector<ShapeFunction> shapes)
    : name_(std::move(name)), pattern_(pattern), shapes_(std::move(shapes)) {
  if (shapes_.size() != (pattern == Pattern::uniform ? 1U : 2U)) {
    throw std::invalid_argument("basis " + name_ + ": the pattern and the shapes do not agree");
  }
}

bool Basis::has_only(const ShapeFunction& shape) const {
  return pattern_ == Pattern::uniform && shapes_.front() == shape;
}

std::size_t Basis::shape_of(Eigen::Index i, Eigen::Index n) const {
  switch (pattern_) {
    case Pattern::alternating:
      return static_cast<std::size_t>(i % 2);
    case Pattern::last_differs:
      return i == n - 1 ? 1 : 0;
    default:
      return 0;
  }
}

Eigen::VectorXd Basis::weights(double spacing, Eigen::Index n) const {
  return Eigen::VectorXd::NullaryExpr(
      n, [&](Eigen::Index i) { return spacing * shapes_[shape_of(i, n)].weight(); });
}

Basis constant_basis() { return {"constant", Basis::Pattern::uniform, {constant_shape()}}; }

Basis linear_basis() { return {"linear", Basis::Pattern::uniform, {linear_shape()}}; }

Basis quadratic_basis() {
  return {"quadratic", Basis::Pattern::alternating, {bubble(), vertex(2)}};
}

Basis quadratic_basis_as_printed() {
  return {"quadratic as printed", Basis::Pattern::alternating, {bubble(), vertex(1)}};
}

Basis trimmed_linear_basis(double leading_offset) {
  require(leading_offset > 0 && leading_offset <= 1, "leading_offset", leading_offset,
          "a number in (0, 1]");
  return {"trimmed linear",
          Basis::Pattern::last_differs,
          {linear_shape(), ShapeFunction({{-1, 0, {1, 1, 0}}, {0, leading_offset, {1, -1, 0}}})}};
}

Basis edge_constant_basis() {
  return {"edge constant",
          Basis::Pattern::last_differs,
          {constant_shape(), ShapeFunction({{-0.5, 0.5, {1, -2, 0}}})}};
}

namespace {

/// The bases for scenes, the default first.
const std::vector<Basis>& bases() {
  static const std::vector<Basis> all{constant_basis(), linear_basis(), quadratic_basis()};
  return all;
}

}  // namespace

std::vector<std::string_view> basis_names() {
  std::vector<std::string_view> names;
  for (const Basis& basis : bases()) names.push_back(basis.name());
  return names;
}

Basis make_basis(std::string_view name) {
  const auto found = std::ranges::find(bases(), name, &Basis::name);
  if (found != bases().end()) return *found;
  reject("basis", name, joined(basis_names(), " or "));
}

}  // namespace microslip
