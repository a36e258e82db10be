// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "microslip.h"

namespace microslip {

using Handle = std::unique_ptr<microslip_rolling, void (*)(microslip_rolling*)>;

/// The arguments of microslip_create(), for an ordinary case.
struct Parts {
  microslip_material material{1, 0.28};
  microslip_contact contact{1, 1, nullptr, nullptr, 0};
  microslip_kernel kernel{MICROSLIP_PLANE, 200};
  microslip_grid grid{41, MICROSLIP_REMEMBERED};
};

/// \param message  out, may be null
inline microslip_status create(const Parts& parts, Handle& handle, std::string* message = nullptr) {
  microslip_rolling* made = nullptr;
  char text[512] = "";
  const microslip_status status = microslip_create(&parts.material, &parts.contact, &parts.kernel,
                                                   &parts.grid, &made, text, sizeof text);
  handle.reset(made);
  if (message != nullptr) *message = text;
  return status;
}

inline Handle created(const Parts& parts = {}) {
  Handle handle(nullptr, microslip_destroy);
  std::string message;
  EXPECT_EQ(create(parts, handle, &message), MICROSLIP_OK) << message;
  return handle;
}

inline microslip_state state_of(const Handle& handle) {
  microslip_state state{};
  EXPECT_EQ(microslip_get_state(handle.get(), &state), MICROSLIP_OK);
  return state;
}

/// The numbers of a state, in the order of the struct.
inline std::vector<double> numbers(const microslip_state& s) {
  return {s.distance,
          s.force,
          s.mean_force,
          s.creepage,
          s.dissipation,
          s.residual,
          s.violation,
          static_cast<double>(s.adhesion_elements),
          static_cast<double>(s.slip_elements),
          static_cast<double>(s.iterations)};
}

/// All that a handle answers.
inline std::vector<double> answers(const Handle& handle) {
  std::vector<double> all = numbers(state_of(handle));
  double number = 0;
  EXPECT_EQ(microslip_get_elastic_energy(handle.get(), &number), MICROSLIP_OK);
  all.push_back(number);
  std::vector<double> values(microslip_size(handle.get()));
  for (const auto get : {microslip_get_nodes, microslip_get_traction, microslip_get_bound,
                         microslip_get_slip, microslip_get_displacement}) {
    EXPECT_EQ(get(handle.get(), values.data(), values.size()), MICROSLIP_OK);
    all.insert(all.end(), values.begin(), values.end());
  }
  std::vector<int> zones(values.size());
  EXPECT_EQ(microslip_get_zones(handle.get(), zones.data(), zones.size()), MICROSLIP_OK);
  all.insert(all.end(), zones.begin(), zones.end());
  return all;
}

/// Expects the same bits; a nan is the same as another.
inline void expect_same(const std::vector<double>& a, const std::vector<double>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_TRUE(a[i] == b[i] || (std::isnan(a[i]) && std::isnan(b[i])))
        << "number " << i << ": " << a[i] << " and " << b[i];
  }
}

/// Steps of many lengths, from next to nothing to more than an element, and loads that turn.
inline void roll(const Handle& handle, int steps, double spacing) {
  for (int k = 0; k < steps; ++k) {
    ASSERT_EQ(microslip_set_creepage(handle.get(), std::sin(0.3 * k)), MICROSLIP_OK);
    const double dq = spacing * std::exp(4 * std::sin(1.7 * k) - 3);
    ASSERT_EQ(microslip_advance(handle.get(), dq), MICROSLIP_OK) << microslip_message(handle.get());
  }
}

}  // namespace microslip
