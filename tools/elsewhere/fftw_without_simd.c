/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Preloaded, it makes the plans of FFTW do without vector instructions, as on another processor. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <fftw3.h>
#include <stdlib.h>

static void* original(const char* name) {
  void* function = dlsym(RTLD_NEXT, name);
  if (function == NULL) abort();
  return function;
}

fftw_plan fftw_plan_dft_r2c_1d(int n, double* in, fftw_complex* out, unsigned flags) {
  fftw_plan (*plan)(int, double*, fftw_complex*, unsigned);
  *(void**)&plan = original("fftw_plan_dft_r2c_1d");
  return plan(n, in, out, flags | FFTW_NO_SIMD);
}

fftw_plan fftw_plan_dft_c2r_1d(int n, fftw_complex* in, double* out, unsigned flags) {
  fftw_plan (*plan)(int, fftw_complex*, double*, unsigned);
  *(void**)&plan = original("fftw_plan_dft_c2r_1d");
  return plan(n, in, out, flags | FFTW_NO_SIMD);
}
