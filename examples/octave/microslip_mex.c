/* SPDX-License-Identifier: GPL-3.0-or-later */
/* microslip in Octave and MATLAB; microslip.h says what everything means.
 *
 *   h = microslip_mex('create', problem)    a struct with shear_modulus, poisson_ratio,
 *                                           half_width, peak_traction or bound_x and bound_value,
 *                                           kernel 'strip' or 'plane', with
 *                                           _lateral behind it for loads across the rolling,
 *                                           length, elements, scheme
 *                                           'remembered' if not given, or 'direct'; for bodies of
 *                                           different material dundurs_beta and friction, too
 *   microslip_mex('set_creepage', h, w)     likewise set_force, advance
 *   microslip_mex('set_contact', h, a, g)   factors of the half-width and bound, over the values of
 *                                           the contact that was created
 *   microslip_mex('save', h, path)          the state to a file; likewise restore, from a file
 *   microslip_mex('destroy', h)
 *   s = microslip_mex('attempt', h, dq)     a struct as microslip_state
 *   [s, J] = microslip_mex('attempt', h, dq)  and a struct as microslip_jacobian
 *   s = microslip_mex('state', h)
 *   v = microslip_mex('nodes', h)           a column; likewise traction, bound, slip, displacement
 *   e = microslip_mex('elastic_energy', h)  likewise full_sliding; copy, a handle
 *   S = microslip_mex('start_from_shift', h, F)
 *   s = microslip_mex('shift_to_force', h, F)
 *                                           a struct as microslip_shift; likewise
 *                                           shift_by_distance, with a rigid shift
 *   s = microslip_mex('roll', h, dq, 'creepage', w)
 *                                           many steps in one call, or likewise 'force', F: arrays of
 *                                           one length; a struct as microslip_state, of columns, a row
 *                                           a step. If a step fails, none has been made
 *   s = microslip_mex('steady', problem, 'creepage', w)
 *                                           steady rolling under each of an array of loads, likewise
 *                                           'force', F: a struct as microslip_steady, of columns, a
 *                                           row a load, and matrices x, bound, traction, slip,
 *                                           displacement, a column a load. It needs no handle
 *
 * Contact ellipses: microslip_ellipse_mex.c.
 *
 * Octave: mkoctfile --mex microslip_mex.c -lmicroslip;  MATLAB: mex microslip_mex.c -lmicroslip */
#include "microslip_mex.h"

#include <microslip.h>
#include <stdlib.h>

static mxArray* handle_array(microslip_rolling* rolling) { return new_handle(rolling, 1); }

static mxArray* state_struct(const struct microslip_state* s) {
  const char* names[] = {"distance",      "force",     "mean_force", "creepage",
                         "dissipation",   "residual",  "violation",  "adhesion_elements",
                         "slip_elements", "iterations"};
  const double values[] = {s->distance,      s->force,     s->mean_force, s->creepage,
                           s->dissipation,   s->residual,  s->violation,  s->adhesion_elements,
                           s->slip_elements, s->iterations};
  mxArray* array = mxCreateStructMatrix(1, 1, 10, names);
  for (int i = 0; i < 10; ++i) mxSetField(array, 0, names[i], mxCreateDoubleScalar(values[i]));
  return array;
}

static mxArray* slopes_struct(const struct microslip_slopes* s) {
  const char* names[] = {"force", "mean_force", "creepage", "dissipation"};
  const double values[] = {s->force, s->mean_force, s->creepage, s->dissipation};
  mxArray* array = mxCreateStructMatrix(1, 1, 4, names);
  for (int i = 0; i < 4; ++i) mxSetField(array, 0, names[i], mxCreateDoubleScalar(values[i]));
  return array;
}

static mxArray* shift_struct(const struct microslip_shift* s) {
  const char* names[] = {"distance", "force", "dissipation", "work"};
  const double values[] = {s->distance, s->force, s->dissipation, s->work};
  mxArray* array = mxCreateStructMatrix(1, 1, 4, names);
  for (int i = 0; i < 4; ++i) mxSetField(array, 0, names[i], mxCreateDoubleScalar(values[i]));
  return array;
}

static mxArray* jacobian_struct(const struct microslip_jacobian* j) {
  const char* names[] = {"by_load", "by_length"};
  mxArray* array = mxCreateStructMatrix(1, 1, 2, names);
  mxSetField(array, 0, names[0], slopes_struct(&j->by_load));
  mxSetField(array, 0, names[1], slopes_struct(&j->by_length));
  return array;
}

/* What a struct describes; the arrays of its bound still belong to the struct. */
struct problem {
  struct microslip_material material;
  struct microslip_contact contact;
  struct microslip_kernel kernel;
  struct microslip_grid grid;
};

static struct problem read_problem(const mxArray* p) {
  const mxArray *x = field(p, "bound_x", 0), *value = field(p, "bound_value", 0);
  char kernel_name[16] = "", scheme_name[16] = "remembered";
  mxGetString(field(p, "kernel", 1), kernel_name, sizeof kernel_name);
  const struct microslip_material material = {number(p, "shear_modulus", 1),
                                              number(p, "poisson_ratio", 1)};
  const struct microslip_contact contact = {
      number(p, "half_width", 1), number(p, "peak_traction", 0), x ? mxGetPr(x) : NULL,
      value ? mxGetPr(value) : NULL, x ? mxGetNumberOfElements(x) : 0};
  static const char* const names[] = {"strip", "plane", "strip_lateral", "plane_lateral"};
  int type = 3; /* of microslip_kernel_type; -1 if the name is none of these */
  while (type >= 0 && strcmp(kernel_name, names[type])) --type;
  const struct microslip_kernel kernel = {type, number(p, "length", 1)};
  if (field(p, "scheme", 0)) mxGetString(field(p, "scheme", 0), scheme_name, sizeof scheme_name);
  const int scheme = !strcmp(scheme_name, "remembered") ? MICROSLIP_REMEMBERED
                     : !strcmp(scheme_name, "direct")   ? MICROSLIP_DIRECT
                                                        : -1;
  if (x && value && mxGetNumberOfElements(x) != mxGetNumberOfElements(value))
    mexErrMsgIdAndTxt("microslip:bad_input", "bound_value: expected as many as bound_x");
  const struct problem read = {material, contact, kernel, {(int)number(p, "elements", 1), scheme}};
  return read;
}

static mxArray* create(const mxArray* p) {
  const struct problem read = read_problem(p);
  char message[512];
  microslip_rolling* rolling;
  if (field(p, "dundurs_beta", 0)) {
    const struct microslip_unlike unlike = {number(p, "dundurs_beta", 1), number(p, "friction", 1)};
    check(microslip_create_unlike(&read.material, &unlike, &read.contact, &read.kernel, &read.grid,
                                  &rolling, message, sizeof message),
          message);
  } else {
    check(microslip_create(&read.material, &read.contact, &read.kernel, &read.grid, &rolling,
                           message, sizeof message),
          message);
  }
  return handle_array(rolling);
}

typedef enum microslip_status set_number(microslip_rolling*, double);
static const struct {
  const char* name;
  set_number* call;
} setters[] = {{"set_creepage", microslip_set_creepage},
               {"set_force", microslip_set_force},
               {"advance", microslip_advance}};

typedef enum microslip_status get_values(microslip_rolling*, double*, size_t);
static const struct {
  const char* name;
  get_values* call;
} columns[] = {{"nodes", microslip_get_nodes},
               {"traction", microslip_get_traction},
               {"bound", microslip_get_bound},
               {"slip", microslip_get_slip},
               {"displacement", microslip_get_displacement}};

/* The state and, if it is asked for, the jacobian. */
static void attempt(microslip_rolling* h, double dq, int outputs, mxArray* out[]) {
  struct microslip_state state;
  struct microslip_jacobian jacobian;
  check(outputs > 1 ? microslip_attempt_with_jacobian(h, dq, &state, &jacobian)
                    : microslip_attempt(h, dq, &state),
        microslip_message(h));
  out[0] = state_struct(&state);
  if (outputs > 1) out[1] = jacobian_struct(&jacobian);
}

/* Saves to a file, or restores from it. */
static void keep(const char* command, microslip_rolling* h, const mxArray* name) {
  char* path = mxIsChar(name) ? mxArrayToString(name) : NULL;
  if (!path) mexErrMsgIdAndTxt("microslip:bad_input", "path: expected a text");
  check(is(command, "save") ? microslip_save(h, path) : microslip_restore(h, path),
        microslip_message(h));
  mxFree(path);
}

static mxArray* answer(const char* command, microslip_rolling* h, double argument) {
  struct microslip_state state;
  struct microslip_shift shift;
  microslip_rolling* copy;
  double result = 0;
  for (int i = 0; i < 3; ++i) {
    if (!is(command, setters[i].name)) continue;
    check(setters[i].call(h, argument), microslip_message(h));
    return NULL;
  }
  for (int i = 0; i < 5; ++i) {
    if (!is(command, columns[i].name)) continue;
    mxArray* values = mxCreateDoubleMatrix(microslip_size(h), 1, mxREAL);
    check(columns[i].call(h, mxGetPr(values), microslip_size(h)), microslip_message(h));
    return values;
  }
  if (is(command, "state")) {
    check(microslip_get_state(h, &state), microslip_message(h));
    return state_struct(&state);
  }
  if (is(command, "shift_to_force") || is(command, "shift_by_distance")) {
    check(is(command, "shift_to_force") ? microslip_shift_to_force(h, argument, &shift)
                                        : microslip_shift_by_distance(h, argument, &shift),
          microslip_message(h));
    return shift_struct(&shift);
  }
  if (is(command, "copy")) {
    check(microslip_copy(h, &copy), microslip_message(h));
    return handle_array(copy);
  }
  if (is(command, "elastic_energy")) {
    check(microslip_get_elastic_energy(h, &result), microslip_message(h));
  } else if (is(command, "full_sliding")) {
    check(microslip_get_full_sliding(h, &result), microslip_message(h));
  } else if (is(command, "start_from_shift")) {
    check(microslip_start_from_shift(h, argument, &result), microslip_message(h));
  } else {
    mexErrMsgIdAndTxt("microslip:bad_input", "'%s': expected a command of microslip_mex", command);
  }
  return mxCreateDoubleScalar(result);
}

/* Of many, the message names one from 0; here they are counted from 1. */
static void check_many(enum microslip_status status, const char* message, const char* one) {
  const char *number = strchr(message, '['), *rest = strstr(message, "]: ");
  char text[640];
  if (status != MICROSLIP_OK && number && rest) {
    snprintf(text, sizeof text, "%s %ld: %s", one, strtol(number + 1, NULL, 10) + 1, rest + 3);
    message = text;
  }
  check(status, message);
}

/* Whether numbers are creepages or forces: a type of microslip_load. */
static int load_type(const mxArray* name) {
  char text[16] = "";
  mxGetString(name, text, sizeof text);
  if (!is(text, "creepage") && !is(text, "force"))
    mexErrMsgIdAndTxt("microslip:bad_input", "'%s': expected creepage or force", text);
  return is(text, "force") ? MICROSLIP_FORCE : MICROSLIP_CREEPAGE;
}

/* A column of a struct, a number for each of many C structs. */
static double* new_column(mxArray* array, const char* name, size_t rows, size_t columns) {
  mxArray* values = mxCreateDoubleMatrix(rows, columns, mxREAL);
  mxAddField(array, name);
  mxSetField(array, 0, name, values);
  return mxGetPr(values);
}

#define PUT_COLUMN(array, structs, name, count)                         \
  do {                                                                  \
    double* column = new_column(array, #name, count, 1);                \
    for (size_t i = 0; i < (count); ++i) column[i] = (structs)[i].name; \
  } while (0)

static mxArray* roll(microslip_rolling* h, const mxArray* dq, const mxArray* name,
                     const mxArray* load) {
  const size_t count = mxGetNumberOfElements(dq);
  const int by_force = load_type(name) == MICROSLIP_FORCE;
  if (!mxIsDouble(dq) || !mxIsDouble(load) || mxGetNumberOfElements(load) != count)
    mexErrMsgIdAndTxt("microslip:bad_input", "expected arrays of as many numbers as dq has");
  const struct microslip_steps steps = {
      count, mxGetPr(dq), by_force ? NULL : mxGetPr(load), by_force ? mxGetPr(load) : NULL,
      NULL,  NULL};
  struct microslip_state* s = mxCalloc(count ? count : 1, sizeof *s);
  check_many(microslip_roll(h, &steps, s), microslip_message(h), "step");
  mxArray* array = mxCreateStructMatrix(1, 1, 0, NULL);
  PUT_COLUMN(array, s, distance, count);
  PUT_COLUMN(array, s, force, count);
  PUT_COLUMN(array, s, mean_force, count);
  PUT_COLUMN(array, s, creepage, count);
  PUT_COLUMN(array, s, dissipation, count);
  PUT_COLUMN(array, s, residual, count);
  PUT_COLUMN(array, s, violation, count);
  PUT_COLUMN(array, s, adhesion_elements, count);
  PUT_COLUMN(array, s, slip_elements, count);
  PUT_COLUMN(array, s, iterations, count);
  mxFree(s);
  return array;
}

static mxArray* steady(const mxArray* p, const mxArray* name, const mxArray* loads) {
  if (field(p, "dundurs_beta", 0))
    mexErrMsgIdAndTxt("microslip:bad_input",
                      "dundurs_beta: expected none in steady rolling, but 'create' and 'roll'");
  const struct problem read = read_problem(p);
  const int type = load_type(name), elements = read.grid.elements;
  const size_t count = mxGetNumberOfElements(loads), nodes = elements > 0 ? elements : 0;
  if (!mxIsDouble(loads)) mexErrMsgIdAndTxt("microslip:bad_input", "loads: expected numbers");
  struct microslip_steady* s = mxCalloc(count ? count : 1, sizeof *s);
  mxArray* array = mxCreateStructMatrix(1, 1, 0, NULL);
  struct microslip_steady_nodes values;
  char message[512] = "";
  values.x = new_column(array, "x", nodes, count);
  values.bound = new_column(array, "bound", nodes, count);
  values.traction = new_column(array, "traction", nodes, count);
  values.slip = new_column(array, "slip", nodes, count);
  values.displacement = new_column(array, "displacement", nodes, count);
  check_many(microslip_solve_steady(&read.material, &read.contact, &read.kernel, elements, type,
                                    mxGetPr(loads), count, s, &values, message, sizeof message),
             message, "load");
  PUT_COLUMN(array, s, creepage, count);
  PUT_COLUMN(array, s, force, count);
  PUT_COLUMN(array, s, dissipation, count);
  PUT_COLUMN(array, s, stick_edge, count);
  PUT_COLUMN(array, s, residual, count);
  PUT_COLUMN(array, s, violation, count);
  PUT_COLUMN(array, s, dissipation_error, count);
  PUT_COLUMN(array, s, condition, count);
  PUT_COLUMN(array, s, adhesion_elements, count);
  PUT_COLUMN(array, s, slip_elements, count);
  PUT_COLUMN(array, s, method, count);
  PUT_COLUMN(array, s, status, count);
  mxFree(s);
  return array;
}

void mexFunction(int outputs, mxArray* out[], int inputs, const mxArray* in[]) {
  char command[32] = "";
  if (inputs < 2 || mxGetString(in[0], command, sizeof command) != 0)
    mexErrMsgIdAndTxt("microslip:bad_input", "expected a command, and a handle or a struct");
  if (is(command, "create")) {
    out[0] = create(in[1]);
    return;
  }
  if (is(command, "steady") && inputs > 3) {
    out[0] = steady(in[1], in[2], in[3]);
    return;
  }
  microslip_rolling* handle = handle_of(in[1], 1);
  if (is(command, "destroy")) {
    microslip_destroy(handle);
    return;
  }
  if (is(command, "set_contact") && inputs > 3) {
    check(microslip_set_contact(handle, mxGetScalar(in[2]), mxGetScalar(in[3])),
          microslip_message(handle));
    return;
  }
  if (is(command, "roll") && inputs > 4) {
    out[0] = roll(handle, in[2], in[3], in[4]);
    return;
  }
  if ((is(command, "save") || is(command, "restore")) && inputs > 2) {
    keep(command, handle, in[2]);
    return;
  }
  const double argument = inputs > 2 ? mxGetScalar(in[2]) : mxGetNaN();
  if (is(command, "attempt")) {
    attempt(handle, argument, outputs, out);
    return;
  }
  mxArray* result = answer(command, handle, argument);
  if (result) out[0] = result;
}
