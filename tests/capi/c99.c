/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The header as C99 sees it, with all warnings, and a use of it. */
#include "c99.h"

#include <microslip.h>
#include <microslip_ellipse.h>

double force_after_a_step_in_c99(void) {
  const struct microslip_material material = {1, 0.28};
  const struct microslip_contact contact = {1, 1, NULL, NULL, 0};
  const struct microslip_kernel kernel = {MICROSLIP_STRIP, 4};
  const struct microslip_grid grid = {20, MICROSLIP_REMEMBERED};
  microslip_rolling* rolling;
  struct microslip_state state = {0};
  if (microslip_create(&material, &contact, &kernel, &grid, &rolling, NULL, 0)) return 0;
  if (microslip_set_creepage(rolling, 0.5) == MICROSLIP_OK &&
      microslip_advance(rolling, 0.07) == MICROSLIP_OK) {
    microslip_get_state(rolling, &state);
  }
  microslip_destroy(rolling);
  return state.force;
}

double force_after_steps_in_c99(void) {
  const struct microslip_material material = {1, 0.28};
  const struct microslip_contact contact = {1, 1, NULL, NULL, 0};
  const struct microslip_kernel kernel = {MICROSLIP_STRIP, 4};
  const struct microslip_grid grid = {20, MICROSLIP_REMEMBERED};
  const double dq[] = {0.07, 0.01, 0.2}, creepage[] = {0.5, 0.5, 0.5};
  const struct microslip_steps steps = {3, dq, creepage, NULL, NULL, NULL};
  microslip_rolling* rolling;
  struct microslip_state states[3] = {{0}};
  if (microslip_create(&material, &contact, &kernel, &grid, &rolling, NULL, 0)) return 0;
  microslip_roll(rolling, &steps, states);
  microslip_destroy(rolling);
  return states[2].force;
}

double steady_force_in_c99(double creepage) {
  const struct microslip_material material = {1, 0.28};
  const struct microslip_contact contact = {1, 1, NULL, NULL, 0};
  const struct microslip_kernel kernel = {MICROSLIP_PLANE, 20};
  struct microslip_steady state;
  if (microslip_solve_steady(&material, &contact, &kernel, 20, MICROSLIP_CREEPAGE, &creepage, 1,
                             &state, NULL, NULL, 0))
    return 0;
  return state.force;
}

double loss_of_a_cycle_in_c99(int scheme, int elements, double force, int n, double* shift) {
  const struct microslip_material material = {1, 0.28};
  const struct microslip_contact contact = {1, 1, NULL, NULL, 0};
  const struct microslip_kernel kernel = {MICROSLIP_PLANE, 20};
  struct microslip_grid grid;
  microslip_rolling* rolling;
  struct microslip_shift part;
  double loss = 0;
  int i;
  grid.elements = elements;
  grid.scheme = scheme;
  if (microslip_create(&material, &contact, &kernel, &grid, &rolling, NULL, 0)) return -1;
  for (i = 0; i <= n && loss >= 0; ++i) {
    if (microslip_shift_to_force(rolling, force * (1 - 2.0 * i / n), &part)) loss = -1;
    shift[i] = part.distance + (i > 0 ? shift[i - 1] : 0);
    if (i > 0 && loss >= 0) loss += part.dissipation;
  }
  if (loss >= 0 && microslip_shift_to_force(rolling, force, &part) == MICROSLIP_OK) {
    loss += part.dissipation;
  }
  microslip_destroy(rolling);
  return loss;
}

double lateral_force_of_spin_in_c99(double spin) {
  const struct microslip_material steel = {82000, 0.28};
  const struct microslip_ellipse_contact contact = {6, 4, 300};
  const struct microslip_ellipse_load load = {
      {MICROSLIP_MOTION, MICROSLIP_MOTION, MICROSLIP_MOTION}, {0, 0, spin}};
  struct microslip_ellipse_state state = {0};
  microslip_ellipse* ellipse;
  if (microslip_ellipse_create(&steel, &contact, NULL, &ellipse, NULL, 0)) return 0;
  microslip_ellipse_solve_steady(ellipse, &load, &state, NULL);
  microslip_ellipse_destroy(ellipse);
  return state.resultants[1];
}
