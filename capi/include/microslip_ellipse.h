/* SPDX-License-Identifier: GPL-3.0-or-later */
/** \file
 * microslip in C: contact ellipses with creepages along and across and spin, steady and in steps of
 * any length, for multibody codes.
 *
 * Units are mm and N; forces of an ellipse are in N, moments in N mm, spin in 1/mm. Rolling is towards
 * +x. With the motion (xi, eta, phi) the rigid slip is (xi - phi y, eta + phi x); a positive xi
 * gives Fx < 0. Forces and the moment about the centre act on the body whose surface has this
 * slip.
 *
 * Statuses, messages and threads are those of microslip.h: a call that fails changes nothing, and
 * says why in one line; calls with different handles run side by side, calls with one handle take
 * turns. */
#ifndef MICROSLIP_ELLIPSE_H
#define MICROSLIP_ELLIPSE_H

#include "microslip.h"

#ifdef __cplusplus
extern "C" {
#endif

/** An ellipse with Hertz's bound. */
struct microslip_ellipse_contact {
  double half_width;         /**< a, along the rolling, > 0  [mm] */
  double lateral_half_width; /**< b, from a/10 to 1000 a  [mm] */
  double peak_traction;      /**< friction coefficient times peak pressure, > 0  [N/mm^2] */
};

/** Two bodies that touch in a point. A radius is negative for a concave body, and 0 for a flat
 * one. */
struct microslip_bodies {
  double normal_load;      /**< > 0  [N] */
  double radius_1;         /**< of the one body in the plane of rolling  [mm] */
  double radius_2;         /**< of the other one in the same plane  [mm] */
  double lateral_radius_1; /**< across the rolling  [mm] */
  double lateral_radius_2; /**< [mm] */
  double friction;         /**< mu, above 0, at most 10  [1] */
};

/** Rows across the ellipse, 1 ... 100, and elements of each, 2 ... 100. Both 0: as many as fit the
 * shape, 16 by 16 on a circle. */
struct microslip_ellipse_grid {
  int rows;
  int elements;
};

enum microslip_prescribed {
  MICROSLIP_MOTION = 0,   /**< xi, eta [1] or phi [1/mm]; the resultant follows */
  MICROSLIP_RESULTANT = 1 /**< Fx, Fy [N] or Mz [N mm]; the motion follows */
};

/** Along the rolling, across it, and about the normal. */
struct microslip_ellipse_load {
  int prescribed[3]; /**< of microslip_prescribed */
  double value[3];
};

/** A state of steady rolling, or after a step. */
struct microslip_ellipse_state {
  double distance;      /**< rolled so far; 0 in steady rolling  [mm] */
  double resultants[3]; /**< Fx, Fy [N], Mz [N mm], at the end of a step */
  double motion[3];    /**< xi, eta [1], phi [1/mm], means over a step; of a shift in [mm], [rad] */
  double dissipation;  /**< energy lost per mm rolled [N]; of a shift the energy [N mm] */
  double full_sliding; /**< the largest force  [N] */
  double slip_share;   /**< of the area  [1] */
  double residual;     /**< largest error of the slip conditions, over the bound  [1] */
  int iterations;      /**< systems that were solved */
};

/** A contact ellipse. */
typedef struct microslip_ellipse microslip_ellipse;

/** Gives the ellipse of two bodies by Hertz's theory.
 *
 * material  combined constants
 * contact   out
 * message   out, may be null, like that of microslip_create() */
MICROSLIP_API enum microslip_status microslip_hertz_ellipse(
    const struct microslip_material* material, const struct microslip_bodies* bodies,
    struct microslip_ellipse_contact* contact, char* message, size_t message_size);

/** Makes an ellipse without tractions that has not rolled.
 *
 * grid     may be null: the grid that fits
 * ellipse  out; null if it fails
 * message  out, may be null */
MICROSLIP_API enum microslip_status microslip_ellipse_create(
    const struct microslip_material* material, const struct microslip_ellipse_contact* contact,
    const struct microslip_ellipse_grid* grid, microslip_ellipse** ellipse, char* message,
    size_t message_size);

/** Makes an independent ellipse that goes on like this one, to the bit; matrices are shared. */
MICROSLIP_API enum microslip_status microslip_ellipse_copy(microslip_ellipse* ellipse,
                                                           microslip_ellipse** copy);

/** Makes an ellipse go on like another one, to the bit, which may have another contact, material and
 * grid: microslip_ellipse_size() then changes with it. Nothing is allocated if one is a copy of the
 * other and both have rolled. */
MICROSLIP_API enum microslip_status microslip_ellipse_assign(microslip_ellipse* ellipse,
                                                             microslip_ellipse* from);

/** Frees an ellipse; null is accepted. */
MICROSLIP_API void microslip_ellipse_destroy(microslip_ellipse* ellipse);

/** Returns the message of the last call that failed, or an empty text. */
MICROSLIP_API const char* microslip_ellipse_message(microslip_ellipse* ellipse);

/** Returns in one line why a motion that the last steady solution, step or attempt prescribed is
 * doubtful: creepages, or the slip by spin, are above 0.2 in size, while 0.2 % is 0.002 and 0.2 1/m is
 * 2e-4. Else it is why the units of microslip_ellipse_create() are doubtful: the shear modulus is above
 * that of any solid, or strains are above 0.05. The text is empty if there is no doubt, and valid
 * until the next call. */
MICROSLIP_API const char* microslip_ellipse_warning(const microslip_ellipse* ellipse);

/** Sets the contact of the next solutions, and at the end of the next step, on the way to which it
 * changes linearly; it stays so until it is set again. Under another normal load P both factors are
 * (P/P0)^(1/3) by Hertz's theory; another friction coefficient changes the bound alone.
 *
 * size_factor   of both half-widths over those of the creation, 1e-4 ... 100  [1]
 * bound_factor  of the bound, 1e-6 ... 1e6  [1]
 *
 * 0 of one or both: the contact is lost at the end of the next step or shift. It has no tractions
 * then, resultants must be 0, and the bodies forget. A contact that returns begins at the start of
 * its step, or at the end of its shift; its forces then depend on the steps over which it grows, by
 * some percent of full sliding under spin. A shift takes no other size, but to and from 0. Steady
 * rolling takes no 0. */
MICROSLIP_API enum microslip_status microslip_ellipse_set_contact(microslip_ellipse* ellipse,
                                                                  double size_factor,
                                                                  double bound_factor);

/** Solves steady rolling in the contact that is set, from the last steady solution on. What has been
 * rolled has no part in it, and stays. The first call prepares matrices, which takes as long as
 * microslip_ellipse_create().
 *
 * state     out
 * jacobian  out, may be null: the derivatives of the resultants by the motion, 3 x 3, row by row */
MICROSLIP_API enum microslip_status microslip_ellipse_solve_steady(
    microslip_ellipse* ellipse, const struct microslip_ellipse_load* load,
    struct microslip_ellipse_state* state, double* jacobian);

/** Rolls on by dq, from 1e-6 to 1e6 of the ellipse's size, or back by as much below 0  [mm]; then
 * motions are shifts over dq, as in microslip_advance(). A step of another length than
 * the last one, or that changes the size of the contact, takes new matrices. A step in which stick
 * and slip are not found is divided.
 *
 * state  out, may be null */
MICROSLIP_API enum microslip_status microslip_ellipse_advance(
    microslip_ellipse* ellipse, double dq, const struct microslip_ellipse_load* load,
    struct microslip_ellipse_state* state);

/** Gives the state to which a step would lead, and leaves the ellipse as it is. If
 * microslip_ellipse_advance() makes the same step next, the step costs nothing.
 *
 * jacobian  out, may be null: the derivatives of the resultants at the end by the motion of the step;
 *           of a divided step those of its last part */
MICROSLIP_API enum microslip_status microslip_ellipse_attempt(
    microslip_ellipse* ellipse, double dq, const struct microslip_ellipse_load* load,
    struct microslip_ellipse_state* state, double* jacobian);

/** Shifts the bodies without rolling, by shifts [mm] and a rotation [rad] in the place of motions, or
 * to resultants.
 *
 * state  out, may be null */
MICROSLIP_API enum microslip_status microslip_ellipse_shift(
    microslip_ellipse* ellipse, const struct microslip_ellipse_load* load,
    struct microslip_ellipse_state* state);

/** Rolls many different ellipses, each over its own step, on several threads. A failure of one does
 * not keep the others from rolling; its own message says why. If the arguments are refused, none rolls,
 * and the message is that of the first ellipse.
 *
 * ellipses  `count` handles, no two alike
 * dq        `count` of them  [mm]
 * loads     `count` of them
 * states    out, `count` of them; may be null
 * threads   1 ... 1000
 *
 * Returns the status of the first one that failed. */
MICROSLIP_API enum microslip_status microslip_ellipse_advance_all(
    microslip_ellipse* const* ellipses, size_t count, const double* dq,
    const struct microslip_ellipse_load* loads, struct microslip_ellipse_state* states,
    int threads);

/** Gives the state after the last step; one that has not rolled carries nothing. */
MICROSLIP_API enum microslip_status microslip_ellipse_get_state(
    microslip_ellipse* ellipse, struct microslip_ellipse_state* state);

/** Returns the number of elements, rows times elements of each; 0 if the handle is null. */
MICROSLIP_API size_t microslip_ellipse_size(const microslip_ellipse* ellipse);

/** Arrays with room for microslip_ellipse_size() numbers; each may be null. Elements are in rows, from
 * the row of the least y on, each from the leading edge on. Tractions are those at the centres, and
 * resultants are integrals over all places between them: the sum of tractions times areas differs from
 * them by some 2 % on 5 x 6 elements, and by 0.6 % on 10 x 12. */
struct microslip_ellipse_cells {
  double* x;          /**< of the centres  [mm] */
  double* y;          /**< [mm] */
  double* area;       /**< [mm^2] */
  double* bound;      /**< at the centres  [N/mm^2] */
  double* traction_x; /**< [N/mm^2] */
  double* traction_y; /**< [N/mm^2] */
  double* slip_x;     /**< relative slip, 0 where an element sticks [1]; of a shift [mm] */
  double* slip_y;     /**< the same across */
  int* slips;         /**< whether an element slips, 0 or 1 */
};

/** Writes values after the last step into arrays. */
MICROSLIP_API enum microslip_status microslip_ellipse_get_cells(
    microslip_ellipse* ellipse, const struct microslip_ellipse_cells* cells);

/** Gives the energy stored in the bodies, half of the integral of tractions times displacements
 * [N mm] */
MICROSLIP_API enum microslip_status microslip_ellipse_get_elastic_energy(microslip_ellipse* ellipse,
                                                                         double* energy);

/** Writes the state of what has been rolled to a file, as microslip_save() does, or takes it from
 * one. The ellipse that restores it must have the same material, contact and grid. The contact that
 * is set is a part of the state. */
MICROSLIP_API enum microslip_status microslip_ellipse_save(microslip_ellipse* ellipse,
                                                           const char* path);
MICROSLIP_API enum microslip_status microslip_ellipse_restore(microslip_ellipse* ellipse,
                                                              const char* path);

/** Writes the same state into memory, or takes it from there.
 *
 * text    of at least the size that is needed, with a closing 0; null to ask for the size
 * size    of the room for the text
 * needed  out, may be null: the size of the text with its closing 0 */
MICROSLIP_API enum microslip_status microslip_ellipse_save_to_memory(microslip_ellipse* ellipse,
                                                                     char* text, size_t size,
                                                                     size_t* needed);
MICROSLIP_API enum microslip_status microslip_ellipse_restore_from_memory(
    microslip_ellipse* ellipse, const char* text);

#ifdef __cplusplus
}
#endif

#endif
