/* SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#ifdef __cplusplus
extern "C" {
#endif

/* G = 1, nu = 0.28, a = 1, peak 1, a strip of 4, 20 elements: w = 0.5 over 0.07  [N/mm] */
double force_after_a_step_in_c99(void);

/* The same after steps of 0.07, 0.01 and 0.2 in one call  [N/mm] */
double force_after_steps_in_c99(void);

/* The same material and bound in plane strain, steady rolling; 0 if a call fails  [N/mm] */
double steady_force_in_c99(double creepage);

/* The same material and bound in plane strain, L0 = 20: a shift to the force, then one cycle to and
 * fro between -+force without rolling. Returns what the cycle loses, -1 if a call fails  [N]
 * shift  out, n + 1 of them: the rigid shift so far after the first shift and after each of n equal
 *        parts of the way back  [mm] */
double loss_of_a_cycle_in_c99(int scheme, int elements, double force, int n, double* shift);

/* An ellipse of 6 by 4 mm, peak 300, G = 82000, nu = 0.28: Fy of steady spin; 0 if a call fails [N] */
double lateral_force_of_spin_in_c99(double spin);

#ifdef __cplusplus
}
#endif
