// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/rolling/contact.hpp"

#include <gtest/gtest.h>

#include "microslip/rolling/steady.hpp"
#include "microslip/rolling/transient_problem.hpp"

namespace microslip::contact_test {

const Material material{82000, 0.28};

Contact under_a_table() {
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(9, -1, 1);
  return {PlaneKernel(material, 10), TabulatedBound(1, x, Eigen::VectorXd::Ones(9))};
}

// A problem is made of parts in braces. The compiler must destroy the contact once if a part that
// follows is refused: GCC 12 did so twice while the contact was an aggregate.
TEST(Contact, IsDestroyedOnceIfTheGridIsRefused) {
  const Contact contact = under_a_table();
  const auto steady = [&](double half_width) {
    return SteadyProblem{.contact = {contact.kernel, contact.bound},
                         .grid = Grid({.half_width = half_width, .elements = 20}),
                         .load = PrescribedCreepage{1e-3}};
  };
  const auto transient = [&](double half_width) {
    return TransientProblem{.contact = {contact.kernel, contact.bound},
                            .grid = Grid({.half_width = half_width, .elements = 20}),
                            .basis = constant_basis(),
                            .scheme = Remembered{}};
  };
  for (int i = 0; i < 3; ++i) {
    EXPECT_THROW(steady(-1), std::invalid_argument);
    EXPECT_THROW(transient(-1), std::invalid_argument);
  }
  EXPECT_EQ(steady(1).grid.size(), 20);
  EXPECT_EQ(transient(1).grid.size(), 20);
}

TEST(Contact, UnlikeBodiesAreInPlaneStrain) {
  EXPECT_NO_THROW(validate(under_a_table()));
  EXPECT_NO_THROW(validate(Contact(PlaneKernel(material, 10), HertzBound(1, 1), 1e-6)));
  EXPECT_NO_THROW(validate(Contact(StripKernel(material, 10), HertzBound(1, 1))));
  EXPECT_THROW(validate(Contact(StripKernel(material, 10), HertzBound(1, 1), 1e-6)),
               std::invalid_argument);
}

}  // namespace microslip::contact_test
