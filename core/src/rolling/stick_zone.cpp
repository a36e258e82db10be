// SPDX-License-Identifier: GPL-3.0-or-later
#include "stick_zone.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "microslip/halfspace/chebyshev_field.hpp"
#include "microslip/linalg/matrix_product.hpp"
#include "microslip/support/not_converged.hpp"
#include "microslip/support/work.hpp"

namespace microslip {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using std::numbers::pi;

namespace {

/// Number of Chebyshev terms that resolve the regular strain to 1e-14 over a length.
double terms_for(double clear, double half_length) { return 22 / std::asinh(clear / half_length); }

constexpr double most_terms = 400;

SlipSide::Panels panels_of(const InvertedContact& contact) {
  return {.longest = contact.kernel.clear_distance(), .fineness = contact.fineness};
}

double one_norm(const MatrixXd& matrix) { return matrix.cwiseAbs().colwise().sum().maxCoeff(); }

}  // namespace

InvertedContact::InvertedContact(const Kernel& of_kernel, const TractionBound& of_bound,
                                 double of_fineness)
    : kernel(of_kernel),
      bound(of_bound),
      trailing(bound, SidedBound::Edge::trailing),
      leading(bound, SidedBound::Edge::leading),
      fineness(of_fineness) {
  if (leading.smooth()) sliding.emplace(kernel, bound);
}

double InvertedContact::sliding_creepage() const {
  return sliding ? sliding->strain(half_width()) : std::numeric_limits<double>::infinity();
}

StickZone::StickZone(std::shared_ptr<const InvertedContact> contact, double trailing,
                     double leading)
    : contact_(std::move(contact)),
      half_length_((contact_->end() - contact_->begin()) /
                   (std::cosh(trailing) + std::cosh(leading))),
      begin_(contact_->begin() + half_length_ * versine_of(trailing)),
      end_(contact_->end() - half_length_ * versine_of(leading)),
      trailing_(contact_->trailing, trailing, half_length_, panels_of(*contact_)),
      log_factor_(contact_->kernel.log_factor()) {
  if (leading > 0) {
    leading_.emplace(contact_->leading, leading, half_length_, panels_of(*contact_));
  }
  creepage_ = log_factor_ * trailing_.load().sum();
  force_ = half_length_ * (trailing_.load() * (1 + trailing_.versine())).sum();
  if (leading_) {
    creepage_ -= log_factor_ * leading_->load().sum();
    force_ += half_length_ * (leading_->load() * (1 + leading_->versine())).sum();
  }
  if (std::isfinite(contact_->kernel.clear_distance())) add_regular_strain();
}

/// Outward distance from b, or from c, over the half-length.
double StickZone::behind(double x) const { return (begin_ - x) / half_length_; }
double StickZone::before(double x) const { return (x - end_) / half_length_; }

double StickZone::leading_root() const {
  double root = trailing_.at_far_end() + (leading_ ? leading_->at_near_end() : 0);
  for (Index n = 0; n < added_.size(); ++n) root += pi * static_cast<double>(n + 1) * added_[n];
  return root;
}

/// The difference between the strains of a strip and of plane strain is smooth over the whole
/// contact. The strain's Chebyshev coefficients on the stick zone are the coefficients of the
/// tractions that cancel it there.
void StickZone::add_regular_strain() {
  const double terms =
      contact_->fineness * terms_for(contact_->kernel.clear_distance(), half_length_);
  if (terms > most_terms) throw NotConverged("steady rolling: the strip is too narrow", 0, 1);
  const Index m = 6 + static_cast<Index>(terms);
  const double step = pi / static_cast<double>(m + 1);
  const ArrayXd angles = step * ArrayXd::LinSpaced(m, 1, static_cast<double>(m));
  const double centre = (begin_ + end_) / 2;

  // Tractions from the plane inversion, and tractions of the slip zones, as line loads.
  VectorXd inverted = VectorXd::Zero(m);
  std::vector<double> places, loads;
  const auto take = [&](const SlipSide& side, double edge, double outward) {
    const ArrayXd sines = (side.versine() * (2 + side.versine())).sqrt();
    ArrayXd powers = side.load() * 2 / pi * -outward;
    const ArrayXd decay = outward * (-side.theta()).exp();
    for (Index n = 0; n < m; ++n) {
      powers *= decay;
      inverted[n] -= powers.sum();
    }
    for (Index i = 0; i < side.load().size(); ++i) {
      places.push_back(edge + outward * half_length_ * side.versine()[i]);
      loads.push_back(half_length_ * sines[i] * side.load()[i]);
    }
  };
  take(trailing_, begin_, -1);
  if (leading_) take(*leading_, end_, 1);
  MatrixXd as_loads(m, m);
  ArrayXd before = ArrayXd::Zero(m);
  ArrayXd sines = angles.sin();
  for (Index n = 0; n < m; ++n) {
    as_loads.col(n) = half_length_ * step * angles.sin() * sines;
    const ArrayXd next = 2 * angles.cos() * sines - before;
    before = std::exchange(sines, next);
  }
  const VectorXd stuck = as_loads * inverted;
  const auto beside = static_cast<Index>(places.size());
  places_.resize(beside + m);
  loads_.resize(beside + m);
  places_ << Eigen::Map<const VectorXd>(places.data(), beside),
      (centre + half_length_ * angles.cos()).matrix();
  loads_ << Eigen::Map<const VectorXd>(loads.data(), beside), stuck;

  MatrixXd matrix(m + 1, m + 1), decays_of_zone(m + 1, m);
  VectorXd strain(m + 1);
  VectorXd decays(beside + m);
  for (Index i = 0; i <= m; ++i) {
    const double place = std::cos(step * (static_cast<double>(i) + 0.5));
    const double x = centre + half_length_ * place;
    visit_half_space(
        [&](const auto& kernel) {
          for (Index j = 0; j < beside + m; ++j) decays[j] = kernel.regular_decay(x - places_[j]);
        },
        contact_->kernel);
    strain[i] = -decays.dot(loads_);
    decays_of_zone.row(i) = decays.tail(m);
    double last = 1;
    double cosine = place;
    for (Index n = 0; n < m; ++n) {
      matrix(i, n) = pi * log_factor_ * cosine;
      last = std::exchange(cosine, 2 * place * cosine - last);
    }
    matrix(i, m) = -1;
  }
  matrix.leftCols(m) += matrix_product(decays_of_zone, as_loads);
  count_work(std::pow(m + 1, 2) * (kernel_work + 4 * static_cast<double>(m)));
  matrix.leftCols(m) /= log_factor_;
  strain /= log_factor_;
  norm_ = one_norm(matrix);
  factors_.emplace(matrix);
  const VectorXd unknowns = factors_->solve(strain);
  added_ = unknowns.head(m);
  added_creepage_ = log_factor_ * unknowns[m];
  loads_.tail(m) += as_loads * added_;
  creepage_ += added_creepage_;
  force_ += half_length_ * pi / 2 * added_[0];
}

void StickZone::complete() {
  const double clear = contact_->kernel.clear_distance();
  if (!std::isfinite(clear)) return;
  condition_ = norm_ * one_norm(factors_->inverse());
  const double a = contact_->half_width();
  const auto at = [this](double x) {
    count_work(kernel_work * static_cast<double>(loads_.size()));
    return visit_half_space(
        [&](const auto& kernel) {
          double strain = 0;
          for (Index j = 0; j < loads_.size(); ++j) {
            strain += loads_[j] * kernel.regular_decay(x - places_[j]);
          }
          return strain;
        },
        contact_->kernel);
  };
  const auto terms = static_cast<Index>(contact_->fineness * terms_for(clear, a)) + 6;
  regular_.emplace(chebyshev_points(a, terms + 1).unaryExpr(at), a);
}

double StickZone::regular_strain(double x) const { return regular_ ? (*regular_)(x) : 0; }

double StickZone::transform(double x) const {
  return trailing_.transform(behind(x)) + (leading_ ? leading_->transform(before(x)) : 0);
}

double StickZone::traction(double x) const {
  if (x < begin_ || x > end_) return contact_->bound_at(x);
  double traction = transform(x) / pi;
  if (added_.size() > 0) {
    traction += ChebyshevTraction(begin_, end_, added_)(x);
  }
  return traction;
}

double StickZone::slip(double x) const {
  if (x >= begin_ && x <= end_) return 0;
  const bool trails = x < begin_;
  double slip = log_factor_ * (trails ? -transform(x) : transform(x));
  if (!regular_) return slip;
  const double theta = theta_of(trails ? behind(x) : before(x));
  const double ratio = (trails ? -1 : 1) * std::exp(-theta);
  double strain = 0;
  for (Index n = added_.size() - 1; n >= 0; --n) strain = ratio * (added_[n] + strain);
  return slip + added_creepage_ - pi * log_factor_ * strain - regular_strain(x);
}

/// Returns the distance from a violation, over its scale: the bound less the traction, or the slip.
/// Below zero there is a violation.
double StickZone::margin(double x) const {
  if (x < begin_ || x > end_) return slip(x) / creepage_;
  const double bound = contact_->bound_at(x);
  return (bound - traction(x)) / (bound + force_ / contact_->half_width());
}

/// Places at which the conditions are looked at, ascending: in each piece of a table, in equal
/// parts of the contact under a smooth bound, and close to the ends of the zone.
std::vector<double> StickZone::places() const {
  constexpr Index parts = 100;
  constexpr Index many_rows = 100;
  constexpr std::size_t few_places = 3;
  constexpr std::size_t most_looked_at = 2000;
  constexpr double in_piece[] = {0.5,  1e-2, 0.99, 1e-3, 0.999,  0.25,
                                 0.75, 0.05, 0.95, 1e-5, 0.99999};
  const auto* table = std::get_if<TabulatedBound>(&contact_->bound);
  const double a = contact_->half_width();
  const VectorXd rows = table != nullptr ? table->x() : VectorXd::LinSpaced(parts + 1, -a, a);
  const double rounding = 1e-10 * a;  // rounding error of a position
  std::vector<double> ends(rows.begin(), rows.end());
  ends.insert(ends.end(), {begin_, end_});
  std::sort(ends.begin(), ends.end());
  const std::size_t stride = 1 + ends.size() / most_looked_at;
  const std::size_t count = rows.size() > many_rows + 1 ? few_places : std::size(in_piece);
  std::vector<double> places;
  for (std::size_t i = 0; i + 1 < ends.size(); i += stride) {
    for (std::size_t k = 0; k < count; ++k) {
      const double x = ends[i] + in_piece[k] * (ends[i + 1] - ends[i]);
      if (x - ends[i] > rounding && ends[i + 1] - x > rounding) places.push_back(x);
    }
  }
  std::sort(places.begin(), places.end());
  return places;
}

bool StickZone::keeps_conditions() const {
  constexpr double rounding = 1e-9;
  constexpr int bits = 20;
  constexpr double near_zero = 0.5;  // a least margin above this cannot be a violation in between
  const auto sticks = [this](double x) { return x >= begin_ && x <= end_; };
  const std::vector<double> x = places();
  std::vector<double> margins;
  for (const double place : x) {
    margins.push_back(margin(place));
    if (margins.back() < -rounding) return false;
  }
  // A bound may come close to the traction between places, as in a narrow valley.
  for (std::size_t i = 1; i + 1 < x.size(); ++i) {
    if (margins[i] > std::min(margins[i - 1], margins[i + 1]) || margins[i] > near_zero) continue;
    if (sticks(x[i - 1]) != sticks(x[i + 1])) continue;
    std::uintmax_t most = 40;
    const auto least = boost::math::tools::brent_find_minima(
        [this](double place) { return margin(place); }, x[i - 1], x[i + 1], bits, most);
    if (least.second < -rounding) return false;
  }
  return true;
}

double StickZone::displacement_at_end() const {
  const auto part = [](const SlipSide& side) {
    return (side.load() * side.theta() * (side.versine() * (2 + side.versine())).sqrt()).sum();
  };
  double loaded = force_;
  if (added_.size() > 0) loaded -= half_length_ * pi / 2 * added_[0];
  const double moment = part(trailing_) + (leading_ ? part(*leading_) : 0);
  double u = log_factor_ * (std::log(2 / half_length_) * loaded - half_length_ * moment) -
             half_length_ * (creepage_ - added_creepage_);
  const auto regular = [&](const auto& kernel) {
    if (added_.size() == 0) return force_ * kernel.regular_displacement(1);
    double sum = 0;
    for (Index j = 0; j < loads_.size(); ++j) {
      sum += loads_[j] * kernel.regular_displacement(end_ - places_[j]);
    }
    return sum;
  };
  u += visit_half_space(regular, contact_->kernel);
  if (added_.size() > 0) {
    const PlaneKernel plain(contact_->kernel.material(), 1);
    u += ChebyshevField(plain, ChebyshevTraction(begin_, end_, added_)).displacement(end_);
  }
  return u;
}

/// The integral of slip over x, from < to, both on the same side of the stick zone.
double StickZone::slip_between(double from, double to) const {
  constexpr double parts_of_contact = 50;
  const bool trails = to <= begin_;
  const auto theta = [&](double x) { return theta_of(trails ? behind(x) : before(x)); };
  const double first = theta(trails ? to : from);
  const double last = theta(trails ? from : to);
  const double parts = std::ceil((to - from) / contact_->half_width() * parts_of_contact);
  const double width = (last - first) / std::max(1.0, parts);
  const auto at = [&](double angle) {
    const double v = versine_of(angle);
    const double x = trails ? begin_ - half_length_ * v : end_ + half_length_ * v;
    return slip(x) * half_length_ * std::sinh(angle);
  };
  double sum = 0;
  for (int k = 0; k < static_cast<int>(parts); ++k) {
    sum += boost::math::quadrature::gauss<double, 4>::integrate(at, first + k * width,
                                                                first + (k + 1) * width);
  }
  return sum;
}

VectorXd StickZone::displacement(const VectorXd& x) const {
  const double at_end = displacement_at_end();
  const Index n = x.size();
  VectorXd u(n);
  const Index sticking = std::lower_bound(x.begin(), x.end(), begin_) - x.begin();
  const Index leading = std::upper_bound(x.begin(), x.end(), end_) - x.begin();
  double slipped = 0;
  double from = begin_;
  for (Index i = sticking - 1; i >= 0; --i) {
    slipped += slip_between(x[i], from);
    from = x[i];
    u[i] = at_end + creepage_ * (end_ - x[i]) - slipped;
  }
  for (Index i = sticking; i < leading; ++i) u[i] = at_end + creepage_ * (end_ - x[i]);
  slipped = 0;
  from = end_;
  for (Index i = leading; i < n; ++i) {
    slipped += slip_between(from, x[i]);
    from = x[i];
    u[i] = at_end - creepage_ * (x[i] - end_) + slipped;
  }
  return u;
}

}  // namespace microslip
