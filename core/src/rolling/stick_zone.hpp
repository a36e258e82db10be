// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "microslip/friction/sliding_field.hpp"
#include "microslip/friction/traction_bound.hpp"
#include "microslip/halfspace/kernel.hpp"
#include "microslip/linalg/lu_factors.hpp"
#include "microslip/support/chebyshev_series.hpp"
#include "slip_side.hpp"

namespace microslip {

/// The contact in which stick zones are searched: kernel, bound and quadratures.
class InvertedContact {
 public:
  /// \param fineness  see InvertedRolling
  InvertedContact(const Kernel& kernel, const TractionBound& bound, double fineness);

  Kernel kernel;
  TractionBound bound;
  SidedBound trailing, leading;
  std::optional<SlidingField> sliding;  ///< none for a table
  double fineness;

  /// Whether the bound falls to the leading edge faster than a traction in adhesion does.
  bool slips_before() const { return !leading.smooth() && leading.values().front() == 0; }

  /// The least creepage of full sliding; inf if it is unknown  [1]
  double sliding_creepage() const;

  double bound_at(double x) const {
    return std::visit([&](const auto& g) { return g(x); }, bound);
  }

  double half_width() const { return half_width_of(bound); }
  double begin() const { return -half_width() + trailing.begin(); }
  double end() const { return half_width() - leading.begin(); }
};

/// A stick zone [b, c] and the solution that follows from the slip zones beside it, under a
/// positive creepage. Tractions are counted as positive here.
class StickZone {
 public:
  /// \param trailing  theta of the trailing slip zone's outer end, > 0
  /// \param leading   theta of the leading slip zone's outer end; 0 if there is no such zone
  StickZone(std::shared_ptr<const InvertedContact> contact, double trailing, double leading);

  double begin() const { return begin_; }        ///< b  [mm]
  double end() const { return end_; }            ///< c  [mm]
  double creepage() const { return creepage_; }  ///< w  [1]
  double force() const { return force_; }        ///< [N/mm]

  /// Coefficient, over pi, of the square root with which the traction leaves the bound at c. It has
  /// to be zero if the bodies slip ahead of the stick zone.
  double leading_root() const;

  /// Returns leading_root() over the contribution of the trailing slip zone.
  double relative_leading_root() const { return leading_root() / trailing_.at_far_end(); }

  // Number of equations for the regular strain of a strip.
  Eigen::Index unknowns() const { return added_.size(); }
  double condition() const { return condition_; }  ///< in the 1-norm; only for a complete zone

  const InvertedContact& contact() const { return *contact_; }

  double traction(double x) const;
  double slip(double x) const;
  Eigen::VectorXd displacement(const Eigen::VectorXd& x) const;

  /// Whether tractions keep the bound in adhesion and slip has the direction of the creepage, at
  /// many places: close to each row of a table and to the ends of the stick zone, too.
  bool keeps_conditions() const;

  /// Prepares the data that only tractions, slip and displacement need.
  void complete();

 private:
  double margin(double x) const;
  std::vector<double> places() const;
  double transform(double x) const;
  double behind(double x) const;
  double before(double x) const;
  void add_regular_strain();
  double regular_strain(double x) const;
  double displacement_at_end() const;
  double slip_between(double from, double to) const;

  std::shared_ptr<const InvertedContact> contact_;
  double half_length_, begin_, end_;
  SlipSide trailing_;
  std::optional<SlipSide> leading_;
  double log_factor_;
  double creepage_, force_;

  // Contributions of the regular strain of a strip.
  std::optional<LuFactors> factors_;
  double norm_ = 1;  ///< of the matrix
  double condition_ = 1;
  Eigen::VectorXd added_;      ///< coefficients of sqrt(1 - t^2) U_n(t)  [N/mm^2]
  double added_creepage_ = 0;  ///< [1]
  Eigen::VectorXd places_;     ///< of all tractions as line loads  [mm]
  Eigen::VectorXd loads_;      ///< [N/mm]
  std::optional<ChebyshevSeries> regular_;
};

}  // namespace microslip
