// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <complex>
#include <memory>

namespace microslip {

/// Discrete Fourier transforms of n real numbers, with the arrays for input and output. Plans are
/// estimated, not measured, so that the same size always gives the same digits. Each size has one
/// plan, which all threads share; an object itself serves one thread.
class RealFft {
 public:
  /// \param size  n, >= 1; fast if it is a product of 2, 3, 5 and 7, see good_size()
  explicit RealFft(Eigen::Index size);
  ~RealFft();
  RealFft(const RealFft& other);  ///< with arrays of its own
  RealFft& operator=(const RealFft& other);
  RealFft(RealFft&&) noexcept;
  RealFft& operator=(RealFft&&) noexcept;

  /// The next of a few even fast sizes: at least 32, and above 32 at most a seventh more than the
  /// argument. Few sizes mean few plans; making a plan takes as long as many transforms.
  static Eigen::Index good_size(Eigen::Index at_least);

  Eigen::Index size() const { return size_; }

  Eigen::Map<Eigen::VectorXd> values() { return {values_.get(), size_}; }
  /// n/2 + 1 coefficients; the coefficients of negative frequencies are their conjugates.
  Eigen::Map<Eigen::VectorXcd> spectrum() { return {spectrum_.get(), size_ / 2 + 1}; }

  /// spectrum = sum of values exp(-2 pi i j k / n)
  void forward();

  /// values = sum of spectrum exp(2 pi i j k / n), n times the values before forward(). The
  /// spectrum is overwritten.
  void backward();

 private:
  struct Free {
    void operator()(void* array) const;
  };

  Eigen::Index size_;
  const struct RealFftPlans* plans_;
  std::unique_ptr<double[], Free> values_;
  std::unique_ptr<std::complex<double>[], Free> spectrum_;
};

}  // namespace microslip
