/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the functions of microslip in Octave and MATLAB have in common. */
#ifndef MICROSLIP_MEX_H
#define MICROSLIP_MEX_H

#include <mex.h>
#include <microslip.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

static inline void check(enum microslip_status status, const char* message) {
  static const char* const names[] = {"ok", "bad_input", "no_solution", "out_of_memory",
                                      "internal"};
  char id[64] = "microslip:";
  if (status != MICROSLIP_OK) mexErrMsgIdAndTxt(strcat(id, names[status]), "%s", message);
}

/* A handle is a row of whole numbers, each the address: one of a line contact, two of an ellipse, and
 * three of a table of creep forces, so that none is taken for another. */
static inline mxArray* new_handle(void* address, size_t length) {
  mxArray* array = mxCreateNumericMatrix(1, length, mxUINT64_CLASS, mxREAL);
  uint64_t* numbers = (uint64_t*)mxGetData(array);
  for (size_t i = 0; i < length; ++i) numbers[i] = (uint64_t)(uintptr_t)address;
  return array;
}

static inline void* handle_of(const mxArray* array, size_t length) {
  static const char* const kinds[] = {"a line contact", "an ellipse", "a table"};
  if (!mxIsUint64(array) || mxGetNumberOfElements(array) != length)
    mexErrMsgIdAndTxt("microslip:bad_input", "expected a handle of %s", kinds[length - 1]);
  return (void*)(uintptr_t)(*(uint64_t*)mxGetData(array));
}

/* A field that must be there; null for one that need not. */
static inline const mxArray* field(const mxArray* problem, const char* name, int needed) {
  const mxArray* value = mxGetField(problem, 0, name);
  if (!value && needed)
    mexErrMsgIdAndTxt("microslip:bad_input", "%s: expected in the struct", name);
  return value;
}

static inline double number(const mxArray* problem, const char* name, int needed) {
  const mxArray* value = field(problem, name, needed);
  return value ? mxGetScalar(value) : 0;
}

static inline int is(const char* command, const char* name) { return strcmp(command, name) == 0; }

#endif
