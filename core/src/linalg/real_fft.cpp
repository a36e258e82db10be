// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/linalg/real_fft.hpp"

#include <fftw3.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <new>

#include "microslip/support/work.hpp"

namespace microslip {

using Eigen::Index;

/// Plans are never destroyed: there are few sizes, and threads may outlive main(). The map of plans
/// is not destroyed either, or leak checkers would report the plans.
struct RealFftPlans {
  fftw_plan forward;
  fftw_plan backward;
};

namespace {

/// Alignment for all instruction sets of FFTW. FFTW's own allocation would end the program when
/// memory runs out.
constexpr std::align_val_t alignment{64};

template <class Number>
Number* aligned(Index size) {
  return static_cast<Number*>(
      ::operator new(static_cast<std::size_t>(size) * sizeof(Number), alignment));
}

fftw_complex* as_fftw(std::complex<double>* values) {
  return reinterpret_cast<fftw_complex*>(values);
}

/// Number of operations of a transform.
double work_of(Index size) {
  const auto n = static_cast<double>(size);
  return 2.5 * n * std::log2(n);
}

/// The plans of a size, for arrays of the same alignment. FFTW can make plans in one thread at a
/// time only.
const RealFftPlans* plans_for(Index size, double* values, fftw_complex* spectrum) {
  static std::mutex mutex;
  static auto& known = *new std::map<Index, RealFftPlans>;
  const std::lock_guard lock(mutex);
  const auto [place, is_new] = known.try_emplace(size);
  if (is_new) {
    const int n = static_cast<int>(size);
    place->second = {fftw_plan_dft_r2c_1d(n, values, spectrum, FFTW_ESTIMATE),
                     fftw_plan_dft_c2r_1d(n, spectrum, values, FFTW_ESTIMATE)};
  }
  return &place->second;
}

}  // namespace

void RealFft::Free::operator()(void* array) const { ::operator delete(array, alignment); }

RealFft::RealFft(Index size)
    : size_(size),
      plans_(nullptr),
      values_(aligned<double>(size)),
      spectrum_(aligned<std::complex<double>>(size / 2 + 1)) {
  plans_ = plans_for(size, values_.get(), as_fftw(spectrum_.get()));
}

RealFft::~RealFft() = default;

RealFft::RealFft(const RealFft& other) : RealFft(other.size_) {
  std::copy_n(other.values_.get(), size_, values_.get());
  std::copy_n(other.spectrum_.get(), size_ / 2 + 1, spectrum_.get());
}

RealFft& RealFft::operator=(const RealFft& other) {
  if (this != &other) *this = RealFft(other);
  return *this;
}

RealFft::RealFft(RealFft&&) noexcept = default;
RealFft& RealFft::operator=(RealFft&&) noexcept = default;

Index RealFft::good_size(Index at_least) {
  Index unit = 2;
  while (32 * unit < at_least) unit *= 2;
  for (const Index factor : {16, 18, 20, 21, 24, 25, 27, 28, 30}) {
    if (factor * unit >= at_least) return factor * unit;
  }
  return 32 * unit;
}

void RealFft::forward() {
  count_work(work_of(size_));
  fftw_execute_dft_r2c(plans_->forward, values_.get(), as_fftw(spectrum_.get()));
}

void RealFft::backward() {
  count_work(work_of(size_));
  fftw_execute_dft_c2r(plans_->backward, as_fftw(spectrum_.get()), values_.get());
}

}  // namespace microslip
