/* SPDX-License-Identifier: GPL-3.0-or-later */
/** \file
 * microslip in C: creep forces of contact ellipses from a table, in about a microsecond.
 *
 * A table is a file that `microslip table` makes, or that of the installation,
 * PREFIX/share/microslip/creep_forces.nc. It has the measured errors of its forces. Units, motions and
 * signs are those of microslip_ellipse.h; statuses and messages are those of microslip.h. Any number of
 * threads may use one table at the same time. */
#ifndef MICROSLIP_CREEP_TABLE_H
#define MICROSLIP_CREEP_TABLE_H

#include "microslip_ellipse.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A table in memory, which never changes. */
typedef struct microslip_creep_table microslip_creep_table;

/** Ranges of a table, and its errors against solutions on more cells in random states: Fx and Fy over
 * friction times load, and Mz over that times (a b)^(1/2). */
struct microslip_creep_table_info {
  double poisson_ratio;          /**< nu of the combined bodies  [1] */
  double least_ratio;            /**< a/b  [1] */
  double largest_ratio;          /**< [1] */
  int states;                    /**< that were solved; 0 if no errors were measured */
  double error_rms[3];           /**< [1] */
  double error_of_99_percent[3]; /**< not exceeded by 99 of 100 states  [1] */
  double error_largest[3];       /**< [1] */
};

/** Reads a table.
 *
 * path     of the file
 * table    out; null if it fails
 * message  out, may be null, like that of microslip_create() */
MICROSLIP_API enum microslip_status microslip_creep_table_open(const char* path,
                                                               microslip_creep_table** table,
                                                               char* message, size_t message_size);

/** Frees a table; null is accepted. */
MICROSLIP_API void microslip_creep_table_close(microslip_creep_table* table);

/** Gives ranges and errors.
 *
 * info  out */
MICROSLIP_API enum microslip_status microslip_creep_table_get_info(
    const microslip_creep_table* table, struct microslip_creep_table_info* info, char* message,
    size_t message_size);

/** Gives forces and moment of steady rolling. They are exact at rest and in their slopes
 * there. The jacobian is continuous.
 *
 * material    with the Poisson ratio of the table
 * contact     with a/b in the range of the table
 * motion      xi, eta [1] and phi [1/mm]
 * resultants  out: Fx, Fy [N], Mz [N mm]
 * jacobian    out, may be null: the derivatives of the resultants by the motion, 3 x 3, row by row
 * message     out, may be null. If there are forces, it is empty, or "warning: " and why the motion or
 *             the units are doubtful, as microslip_ellipse_warning() has it */
MICROSLIP_API enum microslip_status microslip_creep_table_forces(
    const microslip_creep_table* table, const struct microslip_material* material,
    const struct microslip_ellipse_contact* contact, const double motion[3], double resultants[3],
    double* jacobian, char* message, size_t message_size);

/** Gives the same for many contacts in one call, as microslip_creep_table_forces() one by one, to the
 * bit. The message of an error names the contact, from 0: "contacts[17]: ratio = 12.5: ...". The
 * results of the contacts before it are written.
 *
 * material    of all contacts
 * contacts    `count` of them
 * motions     xi, eta [1] and phi [1/mm] of each, `count` x 3
 * resultants  out: Fx, Fy [N], Mz [N mm] of each, `count` x 3
 * jacobians   out, may be null: `count` x 3 x 3
 * message     out, may be null; a warning is that of the first doubtful contact */
MICROSLIP_API enum microslip_status microslip_creep_table_forces_many(
    const microslip_creep_table* table, const struct microslip_material* material,
    const struct microslip_ellipse_contact* contacts, const double* motions, size_t count,
    double* resultants, double* jacobians, char* message, size_t message_size);

#ifdef __cplusplus
}
#endif

#endif
