// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch_material.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "component_pairs.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::VectorXd;
using std::numbers::pi;

namespace {

/// Records of material that has entered are not closer than this part of the half-length of a row,
/// over the number of cells.
constexpr double spacing_of_records = 0.5;

/// Records of cells that slip are not closer to others than this part of the cell.
constexpr double least_gap = 0.2;

/// The farthest origin of places, over the size of the contact.
constexpr double farthest_origin = 8;

MaterialRecords row_at_rest(const JoinedRows& rows, Index k, double size, double distance) {
  const double spacing = spacing_of_records * size * rows.half_length(k);
  return {size * rows.x(2 * rows.elements(), k) + distance, size * rows.x(0, k) + distance,
          spacing / static_cast<double>(rows.elements())};
}

void archive_edge(Archive& archive, const char* name, Eigen::MatrixX2d& edge) {
  VectorXd values = edge.reshaped();
  archive.numbers(name, values, edge.size());
  edge = values.reshaped(edge.rows(), 2);
}

}  // namespace

PatchMaterial::PatchMaterial(const JoinedRows& rows, double size, double distance)
    : distance_(distance),
      size_(size),
      edge_before_(Eigen::MatrixX2d::Zero(rows.rows(), 2)),
      edge_(edge_before_) {
  const double placed = size > 0 ? size : 1;
  for (Index k = 0; k < rows.rows(); ++k) memory_.push_back(row_at_rest(rows, k, placed, 0));
}

double PatchMaterial::ratio_before(double dq) const {
  constexpr double most = 5;
  return step_before_ > dq * most || step_before_ * most < dq ? 0 : step_before_ / dq;
}

void PatchMaterial::impose(const PatchStep& step, PointDisplacements& u,
                           const VectorXd& seen_before, ImposedSlip& found) const {
  const JoinedRows& rows = u.rows();
  const StepWays ways(rows, step);
  found.own.resize(2 * rows.cells());
  found.centre.resize(2 * rows.cells());
  found.seen.setZero(2 * rows.cells());
  const double part = ways.part_in_contact();
  for (Index k = 0; k < rows.rows(); ++k) {
    for (Index i = 0; i < rows.elements(); ++i) {
      const Index cell = rows.cell(i, k);
      if (step.dq == 0) {
        const Vector2d before = -u.at(2 * i + 1, k);
        set_pair(found.own, cell, before);
        set_pair(found.centre, cell, before);
        continue;
      }
      set_pair(found.own, cell, imposed_by(ways, ways.to_centre(i, k), k));
      Vector2d centre = imposed_by(ways, ways.about_centre(i, k), k);
      if (part > 0) centre += part * (-u.at(2 * i + 1, k) / step.dq - centre);
      set_pair(found.centre, cell, centre);
      if (ways.is_seen(i, k)) {
        const Vector2d before = pair_of(seen_before, cell);
        const Vector2d now = seen_from_contact(ways, i, k, u, found.own);
        set_pair(found.seen, cell, before + ways.part_seen(i, k) * (now - before));
      }
    }
  }
}

/// The displacement that material remembers, without the rigid slip.
/// \param x  at the end of a step dq
Vector2d PatchMaterial::remembered(const JoinedRows& rows, double x, Index k, double dq) const {
  const double place = x + travelled_ + dq;
  return memory_[static_cast<std::size_t>(k)].at(place) - path_.at(place, size_ * rows.y(k));
}

Vector2d PatchMaterial::imposed_by(const StepWays& ways, const MaterialWay& way, Index k) const {
  const PatchStep& step = ways.step();
  if (way.entered == 0) return -remembered(ways.rows(), way.x, k, step.dq) / way.length;
  const EntryWeights weights(way.entered, step.ratio);
  Vector2d at_entry = weights.before * edge_.row(k) + weights.earlier * edge_before_.row(k);
  at_entry -= ways.by_change_of_motion(way) * ways.rigid_slip_at_edge(k) * motion_;
  return -at_entry / way.length;
}

/// Computes the imposed part of the slip seen from the contact: its part without own slip, in which the
/// displacements at the end of the step are those that the material remembers.
Vector2d PatchMaterial::seen_from_contact(const StepWays& ways, Index i, Index k,
                                          PointDisplacements& u, const VectorXd& own) {
  const double dq = ways.step().dq;
  const Index cell = ways.rows().cell(i, k);
  const Vector2d here = -dq * pair_of(own, cell), ahead = -dq * pair_of(own, cell - 1);
  const Vector2d here_before = u.at(2 * i + 1, k), ahead_before = u.at(2 * i - 1, k);
  return (here + here_before - ahead - ahead_before) / (2 * ways.distance_ahead(i, k)) +
         (here - here_before + ahead - ahead_before) / (2 * dq);
}

void PatchMaterial::begin(PointDisplacements& u) {
  for (Index k = 0; k < u.rows().rows(); ++k) {
    edge_.row(k) = u.at(0, k);
    touch_anew(k, u);
  }
}

void PatchMaterial::take(const PatchStep& step, PointDisplacements& u,
                         const Eigen::Vector3d& motion, const std::vector<bool>& slips) {
  const JoinedRows& rows = u.rows();
  const bool grows = step.to != step.from;
  edge_before_ = edge_;
  for (Index k = 0; k < rows.rows(); ++k) edge_.row(k) = u.at(0, k);
  path_ = path_.after(motion, step.dq == 0 ? 1 : step.dq, travelled_ + step.dq / 2);
  travelled_ += step.dq;
  distance_ += step.dq;
  step_before_ = step.dq;
  motion_ = motion;
  for (Index k = 0; k < rows.rows(); ++k) {
    MaterialRecords& row = memory_[static_cast<std::size_t>(k)];
    const double y = size_ * rows.y(k);
    const double front = size_ * rows.x(0, k), exit = size_ * rows.x(2 * rows.elements(), k);
    if (grows && is_mostly_new(rows, k, step)) {
      touch_anew(k, u);
      continue;
    }
    if (step.dq > 0) {
      const double place = front + travelled_;
      row.enter(place, u.at(0, k) + path_.at(place, y));
      record_entered(k, u, step.dq);
      row.leave(exit + travelled_);
    }
    replace_where_slips(k, u, slips);
  }
  if (travelled_ > farthest_origin * size_) renew_origin(rows);
}

/// Tells whether a row takes in material at its trailing edge, or rolls over more than half of its
/// length. Records at the leading edge are too few then.
bool PatchMaterial::is_mostly_new(const JoinedRows& rows, Index k, const PatchStep& step) const {
  const double a = rows.shape().half_width(), b = rows.shape().lateral_half_width();
  const double y = step.to * rows.y(k) / b;
  const double before = a * std::sqrt(std::max(0.0, step.from * step.from - y * y));
  return step.dq >= before || step.to * rows.half_length(k) - before > step.dq;
}

/// Measures places and the path from here, with the same sums of displacement and rigid slip.
void PatchMaterial::renew_origin(const JoinedRows& rows) {
  for (Index k = 0; k < rows.rows(); ++k) {
    const double y = size_ * rows.y(k);
    memory_[static_cast<std::size_t>(k)].move([&](double place, Vector2d& value) {
      value -= path_.at(place, y);
      return place - travelled_;
    });
  }
  path_ = {};
  travelled_ = 0;
}

/// Material that entered within the step remembers where it is now, if it sticks: at points that are
/// not closer than half a mean cell, so that only a step of more than a cell has any. Records at the
/// leading edge alone would be too far from one another, and from those of cells that slip.
void PatchMaterial::record_entered(Index k, PointDisplacements& u, double dq) {
  const JoinedRows& rows = u.rows();
  MaterialRecords& row = memory_[static_cast<std::size_t>(k)];
  const double front = size_ * rows.x(0, k);
  const double half_cell = size_ * rows.half_length(k) / static_cast<double>(rows.elements());
  for (Index j = 1; j <= 2 * rows.elements() && size_ * rows.x(j, k) > front - dq; ++j) {
    const double place = size_ * rows.x(j, k) + travelled_;
    if (!row.has_room(place, half_cell)) continue;  // before the displacement is computed
    row.add(place, u.at(j, k) + path_.at(place, size_ * rows.y(k)), half_cell);
  }
}

/// Material that slips remembers where it is now: at the points of the cells, so that the next step
/// begins with what was solved, and not with values between records.
void PatchMaterial::replace_where_slips(Index k, PointDisplacements& u,
                                        const std::vector<bool>& slips) {
  const JoinedRows& rows = u.rows();
  MaterialRecords& row = memory_[static_cast<std::size_t>(k)];
  const auto place_of = [&](Index j) { return size_ * rows.x(j, k) + travelled_; };
  const auto is_slipping = [&](Index i) {
    return slips[static_cast<std::size_t>(rows.cell(i, k))];
  };
  for (Index i = 0; i < rows.elements(); ++i) {
    if (is_slipping(i)) row.forget(place_of(2 * i + 2), place_of(2 * i));
  }
  for (Index i = 0; i < rows.elements(); ++i) {
    if (!is_slipping(i)) continue;
    const double distance = least_gap * (place_of(2 * i) - place_of(2 * i + 2));
    for (const Index j : {2 * i + 1, 2 * i + 2}) {
      const double place = place_of(j);
      row.add(place, u.at(j, k) + path_.at(place, size_ * rows.y(k)), distance);
    }
  }
}

/// Lets a row remember the present displacements, all along.
void PatchMaterial::touch_anew(Index k, PointDisplacements& u) {
  const JoinedRows& rows = u.rows();
  MaterialRecords row = row_at_rest(rows, k, size_, travelled_);
  row.change([&](double place, Vector2d& value) {
    const double theta = rows.theta_of((place - travelled_) / size_, k);
    value = u.at_angle(theta, k) + path_.at(place, size_ * rows.y(k));
  });
  memory_[static_cast<std::size_t>(k)] = row;
}

PatchMaterial PatchMaterial::resized(const JoinedRows& rows, double size) const {
  if (size_ == 0) return {rows, size, distance_};
  PatchMaterial there = *this;
  for (Index k = 0; k < rows.rows(); ++k) {
    there.memory_[static_cast<std::size_t>(k)] = moved_row(rows, k, size);
  }
  there.size_ = size;
  return there;
}

/// A row at y of another size, by the four rows about it: with y = b sin(psi) and x = s a cos(psi),
/// what is remembered at equal s is a smooth function of psi, which continues beyond the ends with
/// psi' = pi - psi and s' = -s.
MaterialRecords PatchMaterial::moved_row(const JoinedRows& rows, Index k, double size) const {
  const double b = rows.shape().lateral_half_width(), a = rows.shape().half_width();
  const double y = size * rows.y(k), sine = std::clamp(y / (size_ * b), -1.0, 1.0);
  const double psi = std::asin(sine), half_length = size_ * a * std::cos(psi);
  const double at = (psi / pi + 0.5) * static_cast<double>(rows.rows()) - 0.5;
  const auto first = static_cast<Index>(std::floor(at)) - 1;
  const std::array<double, 4> weights = cubic_weights(at, first);
  const auto value_at = [&](Index row, double s) {
    const Index last = rows.rows() - 1;
    const bool is_mirrored = row < 0 || row > last;
    row = std::clamp<Index>(row < 0 ? -1 - row : row > last ? 2 * last + 1 - row : row, 0, last);
    const double x = (is_mirrored ? -s : s) * size_ * rows.half_length(row);
    return remembered(rows, x, row, 0);
  };
  MaterialRecords moved = memory_[static_cast<std::size_t>(k)];
  const double scale = half_length / (size_ * rows.half_length(k));
  moved.move([&](double place, Vector2d& value) {
    const double s = (place - travelled_) / (size_ * rows.half_length(k));
    const double there = travelled_ + scale * (place - travelled_);
    value.setZero();
    for (std::size_t j = 0; j < weights.size(); ++j) {
      value += weights[j] * value_at(first + static_cast<Index>(j), s);
    }
    value += path_.at(there, y);
    return there;
  });
  return moved;
}

void PatchMaterial::archive(Archive& archive) {
  archive.number("distance", distance_);
  archive.number("travelled", travelled_);
  archive.number("size", size_);
  archive.number("step_before", step_before_);
  archive.number("path_along", path_.along);
  archive.number("path_across", path_.across);
  archive.number("path_turn", path_.turn);
  VectorXd motion = motion_;
  archive.numbers("motion_before", motion, 3);
  motion_ = motion;
  archive_edge(archive, "edge_before", edge_before_);
  archive_edge(archive, "edge", edge_);
  for (MaterialRecords& row : memory_) row.archive(archive);
}

}  // namespace microslip
