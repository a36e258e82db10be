/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Contact ellipses of microslip in Octave and MATLAB; microslip_ellipse.h says what everything means.
 *
 *   c = microslip_ellipse_mex('hertz', bodies)
 *                                   a struct with half_width, lateral_half_width and peak_traction, of a
 *                                   struct with shear_modulus, poisson_ratio, normal_load, radius_1,
 *                                   radius_2, lateral_radius_1, lateral_radius_2 and friction; a radius
 *                                   that is not given is that of a flat body
 *   h = microslip_ellipse_mex('create', problem)
 *                                   a struct with shear_modulus, poisson_ratio, half_width,
 *                                   lateral_half_width, peak_traction and, if they are given, rows and
 *                                   elements; or with the fields of bodies in the place of the axes
 *   [s, J] = microslip_ellipse_mex('steady', h, load)
 *                                   steady rolling: a struct as microslip_ellipse_state, and 3 x 3
 *                                   derivatives of the resultants, in rows, by the motions. A load is a
 *                                   struct with creepage or force, lateral_creepage or lateral_force, and
 *                                   spin or spin_moment; a motion that is not given is 0
 *   s = microslip_ellipse_mex('advance', h, dq, load)
 *   [s, J] = microslip_ellipse_mex('attempt', h, dq, load)
 *   s = microslip_ellipse_mex('shift', h, load)
 *                                   motions are then shifts [mm] and a rotation [rad]
 *   s = microslip_ellipse_mex('state', h)
 *   c = microslip_ellipse_mex('cells', h)
 *                                   a struct as microslip_ellipse_cells, of columns
 *   microslip_ellipse_mex('set_contact', h, size_factor, bound_factor)
 *   e = microslip_ellipse_mex('elastic_energy', h)
 *   g = microslip_ellipse_mex('copy', h)
 *   microslip_ellipse_mex('save', h, path)  likewise restore
 *   microslip_ellipse_mex('destroy', h)
 *
 *   t = microslip_ellipse_mex('open_table', path)
 *                                   a table of creep forces, see microslip_creep_table.h; likewise close_table
 *   [F, J] = microslip_ellipse_mex('table_forces', t, problem, motions)
 *                                   forces and moments, n x 3, of a struct as for 'create' without grid, under
 *                                   motions, n x 3; and their derivatives, 3 x 3 x n, resultants in rows
 *
 * Octave: mkoctfile --mex microslip_ellipse_mex.c -lmicroslip;  MATLAB: mex microslip_ellipse_mex.c -lmicroslip */
#include <microslip_creep_table.h>
#include <microslip_ellipse.h>

#include "microslip_mex.h"

static mxArray* handle_array(microslip_ellipse* ellipse) { return new_handle(ellipse, 2); }

static mxArray* state_struct(const struct microslip_ellipse_state* s) {
  const char* names[] = {
      "distance", "force",       "lateral_force", "spin_moment", "creepage", "lateral_creepage",
      "spin",     "dissipation", "full_sliding",  "slip_share",  "residual", "iterations"};
  const double values[] = {s->distance,     s->resultants[0], s->resultants[1], s->resultants[2],
                           s->motion[0],    s->motion[1],     s->motion[2],     s->dissipation,
                           s->full_sliding, s->slip_share,    s->residual,      s->iterations};
  mxArray* array = mxCreateStructMatrix(1, 1, 12, names);
  for (int i = 0; i < 12; ++i) mxSetField(array, 0, names[i], mxCreateDoubleScalar(values[i]));
  return array;
}

static struct microslip_material material_of(const mxArray* p) {
  const struct microslip_material material = {number(p, "shear_modulus", 1),
                                              number(p, "poisson_ratio", 1)};
  return material;
}

static struct microslip_ellipse_contact axes_of(const mxArray* p) {
  const struct microslip_material material = material_of(p);
  struct microslip_ellipse_contact axes;
  char message[512];
  if (!field(p, "normal_load", 0)) {
    axes.half_width = number(p, "half_width", 1);
    axes.lateral_half_width = number(p, "lateral_half_width", 1);
    axes.peak_traction = number(p, "peak_traction", 1);
    return axes;
  }
  const struct microslip_bodies bodies = {
      number(p, "normal_load", 1),      number(p, "radius_1", 0),         number(p, "radius_2", 0),
      number(p, "lateral_radius_1", 0), number(p, "lateral_radius_2", 0), number(p, "friction", 1)};
  check(microslip_hertz_ellipse(&material, &bodies, &axes, message, sizeof message), message);
  return axes;
}

static mxArray* hertz(const mxArray* p) {
  const char* names[] = {"half_width", "lateral_half_width", "peak_traction"};
  const struct microslip_ellipse_contact axes = axes_of(p);
  const double values[] = {axes.half_width, axes.lateral_half_width, axes.peak_traction};
  mxArray* array = mxCreateStructMatrix(1, 1, 3, names);
  for (int i = 0; i < 3; ++i) mxSetField(array, 0, names[i], mxCreateDoubleScalar(values[i]));
  return array;
}

static mxArray* create(const mxArray* p) {
  const struct microslip_material material = material_of(p);
  const struct microslip_ellipse_contact axes = axes_of(p);
  const struct microslip_ellipse_grid grid = {(int)number(p, "rows", 0),
                                              (int)number(p, "elements", 0)};
  microslip_ellipse* ellipse;
  char message[512];
  check(microslip_ellipse_create(&material, &axes, &grid, &ellipse, message, sizeof message),
        message);
  return handle_array(ellipse);
}

/* A field of another name is refused, as a misspelt one would be a motion of 0. */
static struct microslip_ellipse_load load_of(const mxArray* p) {
  static const char* const names[3][2] = {
      {"creepage", "force"}, {"lateral_creepage", "lateral_force"}, {"spin", "spin_moment"}};
  struct microslip_ellipse_load load = {{0, 0, 0}, {0, 0, 0}};
  int given = 0;
  if (!mxIsStruct(p)) mexErrMsgIdAndTxt("microslip:bad_input", "load: expected a struct");
  for (int j = 0; j < 3; ++j) {
    for (int kind = 0; kind < 2; ++kind) {
      const mxArray* value = mxGetField(p, 0, names[j][kind]);
      if (!value) continue;
      if (kind == 1 && mxGetField(p, 0, names[j][0]))
        mexErrMsgIdAndTxt("microslip:bad_input", "%s: expected %s or %s, not both", names[j][1],
                          names[j][0], names[j][1]);
      load.prescribed[j] = kind == 1 ? MICROSLIP_RESULTANT : MICROSLIP_MOTION;
      load.value[j] = mxGetScalar(value);
      ++given;
    }
  }
  if (given != mxGetNumberOfFields(p))
    mexErrMsgIdAndTxt("microslip:bad_input",
                      "load: expected no fields but creepage or force, lateral_creepage or "
                      "lateral_force, and spin or spin_moment");
  return load;
}

/* In C by rows, and here by columns. */
static mxArray* jacobian_array(const double* by_rows) {
  mxArray* array = mxCreateDoubleMatrix(3, 3, mxREAL);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) mxGetPr(array)[i + 3 * j] = by_rows[3 * i + j];
  }
  return array;
}

static double* new_column(mxArray* array, const char* name, size_t rows) {
  mxArray* values = mxCreateDoubleMatrix(rows, 1, mxREAL);
  mxAddField(array, name);
  mxSetField(array, 0, name, values);
  return mxGetPr(values);
}

static mxArray* cells(microslip_ellipse* h) {
  const size_t size = microslip_ellipse_size(h);
  mxArray* array = mxCreateStructMatrix(1, 1, 0, NULL);
  struct microslip_ellipse_cells out;
  int* slips = mxCalloc(size ? size : 1, sizeof *slips);
  out.x = new_column(array, "x", size);
  out.y = new_column(array, "y", size);
  out.area = new_column(array, "area", size);
  out.bound = new_column(array, "bound", size);
  out.traction_x = new_column(array, "traction_x", size);
  out.traction_y = new_column(array, "traction_y", size);
  out.slip_x = new_column(array, "slip_x", size);
  out.slip_y = new_column(array, "slip_y", size);
  out.slips = slips;
  check(microslip_ellipse_get_cells(h, &out), microslip_ellipse_message(h));
  double* column = new_column(array, "slips", size);
  for (size_t i = 0; i < size; ++i) column[i] = slips[i];
  mxFree(slips);
  return array;
}

static char* text_of(const mxArray* name) {
  char* text = mxIsChar(name) ? mxArrayToString(name) : NULL;
  if (!text) mexErrMsgIdAndTxt("microslip:bad_input", "path: expected a text");
  return text;
}

static void keep(const char* command, microslip_ellipse* h, const mxArray* name) {
  char* path = text_of(name);
  check(is(command, "save") ? microslip_ellipse_save(h, path) : microslip_ellipse_restore(h, path),
        microslip_ellipse_message(h));
  mxFree(path);
}

/* Commands that give a state, and perhaps derivatives. Returns whether it was one. */
static int gives_state(const char* command, microslip_ellipse* h, int outputs, mxArray* out[],
                       int inputs, const mxArray* in[]) {
  const int steps = is(command, "advance") || is(command, "attempt");
  const int has_jacobian = is(command, "steady") || is(command, "attempt");
  struct microslip_ellipse_state state;
  struct microslip_ellipse_load load;
  double jacobian[9], *wanted = outputs > 1 ? jacobian : NULL;
  if (is(command, "state")) {
    check(microslip_ellipse_get_state(h, &state), microslip_ellipse_message(h));
    out[0] = state_struct(&state);
    return 1;
  }
  if (!steps && !has_jacobian && !is(command, "shift")) return 0;
  if (inputs < (steps ? 4 : 3))
    mexErrMsgIdAndTxt("microslip:bad_input", "'%s': expected %sa load", command,
                      steps ? "dq and " : "");
  load = load_of(in[steps ? 3 : 2]);
  const double dq = steps ? mxGetScalar(in[2]) : 0;
  check(is(command, "steady")    ? microslip_ellipse_solve_steady(h, &load, &state, wanted)
        : is(command, "attempt") ? microslip_ellipse_attempt(h, dq, &load, &state, wanted)
        : is(command, "advance") ? microslip_ellipse_advance(h, dq, &load, &state)
                                 : microslip_ellipse_shift(h, &load, &state),
        microslip_ellipse_message(h));
  out[0] = state_struct(&state);
  if (has_jacobian && outputs > 1) out[1] = jacobian_array(jacobian);
  return 1;
}

static void forces_of_table(const microslip_creep_table* table, const mxArray* problem,
                            const mxArray* motions, int outputs, mxArray* out[]) {
  const size_t n = mxGetM(motions);
  const mwSize sizes[] = {3, 3, n};
  char message[512];
  if (!mxIsStruct(problem)) mexErrMsgIdAndTxt("microslip:bad_input", "expected a struct");
  if (!mxIsDouble(motions) || mxIsComplex(motions) || mxGetN(motions) != 3)
    mexErrMsgIdAndTxt("microslip:bad_input", "motions: expected n x 3 real numbers");
  const struct microslip_material material = material_of(problem);
  const struct microslip_ellipse_contact axes = axes_of(problem);
  struct microslip_ellipse_contact* contacts = mxCalloc(n ? n : 1, sizeof *contacts);
  double* by_rows = mxCalloc(n ? 15 * n : 1, sizeof *by_rows);
  double *forces = by_rows + 3 * n, *jacobians = by_rows + 6 * n;
  for (size_t k = 0; k < n; ++k) {
    contacts[k] = axes;
    for (size_t i = 0; i < 3; ++i) by_rows[3 * k + i] = mxGetPr(motions)[k + n * i];
  }
  check(microslip_creep_table_forces_many(table, &material, contacts, by_rows, n, forces,
                                          outputs > 1 ? jacobians : NULL, message, sizeof message),
        message);
  out[0] = mxCreateDoubleMatrix(n, 3, mxREAL);
  if (outputs > 1) out[1] = mxCreateNumericArray(3, sizes, mxDOUBLE_CLASS, mxREAL);
  for (size_t k = 0; k < n; ++k) {
    for (size_t i = 0; i < 3; ++i) {
      mxGetPr(out[0])[k + n * i] = forces[3 * k + i];
      for (size_t j = 0; outputs > 1 && j < 3; ++j)
        mxGetPr(out[1])[9 * k + i + 3 * j] = jacobians[9 * k + 3 * i + j];
    }
  }
  mxFree(contacts);
  mxFree(by_rows);
}

/* Commands of tables. Returns whether it was one. */
static int is_of_table(const char* command, int outputs, mxArray* out[], int inputs,
                       const mxArray* in[]) {
  if (is(command, "open_table")) {
    char message[512];
    char* path = text_of(in[1]);
    microslip_creep_table* table;
    check(microslip_creep_table_open(path, &table, message, sizeof message), message);
    mxFree(path);
    out[0] = new_handle(table, 3);
  } else if (is(command, "close_table")) {
    microslip_creep_table_close(handle_of(in[1], 3));
  } else if (is(command, "table_forces") && inputs > 3) {
    forces_of_table(handle_of(in[1], 3), in[2], in[3], outputs, out);
  } else {
    return 0;
  }
  return 1;
}

void mexFunction(int outputs, mxArray* out[], int inputs, const mxArray* in[]) {
  char command[32] = "";
  if (inputs < 2 || mxGetString(in[0], command, sizeof command) != 0)
    mexErrMsgIdAndTxt("microslip:bad_input", "expected a command, and a handle or a struct");
  if (is(command, "hertz") || is(command, "create")) {
    if (!mxIsStruct(in[1])) mexErrMsgIdAndTxt("microslip:bad_input", "expected a struct");
    out[0] = is(command, "hertz") ? hertz(in[1]) : create(in[1]);
    return;
  }
  if (is_of_table(command, outputs, out, inputs, in)) return;
  microslip_ellipse* h = handle_of(in[1], 2);
  if (gives_state(command, h, outputs, out, inputs, in)) return;
  if (is(command, "destroy")) {
    microslip_ellipse_destroy(h);
  } else if (is(command, "cells")) {
    out[0] = cells(h);
  } else if (is(command, "copy")) {
    microslip_ellipse* copy;
    check(microslip_ellipse_copy(h, &copy), microslip_ellipse_message(h));
    out[0] = handle_array(copy);
  } else if (is(command, "elastic_energy")) {
    double energy = 0;
    check(microslip_ellipse_get_elastic_energy(h, &energy), microslip_ellipse_message(h));
    out[0] = mxCreateDoubleScalar(energy);
  } else if (is(command, "set_contact") && inputs > 3) {
    check(microslip_ellipse_set_contact(h, mxGetScalar(in[2]), mxGetScalar(in[3])),
          microslip_ellipse_message(h));
  } else if ((is(command, "save") || is(command, "restore")) && inputs > 2) {
    keep(command, h, in[2]);
  } else {
    mexErrMsgIdAndTxt("microslip:bad_input",
                      "'%s': expected a command of microslip_ellipse_mex, with its arguments",
                      command);
  }
}
