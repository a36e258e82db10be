/* SPDX-License-Identifier: GPL-3.0-or-later */
/** \file
 * microslip in C: 2D tractive rolling contact, in steps of any length, for multibody codes.
 *
 * Units are mm and N, per mm of width, so forces are in N/mm. Rolling is towards +x: the leading
 * edge is x = +a. Tractions and forces act on the body that the creepage drives: a positive
 * creepage w = (v - omega R)/v gives negative tractions and a negative force, which acts on v.
 *
 * Functions return a status. A function that fails changes nothing and gives the reason in one
 * line: microslip_message(), or the text given to microslip_create(). Only a step that runs out of
 * memory loses its contact. No C++ exception leaves the library. Numbers must be finite; a null
 * pointer is a bad input where its description does not allow it.
 *
 * Threads: all functions may be called by several threads at once. Calls with different handles,
 * and calls without a handle, run side by side. Calls with one handle take turns, in any order: each
 * is made as a whole. Two calls that belong together, such as microslip_set_force() and
 * microslip_advance(), or a call and the text of its microslip_message(), need a lock of the
 * caller's if another thread uses the same handle. No other call with a handle may be under way
 * when microslip_destroy() frees it. If several threads save to one file, the file of one of them
 * remains. FFTW, which the library uses, makes plans in one thread at a time: the library takes care
 * of its own plans. A program that makes plans elsewhere at the same time must call
 * fftw_make_planner_thread_safe(). */
#ifndef MICROSLIP_H
#define MICROSLIP_H

#include <stddef.h>

#ifndef MICROSLIP_API
#define MICROSLIP_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

enum microslip_status {
  MICROSLIP_OK = 0,
  MICROSLIP_BAD_INPUT = 1,   /**< the message names the input, its value, and the accepted values */
  MICROSLIP_NO_SOLUTION = 2, /**< the solver found no solution */
  MICROSLIP_OUT_OF_MEMORY = 3, /**< in a step: the handle answers this from then on, destroy it */
  MICROSLIP_INTERNAL = 4       /**< an error of microslip itself: please report the message */
};

/** The combined elastic constants of two bodies: 1/G and nu/G are means over both bodies. */
struct microslip_material {
  double shear_modulus; /**< G, > 0  [N/mm^2] */
  double poisson_ratio; /**< nu, 0 ... 0.5  [1] */
};

/** The contact goes from -a to a. The bound of its tractions is Hertzian, or linear between the
 * rows of a table, and from the outermost rows to zero at -+a. */
struct microslip_contact {
  double half_width;         /**< a, > 0  [mm] */
  double peak_traction;      /**< friction coefficient times peak pressure, > 0; for Hertz's bound
                                only  [N/mm^2] */
  const double* bound_x;     /**< positions, ascending, in [-a, a]; null for Hertz's  [mm] */
  const double* bound_value; /**< as many, >= 0, not all 0; null for Hertz's  [N/mm^2] */
  size_t bound_rows;         /**< of the table, copied; 0 for Hertz's */
};

/** Bodies of different material roll by Goodman's approximation, in plane strain. The pressure
 * stretches the softer surface more, so that the bodies creep and slip in free rolling, too. */
struct microslip_unlike {
  double
      dundurs_beta; /**< Dundurs' beta, -0.5 ... 0.5; above 0 if the driven body is the stiffer one;
                          0 for like bodies  [1] */
  double friction;  /**< coefficient of friction mu of the bound, above 0, at most 10  [1] */
};

enum microslip_kernel_type {
  MICROSLIP_STRIP = 0, /**< half-space loaded over a strip, observed in its middle */
  MICROSLIP_PLANE = 1, /**< plane strain */
  /** The same with creepages, tractions and forces across the rolling: the bodies yield more, in
   * plane strain by 1/(1 - nu). Bodies of different material have none of these. */
  MICROSLIP_STRIP_LATERAL = 2,
  MICROSLIP_PLANE_LATERAL = 3
};

/** How the bodies yield. Under a prescribed creepage the length matters: it sets the stiffness of
 * the contact. */
struct microslip_kernel {
  int type;      /**< of microslip_kernel_type */
  double length; /**< the strip's width, > 0, or the distance at which the displacement of plane
                    strain counts as zero, > (a + dx)/2: with less, it yields against its load
                    [mm] */
};

enum microslip_scheme {
  MICROSLIP_REMEMBERED = 0, /**< the material remembers its displacement: right for any dq, second
                               order, balances energy */
  MICROSLIP_DIRECT = 1      /**< as in CONTACT: wiggles where dq is not about an element */
};

struct microslip_grid {
  int elements; /**< N elements fill the contact, 1 ... 4 000 000; of MICROSLIP_REMEMBERED 4 on */
  int scheme;   /**< of microslip_scheme */
};

/** The state of a contact after a step. Values that belong to a step are 0 before the first one. */
struct microslip_state {
  double distance;    /**< q rolled so far  [mm] */
  double force;       /**< F, integral of the tractions  [N/mm] */
  double mean_force;  /**< its mean over the step  [N/mm] */
  double creepage;    /**< w of the step  [1] */
  double dissipation; /**< energy lost per mm rolled, over the step. Under a prescribed creepage,
                         dissipation |dq| + mean_force w |dq| + the change of the elastic energy is
                         0: to rounding with MICROSLIP_REMEMBERED, but in a step that turns, where it
                         is of the order of the scheme, as always with MICROSLIP_DIRECT  [N/mm] */
  double residual;    /**< slip left in adhesion, over the largest term of its equations  [1] */
  double violation;   /**< of the bound or of the direction of slip, relative  [1] */
  int adhesion_elements;
  int slip_elements;
  int iterations; /**< stick/slip partitions tried */
};

/** Derivatives of the results of a step by one of its inputs. The unit is the result's over the
 * input's. */
struct microslip_slopes {
  double force;
  double mean_force;
  double creepage;
  double dissipation;
};

/** Derivatives of a step are exact for the step as it is made: its stick/slip partition stays, and
 * the stick-slip point moves. Where the partition changes, they hold on one side. */
struct microslip_jacobian {
  struct microslip_slopes by_load;   /**< by the creepage or the force that is set */
  struct microslip_slopes by_length; /**< by dq at that creepage or force; not a number where the
                                        step changes the contact  [1/mm] */
};

/** A shift moves the bodies without rolling; energies are per mm of width. A shift that is made in
 * parts has the same sum of energies, to rounding with MICROSLIP_DIRECT, and with
 * MICROSLIP_REMEMBERED to 6e-3 of the work at N = 41. */
struct microslip_shift {
  double distance;    /**< rigid shift; a positive one gives negative tractions  [mm] */
  double force;       /**< F at its end  [N/mm] */
  double dissipation; /**< energy lost where the bodies slip  [N] */
  double work;        /**< of the force: dissipation plus the change of the elastic energy  [N] */
};

/** A contact that rolls. */
typedef struct microslip_rolling microslip_rolling;

MICROSLIP_API const char* microslip_version(void);

/** Makes a contact without tractions that has not rolled.
 *
 * rolling       out; null if it fails
 * message       out, may be null: why it failed, cut to message_size bytes with the closing 0 */
MICROSLIP_API enum microslip_status microslip_create(const struct microslip_material* material,
                                                     const struct microslip_contact* contact,
                                                     const struct microslip_kernel* kernel,
                                                     const struct microslip_grid* grid,
                                                     microslip_rolling** rolling, char* message,
                                                     size_t message_size);

/** Makes a contact of bodies of different material, with their combined constants. The bodies are
 * pressed together without tractions. microslip_set_contact() accepts only 1 and 1 then. */
MICROSLIP_API enum microslip_status microslip_create_unlike(
    const struct microslip_material* material, const struct microslip_unlike* unlike,
    const struct microslip_contact* contact, const struct microslip_kernel* kernel,
    const struct microslip_grid* grid, microslip_rolling** rolling, char* message,
    size_t message_size);

/** Makes an independent contact that goes on like this one, to the bit. A caller comes back to it
 * after steps that are rejected. microslip_attempt() is cheaper where one step alone is tried. */
MICROSLIP_API enum microslip_status microslip_copy(microslip_rolling* rolling,
                                                   microslip_rolling** copy);

/** Writes the state of a contact to a file: everything on which the next calls depend, a step that
 * was attempted included, but not the load. The scheme must be MICROSLIP_REMEMBERED. The file is
 * written as a whole or not at all, and replaces a file of the same name, or the file to which a
 * link of this name leads. A device, a pipe, a socket and a folder are refused. */
MICROSLIP_API enum microslip_status microslip_save(microslip_rolling* rolling, const char* path);

/** Takes the state from a file of microslip_save() or of `microslip --save`, which must have the
 * same material, contact, kernel and grid; the load stays as it was set. On the same machine with
 * the same library the contact goes on like the saved one, to the bit. */
MICROSLIP_API enum microslip_status microslip_restore(microslip_rolling* rolling, const char* path);

/** Frees a contact; null is accepted. */
MICROSLIP_API void microslip_destroy(microslip_rolling* rolling);

/** Returns the message of the last call that failed, or an empty text; it is valid until the next
 * call. */
MICROSLIP_API const char* microslip_message(microslip_rolling* rolling);

/** Returns in one line why the last load, or a load of the last microslip_roll(), is doubtful: its
 * creepage is above 0.2 in size, while 0.2 % is 0.002. Else it is why the units of microslip_create()
 * are doubtful: the shear modulus is above that of any solid, or strains are above 0.05. The text is
 * empty if there is no doubt, and valid until the next call. */
MICROSLIP_API const char* microslip_warning(const microslip_rolling* rolling);

/** Returns the scheme of this contact as scenes name it, "remembered" or "direct", and "" for a
 * null handle. */
MICROSLIP_API const char* microslip_method(const microslip_rolling* rolling);

/** Sets the load of the next steps, until it is set again. The first step needs one of the two.
 *
 * creepage  w  [1]
 * force     F, less in absolute value than full sliding  [N/mm] */
MICROSLIP_API enum microslip_status microslip_set_creepage(microslip_rolling* rolling,
                                                           double creepage);
MICROSLIP_API enum microslip_status microslip_set_force(microslip_rolling* rolling, double force);

/** Sets the contact at the end of the next step or shift; the contact changes linearly on the way,
 * and stays so until it is set again. The factors are half-width and bound over the values with
 * which the contact was created. Under another normal load P both are sqrt(P/P0) by Hertz's
 * theory, and another friction coefficient changes the bound alone. The scheme must be
 * MICROSLIP_REMEMBERED.
 *
 * If one of them is 0, the bodies do not touch, or slide without friction: there are no tractions
 * at the end of the step, a force must be 0, and nothing is remembered. A contact that returns under
 * a creepage begins at the start of its step, without tractions, and grows on the way. Under a force
 * it begins at the end of the step, with the force. A step takes as long as the elements are many of
 * the smallest contact on its way over which it rolls: after the return of a small contact, begin
 * with short steps.
 *
 * half_width_factor  >= 0; in plane strain less than 2 L0 over the half-width  [1]
 * bound_factor       of the bound at the same place over the half-width, >= 0  [1] */
MICROSLIP_API enum microslip_status microslip_set_contact(microslip_rolling* rolling,
                                                          double half_width_factor,
                                                          double bound_factor);

/** Shifts the bodies without rolling, from no tractions, until they carry a force, which is
 * Cattaneo's problem; nothing has been rolled then. The load that is set remains.
 *
 * shift  out, may be null  [mm] */
MICROSLIP_API enum microslip_status microslip_start_from_shift(microslip_rolling* rolling,
                                                               double force, double* shift);

/** Shifts the bodies without rolling, from the present tractions, until they carry a force, or by a
 * rigid shift. A contact may roll, be shifted and roll on. Values of the state that belong to a
 * step are 0 afterwards, the distance rolled is the same, and the load that is set remains.
 *
 * force     F, less in absolute value than full sliding  [N/mm]
 * distance  finite  [mm]
 * shift     out, may be null */
MICROSLIP_API enum microslip_status microslip_shift_to_force(microslip_rolling* rolling,
                                                             double force,
                                                             struct microslip_shift* shift);
MICROSLIP_API enum microslip_status microslip_shift_by_distance(microslip_rolling* rolling,
                                                                double distance,
                                                                struct microslip_shift* shift);

/** Rolls on by dq, 0 or from 1e-15 to 1e6 elements of the larger contact of the step  [mm]. Under a
 * force, rounding is more than 1 % of the creepage below 1e-13 N elements.
 *
 * With MICROSLIP_REMEMBERED the bodies roll back by dq < 0, and turn as often as they like. The
 * frame stays: x, tractions, forces and shifts keep their directions, and the distance of the state
 * goes back. A creepage is a shift over the distance rolled, dS/dq, so that a positive one gives a
 * positive force on the way back.
 *
 * Nothing happens in a step of dq = 0: state and energies stay, and the next step is to the bit what
 * it would have been. A creepage may be set meanwhile, as it shifts nothing over no length. Another
 * force or another contact than that now is refused: microslip_shift_to_force() changes the force
 * without rolling, and microslip_shift_by_distance() by 0 the contact. */
MICROSLIP_API enum microslip_status microslip_advance(microslip_rolling* rolling, double dq);

/** The steps of one call are arrays of `count` numbers each. */
struct microslip_steps {
  size_t count;
  const double* dq;       /**< as microslip_advance() takes it  [mm] */
  const double* creepage; /**< w; null under forces, or under the load that is set  [1] */
  const double* force;    /**< F at the end; null under creepages  [N/mm] */
  /** The contact at the end of each step, as microslip_set_contact() takes it; both are null if the
   * contact stays  [1] */
  const double* half_width_factor;
  const double* bound_factor;
};

/** Makes many steps, to the bit like one by one; a step costs no more than its work. The load and
 * the contact of the last one remain set. If a step fails, no step has been made, and the message
 * names it, from 0: "steps[17]: dq = -1: ...". The states of the steps before it are written.
 *
 * states  out, `count` of them, after each step; may be null */
MICROSLIP_API enum microslip_status microslip_roll(microslip_rolling* rolling,
                                                   const struct microslip_steps* steps,
                                                   struct microslip_state* states);

/** Gives the state to which a step would lead, and leaves the contact as it is. If
 * microslip_advance() makes the same step next, the step costs nothing. */
MICROSLIP_API enum microslip_status microslip_attempt(microslip_rolling* rolling, double dq,
                                                      struct microslip_state* state);

/** Gives the same state and the derivatives of the step, by which an implicit integrator finds its
 * load with Newton's method: examples/c/wheel_drive.c. The scheme must be MICROSLIP_REMEMBERED, and
 * dq not 0. It costs two more solves than microslip_attempt() for each element that is travelled. */
MICROSLIP_API enum microslip_status microslip_attempt_with_jacobian(
    microslip_rolling* rolling, double dq, struct microslip_state* state,
    struct microslip_jacobian* jacobian);

MICROSLIP_API enum microslip_status microslip_get_state(microslip_rolling* rolling,
                                                        struct microslip_state* state);

/** Gives the energy stored in the bodies, half of p A p with the means of tractions over elements
 * [N]. It costs about as much as a step. */
MICROSLIP_API enum microslip_status microslip_get_elastic_energy(microslip_rolling* rolling,
                                                                 double* energy);

/** Gives the largest force that the bound of the contact that is set allows  [N/mm] */
MICROSLIP_API enum microslip_status microslip_get_full_sliding(microslip_rolling* rolling,
                                                               double* force);

/** Returns the number of nodes, which never changes; 0 if the handle is null or lost. */
MICROSLIP_API size_t microslip_size(microslip_rolling* rolling);

/** Writes values at the nodes into arrays with room for `length` numbers, at least
 * microslip_size().
 *
 * nodes         x in the contact's frame, ascending  [mm]
 * traction      p at the nodes; elements balance means over them, and coefficients that make up for
 *               the square root at the leading edge  [N/mm^2]
 * bound         [N/mm^2]
 * slip          relative slip s of the last step  [1]
 * displacement  A p; costs about as much as a step  [mm]
 * zones         0 in adhesion, else the sign of the traction that slips; of no meaning where the
 *               bound is zero */
MICROSLIP_API enum microslip_status microslip_get_nodes(microslip_rolling* rolling, double* values,
                                                        size_t length);
MICROSLIP_API enum microslip_status microslip_get_traction(microslip_rolling* rolling,
                                                           double* values, size_t length);
MICROSLIP_API enum microslip_status microslip_get_bound(microslip_rolling* rolling, double* values,
                                                        size_t length);
MICROSLIP_API enum microslip_status microslip_get_slip(microslip_rolling* rolling, double* values,
                                                       size_t length);
MICROSLIP_API enum microslip_status microslip_get_displacement(microslip_rolling* rolling,
                                                               double* values, size_t length);
MICROSLIP_API enum microslip_status microslip_get_zones(microslip_rolling* rolling, int* values,
                                                        size_t length);

/** The kind of load under which steady rolling is solved. */
enum microslip_load {
  MICROSLIP_CREEPAGE = 0, /**< w, finite  [1] */
  MICROSLIP_FORCE = 1     /**< F, less in absolute value than full sliding  [N/mm] */
};

enum microslip_steady_method {
  MICROSLIP_INVERSION = 0, /**< ten digits */
  MICROSLIP_ELEMENTS = 1   /**< elements over the whole contact, second order, at least 11: where
                              more than one zone sticks or slips */
};

/** The result of steady rolling under one load. If `status` is not 0, the other values are not a
 * number, or 0. */
struct microslip_steady {
  double creepage;    /**< w  [1] */
  double force;       /**< F  [N/mm] */
  double dissipation; /**< -w F, energy lost per mm rolled  [N/mm] */
  double stick_edge;  /**< x where the stick zone begins, a in full sliding; not a number if
                               elements were used  [mm] */
  double residual;    /**< slip left in adhesion, over the largest term of its equations [1] */
  double violation;   /**< of the bound or of the direction of slip, relative  [1] */
  double dissipation_error; /**< of the integral of -p s at the nodes, relative  [1] */
  double condition;         /**< of the equations in adhesion, estimate  [1] */
  int adhesion_elements;
  int slip_elements;
  int method; /**< of microslip_steady_method */
  int status; /**< of microslip_status */
};

/** Values at the nodes under each load fill arrays with room for `count` rows of `elements`
 * numbers, load by load. Each array may be null. Slip is 0 in adhesion. */
struct microslip_steady_nodes {
  double* x;            /**< ascending; elements have other nodes than inversion  [mm] */
  double* bound;        /**< [N/mm^2] */
  double* traction;     /**< [N/mm^2] */
  double* slip;         /**< relative slip s  [1] */
  double* displacement; /**< [mm] */
};

/** Solves steady rolling under each of many loads: the force of a creepage, or the creepage of a
 * force. It needs no handle. In plane strain the length may have any value, as the creepage does
 * not depend on it.
 *
 * Returns the first status of a load that is not 0; all other loads are solved nevertheless. The
 * message then names the load, from 0: "loads[3]: ..."
 *
 * elements   N nodes, 1 ... 4 000 000; they say where values are given, and take part in the
 *            solution by elements only
 * load_type  of microslip_load
 * loads      `count` of them
 * states     out, `count` of them
 * nodes      out, may be null
 * message    out, may be null, like the message of microslip_create(). If all loads have a solution,
 *            it is empty, or "warning: " and the text of microslip_warning() for the largest
 *            creepage, or the units */
MICROSLIP_API enum microslip_status microslip_solve_steady(
    const struct microslip_material* material, const struct microslip_contact* contact,
    const struct microslip_kernel* kernel, int elements, int load_type, const double* loads,
    size_t count, struct microslip_steady* states, const struct microslip_steady_nodes* nodes,
    char* message, size_t message_size);

#ifdef __cplusplus
}
#endif

#endif
