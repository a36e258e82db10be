/* SPDX-License-Identifier: GPL-3.0-or-later */
/** \file
 * microslip in C: friction that falls with the speed of slip, of line contacts and of ellipses.
 *
 * Statuses, messages and threads are those of microslip.h. */
#ifndef MICROSLIP_FRICTION_H
#define MICROSLIP_FRICTION_H

#include "microslip.h"
#include "microslip_ellipse.h"

#ifdef __cplusplus
extern "C" {
#endif

/** How friction falls with the speed of slip s, over that at rest. With k the kinetic ratio and h the
 * half speed it is k + (1 - k) f, with f as below. */
enum microslip_friction_form {
  MICROSLIP_LINEAR_FALL = 0,      /**< 1 - s/(2 h), from s = 2 h on 0 */
  MICROSLIP_EXPONENTIAL_FALL = 1, /**< 2^(-s/h) */
  MICROSLIP_RATIONAL_FALL = 2     /**< 1/(1 + s/h) */
};

/** Which one is taken of several solutions. */
enum microslip_slip_branch {
  MICROSLIP_LEAST_SLIP = 0, /**< the one that is found from bodies that stick */
  MICROSLIP_MOST_SLIP = 1   /**< the one that is found from bodies that slide fast */
};

/** Friction that falls with slip, from the bound of the contact at rest on. Without a memory a short
 * step has two solutions, and results depend on the step. With a memory of length d the ratio of a
 * point of the material follows the law as the point slips, but for 1/e over the length d. A memory of
 * d = 2 (1 - k) a g/G, with the half-width a, the peak g of the bound at rest and the shear modulus G,
 * is enough for one solution in each step; a much shorter one is not better than none. Steps take some
 * ten to twenty times as long as with constant friction, longer with a shorter memory. */
struct microslip_friction {
  int form;             /**< of microslip_friction_form */
  double kinetic_ratio; /**< k, friction at a high speed over that at rest, 0 ... 1  [1] */
  double half_speed;    /**< h, at which half of the fall is done, > 0  [mm/s] */
  double speed;         /**< V of rolling, > 0  [mm/s] */
  double memory_length; /**< d; 0 for none  [mm] */
  double memory_speed;  /**< least speed with which the length is used up, >= 0  [mm/s] */
  int branch;           /**< of microslip_slip_branch */
};

/** Lets friction fall with slip. The contact begins anew, without tractions, in the contact with
 * which it was created. Bodies of different material have no such friction; with MICROSLIP_DIRECT it
 * has no memory. Such bodies do not roll back, are not shifted after they rolled, and neither their
 * steps nor their steady solutions have derivatives. */
MICROSLIP_API enum microslip_status microslip_set_friction(
    microslip_rolling* rolling, const struct microslip_friction* friction);

/** Sets the speed of the next steps, > 0  [mm/s]. It has a part in friction that falls with slip, and
 * in nothing else. */
MICROSLIP_API enum microslip_status microslip_set_speed(microslip_rolling* rolling, double speed);

/** Returns 1 if the last step has a second solution, with other slip, and 0 otherwise. */
MICROSLIP_API int microslip_has_second_solution(const microslip_rolling* rolling);

/** The same of an ellipse, for steady rolling, too. */
MICROSLIP_API enum microslip_status microslip_ellipse_set_friction(
    microslip_ellipse* ellipse, const struct microslip_friction* friction);

/** Sets the speed of the next steps and solutions, > 0  [mm/s]. */
MICROSLIP_API enum microslip_status microslip_ellipse_set_speed(microslip_ellipse* ellipse,
                                                                double speed);

/** Returns 1 if the last step, or the last steady solution if that came later, has a second one. */
MICROSLIP_API int microslip_ellipse_has_second_solution(const microslip_ellipse* ellipse);

#ifdef __cplusplus
}
#endif

#endif
