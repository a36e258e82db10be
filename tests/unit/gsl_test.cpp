// SPDX-License-Identifier: GPL-3.0-or-later
// GSL's error handler ends the program by default, and belongs to the program that uses this
// library: errors of GSL are exceptions here, and the handler stays as it was.
#include <gsl/gsl_errno.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <thread>
#include <vector>

#include "microslip/halfspace/kernel_types.hpp"
#include "microslip/linalg/inverse_norm.hpp"
#include "microslip/support/not_converged.hpp"
#include "microslip/support/quadrature.hpp"

namespace microslip::gsl_test {

using Eigen::VectorXd;

int errors_seen = 0;

void count_error(const char*, const char*, int, int) { ++errors_seen; }

/// Sets a handler as a program might that uses GSL, too.
class Gsl : public testing::Test {
 protected:
  Gsl() : former_(gsl_set_error_handler(count_error)) { errors_seen = 0; }

  ~Gsl() override {
    EXPECT_EQ(errors_seen, 0);
    EXPECT_EQ(gsl_set_error_handler(former_), count_error);
  }

  static void expect_own_handler() { GSL_ERROR_VAL("the program's own", GSL_EFAILED, ); }

 private:
  gsl_error_handler_t* former_;
};

double pole(double x) { return 1 / x; }

TEST_F(Gsl, AQuadratureThatFailsThrows) {
  EXPECT_THROW(integrate(pole, 0, 1, 1e-10), NotConverged);
}

TEST_F(Gsl, ACosineIntegralOutOfRangeThrows) {
  const SymbolKernel kernel(VectorXd{{1, 2}}, VectorXd{{1, 0.6}});
  for (const double z : {0.0, -1.0}) EXPECT_THROW(kernel.displacement(z), std::invalid_argument);
  for (const double z : {1e-300, 1e-3, 1e3, 1e15, 1e300}) {
    EXPECT_TRUE(std::isfinite(kernel.displacement(z))) << z;
  }
}

TEST_F(Gsl, ExceptionsOfFunctionsArriveAsTheyAre) {
  const auto fails = [](double) -> double { throw std::domain_error("of the function"); };
  EXPECT_THROW(integrate(fails, 0, 1, 1e-10), std::domain_error);
  const auto solve = [](VectorXd&) { throw std::domain_error("of the solve"); };
  EXPECT_THROW(inverse_norm(4, solve, solve), std::domain_error);
}

TEST_F(Gsl, TheHandlerComesBackAlsoFromSeveralThreads) {
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([] {
      for (int k = 0; k < 500; ++k) {
        EXPECT_THROW(integrate([](double x) { return std::sin(x); }, 0, 2 * M_PI, 1e-13),
                     NotConverged);
        EXPECT_NEAR(integrate([](double x) { return std::sqrt(x); }, 0, 1, 1e-10), 2. / 3, 1e-10);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  expect_own_handler();
  EXPECT_EQ(errors_seen, 1);
  errors_seen = 0;
}

}  // namespace microslip::gsl_test
