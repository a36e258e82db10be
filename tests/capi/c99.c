/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The header as C99 sees it, with all warnings, and a use of it. */
#include "c99.h"

#include <microslip.h>

double force_after_a_step_in_c99(void) {
  const struct microslip_material material = {1, 0.28};
  const struct microslip_contact contact = {1, 1, NULL, NULL, 0};
  const struct microslip_kernel kernel = {MICROSLIP_STRIP, 4};
  const struct microslip_grid grid = {20, MICROSLIP_MATERIAL};
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
