// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/halfspace/influence.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "digits/reference_kernel.hpp"
#include "microslip/halfspace/basis.hpp"

namespace microslip::influence_test {

using namespace test;
using Reference = ReferenceInfluence<Digits100>;

constexpr std::array poisson_ratios = {0.0, 0.28, 0.5};
constexpr std::array offsets = {0.0, 1.0, -1.0, 2.0, -2.0, 0.3, 0.5, -0.77, -7.0, 100.0, 1e6, -1e6};
constexpr std::array shifts = {1e-15, 1e-12, 1e-9, 1e-5, 0.01, 0.3, 0.5, 0.77, 1.0, 2.0, 40.0, 1e3};

struct InfluenceCase : Stated {
  ShapeFunction shape;
  bool plane;

  /// Dy/dx; 0 for plane strain
  std::vector<double> widths() const {
    return plane ? std::vector{0.0} : std::vector{1e-3, 0.01, 1.0, 40.0, 1e4, 1e8};
  }
};

template <class Visit>
void for_each_kernel(const InfluenceCase& c, const Visit& visit) {
  for (const double width : c.widths()) {
    for (const double nu : poisson_ratios) {
      visit(kernel_of({1, nu}, width), Reference({nu, width}, c.shape), width, nu);
    }
  }
}

class InfluenceDigits : public testing::TestWithParam<InfluenceCase> {};
class InfluenceDifferenceDigits : public testing::TestWithParam<InfluenceCase> {};

TEST_P(InfluenceDigits, AgreesWith100Digits) {
  const InfluenceCase& c = GetParam();
  WorstCase worst;
  for_each_kernel(
      c, [&](const Kernel& kernel, const Reference& reference, double width, double nu) {
        for (const double offset : offsets) {
          worst.meet(relative_error(influence(kernel, c.shape, 1, offset), reference(offset)),
                     place({{"offset", offset}, {"width", width}, {"nu", nu}}));
        }
      });
  expect_as_stated(c, worst);
  EXPECT_LE(worst.error(), 2e-15);
}

// The diagonal entry vanishes like c^2 and, for c = -2 offset, an entry vanishes by symmetry: those
// are held against the largest entry of the row.
TEST_P(InfluenceDifferenceDigits, AgreesWith100Digits) {
  const InfluenceCase& c = GetParam();
  WorstCase worst;
  for_each_kernel(
      c, [&](const Kernel& kernel, const Reference& reference, double width, double nu) {
        std::map<double, Digits100> values;
        const auto value_at = [&](double offset) {
          const auto [found, is_new] = values.try_emplace(offset, 0);
          if (is_new) found->second = reference(offset);
          return found->second;
        };
        for (const double shift : shifts) {
          const auto exact_at = [&](double offset) {
            return Digits100(value_at(offset) - reference(Digits100(offset) + shift));
          };
          const Digits100 largest = std::max(abs(exact_at(0)), abs(exact_at(-1)));
          for (const double offset : offsets) {
            const Digits100 exact = exact_at(offset);
            const bool small = offset == 0 || shift == -2 * offset;
            worst.meet(relative_error(influence_difference(kernel, c.shape, 1, offset, shift),
                                      exact, small ? largest : exact),
                       place({{"c", shift}, {"offset", offset}, {"width", width}, {"nu", nu}}));
          }
        }
      });
  expect_as_stated(c, worst);
  EXPECT_LE(worst.error(), c.plane ? 2e-15 : 2e-13);
}

ShapeFunction shape_named(const std::string& name) {
  const auto second = [](const Basis& basis) { return basis.shapes()[1]; };
  if (name == "constant") return constant_shape();
  if (name == "linear") return linear_shape();
  if (name == "bubble") return quadratic_basis().shapes()[0];
  if (name == "vertex") return second(quadratic_basis());
  if (name == "vertex_as_printed") return second(quadratic_basis_as_printed());
  if (name == "trimmed_1em9") return second(trimmed_linear_basis(1e-9));
  if (name == "trimmed_0p4") return second(trimmed_linear_basis(0.4));
  return second(edge_constant_basis());
}

/// \param stated  subject: a function's name, and plane or strip
std::vector<InfluenceCase> cases(const std::vector<Stated>& stated) {
  std::vector<InfluenceCase> all;
  for (const Stated& s : stated) {
    const std::size_t end = s.subject.rfind('_');
    all.push_back({s, shape_named(s.subject.substr(0, end)), s.subject.substr(end) == "_plane"});
  }
  return all;
}

const std::vector<Stated> influences = {
    {"constant_plane", 2e-15, "offset_1_width_0_nu_0"},
    {"constant_strip", 4e-16, "offset_0p5_width_1e8_nu_0p28"},
    {"linear_plane", 2e-15, "offset_1_width_0_nu_0"},
    {"linear_strip", 4e-16, "offset_1e6_width_1_nu_0"},
    {"bubble_plane", 5e-16, "offset_1_width_0_nu_0"},
    {"bubble_strip", 5e-16, "offset_1e6_width_1_nu_0"},
    {"vertex_plane", 6e-16, "offset_1_width_0_nu_0p28"},
    {"vertex_strip", 4e-16, "offset_2_width_0p001_nu_0"},
    {"vertex_as_printed_plane", 2e-15, "offset_1_width_0_nu_0p28"},
    {"vertex_as_printed_strip", 4e-16, "offset_1e6_width_1_nu_0"},
    {"trimmed_1em9_plane", 9e-16, "offset_1_width_0_nu_0"},
    {"trimmed_1em9_strip", 4e-16, "offset_0p3_width_0p001_nu_0"},
    {"trimmed_0p4_plane", 8e-16, "offset_1_width_0_nu_0p28"},
    {"trimmed_0p4_strip", 4e-16, "offset_0_width_0p001_nu_0p28"},
    {"edge_constant_plane", 5e-16, "offset_1_width_0_nu_0p28"},
    {"edge_constant_strip", 3e-16, "offset_0p5_width_1e8_nu_0p28"},
};

const std::vector<Stated> differences = {
    {"constant_plane", 1e-15, "c_1em15_offset_0p5_width_0_nu_0"},
    {"constant_strip", 5e-15, "c_0p5_offset_m1_width_0p001_nu_0"},
    {"linear_plane", 6e-16, "c_1em15_offset_m2_width_0_nu_0"},
    {"linear_strip", 4e-14, "c_1em15_offset_0_width_0p001_nu_0"},
    {"bubble_plane", 6e-16, "c_1000_offset_100_width_0_nu_0"},
    {"bubble_strip", 2e-14, "c_1em5_offset_m1_width_0p001_nu_0"},
    {"vertex_plane", 2e-15, "c_0p01_offset_2_width_0_nu_0"},
    {"vertex_strip", 7e-14, "c_1em12_offset_0_width_0p001_nu_0"},
    {"vertex_as_printed_plane", 8e-16, "c_1em15_offset_m7_width_0_nu_0"},
    {"vertex_as_printed_strip", 2e-13, "c_1em12_offset_0_width_0p001_nu_0"},
    {"trimmed_1em9_plane", 9e-16, "c_1em15_offset_m7_width_0_nu_0p28"},
    {"trimmed_1em9_strip", 2e-14, "c_1em5_offset_m1_width_0p001_nu_0"},
    {"trimmed_0p4_plane", 4e-16, "c_0p3_offset_0p5_width_0_nu_0"},
    {"trimmed_0p4_strip", 4e-14, "c_1em15_offset_0_width_0p001_nu_0"},
    {"edge_constant_plane", 5e-16, "c_1000_offset_0p3_width_0_nu_0"},
    {"edge_constant_strip", 5e-15, "c_0p5_offset_m1_width_0p001_nu_0"},
};

INSTANTIATE_TEST_SUITE_P(Digits, InfluenceDigits, testing::ValuesIn(cases(influences)), case_name);
INSTANTIATE_TEST_SUITE_P(Digits, InfluenceDifferenceDigits, testing::ValuesIn(cases(differences)),
                         case_name);

}  // namespace microslip::influence_test
