// SPDX-License-Identifier: GPL-3.0-or-later
#include "ellipse_wiggles_runs.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact_ellipse.hpp"
#include "contact_transients.hpp"

namespace microslip::experiments::ellipse_wiggles_study {

using Eigen::Index;
using Eigen::VectorXd;
using std::numbers::pi;

namespace {

const EllipticBound& bound() {
  static const EllipticBound of = contact_rectangles(1).bound;
  return of;
}

/// Cells of joined rows about the line y = a/N, on which stations lie.
class JoinedLine {
 public:
  JoinedLine(Index rows, Index elements, double y) : elements_(elements), y_(y) {
    for (const Index k : {rows / 2, rows / 2 + 1}) {
      const double psi = ((static_cast<double>(k) + 0.5) / static_cast<double>(rows) - 0.5) * pi;
      rows_.push_back({k, std::sin(psi), std::cos(psi)});
    }
  }

  /// A traction that is even in y, by the parabola through two rows.
  double traction(const VectorXd& tractions, double x) const {
    const double first = in_row(tractions, rows_[0], x), second = in_row(tractions, rows_[1], x);
    const double part =
        (y_ * y_ - rows_[0].y * rows_[0].y) / (rows_[1].y * rows_[1].y - rows_[0].y * rows_[0].y);
    return first + part * (second - first);
  }

  bool sticks(const std::vector<bool>& slips, double x) const {
    return std::ranges::none_of(rows_, [&](const Row& row) {
      const double s = x / row.half_length;
      if (std::abs(s) >= 1) return true;
      const auto i = static_cast<Index>(std::acos(s) / pi * static_cast<double>(elements_));
      return static_cast<bool>(
          slips[static_cast<std::size_t>(std::min(i, elements_ - 1) + elements_ * row.k)]);
    });
  }

 private:
  struct Row {
    Index k;
    double y, half_length;
  };

  /// By the cubic in theta of p/tan(theta/2), which is smooth up to the edges; 0 beyond these.
  double in_row(const VectorXd& tractions, const Row& row, double x) const {
    if (std::abs(x) >= row.half_length) return 0;
    const double theta = std::acos(x / row.half_length);
    const double at = theta / pi * static_cast<double>(elements_) - 0.5;
    const Index first = std::clamp<Index>(static_cast<Index>(std::floor(at)) - 1, 0, elements_ - 4);
    double value = 0;
    for (Index i = first; i < first + 4; ++i) {
      double weight = 1;
      for (Index j = first; j < first + 4; ++j) {
        if (j != i) weight *= (at - static_cast<double>(j)) / static_cast<double>(i - j);
      }
      const double centre = (static_cast<double>(i) + 0.5) * pi / static_cast<double>(elements_);
      value += weight * tractions[i + elements_ * row.k] / std::tan(centre / 2);
    }
    return value * std::tan(theta / 2);
  }

  Index elements_;
  double y_;
  std::vector<Row> rows_;
};

RolledCircle state_of(const auto& scheme, double distance) {
  const double full = bound().total();
  return {.distance = distance,
          .resultants = scheme.resultants() / full,
          .motion = scheme.motion(),
          .tractions = scheme.tractions() / bound().peak(),
          .slips = scheme.slips(),
          .line = {},
          .sticks = {}};
}

template <class Scheme>
Course roll(Scheme& scheme, const Rolling& rolling, double step,
            const std::vector<double>& distances, const auto& sample) {
  if (rolling.after_shift) {
    PatchLoad held{};
    held[0] = {true, -contact_force * bound().total()};
    scheme.shift(held);
  }
  Course course;
  double distance = 0;
  for (const double end : distances) {
    const auto steps = std::max<long>(1, std::lround(std::ceil((end - distance) / step - 1e-6)));
    const double length = (end - distance) / static_cast<double>(steps);
    for (long s = 0; s < steps; ++s) {
      scheme.roll(length, rolling.load);
      course.steps.push_back({distance + length / 2, length, scheme.motion()});
      distance += length;
    }
    distance = end;
    course.at.push_back(state_of(scheme, distance));
    sample(course.at.back());
  }
  return course;
}

}  // namespace

SteadyPatch joined_circle(Index rows, Index elements) {
  return {.material = contact_rectangles(1).material,
          .bound = bound(),
          .rows = rows,
          .elements = elements};
}

VectorXd stations(Index elements) {
  return VectorXd::NullaryExpr(elements, [&](Index i) {
    return (2 * static_cast<double>(i) + 1) / static_cast<double>(elements) - 1;
  });
}

Course rolled(PatchRolling scheme, const SteadyPatch& of, const Rolling& rolling, double step,
              const std::vector<double>& distances, Index count) {
  const JoinedLine line(of.rows, of.elements, 1 / static_cast<double>(count));
  const VectorXd x = stations(count);
  const double half = 1 / static_cast<double>(count);
  return roll(scheme, rolling, step, distances, [&](RolledCircle& state) {
    state.line.resize(count);
    for (Index i = 0; i < count; ++i) {
      state.line[i] = line.traction(state.tractions.col(rolling.component), x[i]);
      state.sticks.push_back(line.sticks(state.slips, x[i] - half) &&
                             line.sticks(state.slips, x[i]) &&
                             line.sticks(state.slips, x[i] + half));
    }
  });
}

Course rolled(RectangleRolling scheme, const Rolling& rolling, double step,
              const std::vector<double>& distances) {
  const VectorXd x = scheme.x(), y = scheme.y();
  const auto count = static_cast<Index>(std::lround(2 / scheme.element()));
  const double middle = 1 / static_cast<double>(count);
  std::vector<Index> row;  // elements from the trailing edge on
  for (Index i = 0; i < x.size(); ++i) {
    if (std::abs(y[i] - middle) < middle / 2) row.push_back(i);
  }
  std::ranges::sort(row, {}, [&](Index i) { return x[i]; });
  return roll(scheme, rolling, step, distances, [&](RolledCircle& state) {
    state.line.resize(static_cast<Index>(row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) {
      state.line[static_cast<Index>(i)] = state.tractions(row[i], rolling.component);
      state.sticks.push_back(!state.slips[static_cast<std::size_t>(row[i])]);
    }
  });
}

}  // namespace microslip::experiments::ellipse_wiggles_study
