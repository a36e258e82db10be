/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Creep forces of a wheel on a rail, from a table: a curve over the creepage, with spin, in one call.
 *
 *   cc creep_forces.c $(pkg-config --cflags --libs microslip) -o creep_forces
 *   ./creep_forces /usr/share/microslip/creep_forces.nc >creep_forces.tsv */
#include <microslip_creep_table.h>
#include <stdio.h>
#include <string.h>

enum { POINTS = 41 };

static const struct microslip_material steel = {82000, 0.28};
static const struct microslip_bodies bodies = {80000, 460, 0, 0, 300, 0.3};
static const double largest = 5e-3; /* creepage  [1] */
static const double spin = 2e-4;    /* [1/mm] */

static int failed(enum microslip_status status, const char* message) {
  if (status != MICROSLIP_OK) fprintf(stderr, "creep_forces: %s\n", message);
  return status != MICROSLIP_OK;
}

int main(int count, char** arguments) {
  struct microslip_ellipse_contact contacts[POINTS];
  double motions[POINTS][3], forces[POINTS][3], jacobians[POINTS][3][3];
  char message[256];
  microslip_creep_table* table;
  if (count != 2 || strcmp(arguments[1], "--help") == 0) {
    fprintf(count == 2 ? stdout : stderr, "usage: creep_forces TABLE\n");
    return count == 2 ? MICROSLIP_OK : MICROSLIP_BAD_INPUT;
  }
  if (failed(microslip_creep_table_open(arguments[1], &table, message, sizeof message), message) ||
      failed(microslip_hertz_ellipse(&steel, &bodies, contacts, message, sizeof message),
             message)) {
    return MICROSLIP_BAD_INPUT;
  }
  for (int k = 0; k < POINTS; ++k) {
    contacts[k] = contacts[0];
    motions[k][0] = largest * k / (POINTS - 1);
    motions[k][1] = 0;
    motions[k][2] = spin;
  }
  if (failed(microslip_creep_table_forces_many(table, &steel, contacts, motions[0], POINTS,
                                               forces[0], jacobians[0][0], message, sizeof message),
             message)) {
    return MICROSLIP_BAD_INPUT;
  }
  microslip_creep_table_close(table);
  printf("# forces of a wheel over the creepage, with a spin of %g 1/mm\n", spin);
  printf("creepage\tforce\tlateral_force\tspin_moment\tslope\n");
  for (int k = 0; k < POINTS; ++k) {
    printf("%g\t%.6g\t%.6g\t%.6g\t%.6g\n", motions[k][0], forces[k][0], forces[k][1], forces[k][2],
           jacobians[k][0][0]);
  }
  return 0;
}
