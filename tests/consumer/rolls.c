/* SPDX-License-Identifier: GPL-3.0-or-later */
#include <microslip.h>
#include <stdio.h>

int main(void) {
  const struct microslip_material steel = {82000, 0.28};
  const struct microslip_contact contact = {5, 300, NULL, NULL, 0};
  const struct microslip_kernel strip = {MICROSLIP_STRIP, 10};
  const struct microslip_grid grid = {100, MICROSLIP_REMEMBERED};
  char message[256];
  microslip_rolling* rolling;
  if (microslip_create(&steel, &contact, &strip, &grid, &rolling, message, sizeof message)) {
    fprintf(stderr, "%s\n", message);
    return 1;
  }
  struct microslip_state state;
  microslip_set_creepage(rolling, 0.002);
  if (microslip_advance(rolling, 0.37) || microslip_get_state(rolling, &state)) {
    fprintf(stderr, "%s\n", microslip_message(rolling));
    return 1;
  }
  printf("%.17g\n", state.force);
  microslip_destroy(rolling);
  return 0;
}
