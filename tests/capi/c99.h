/* SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#ifdef __cplusplus
extern "C" {
#endif

/* G = 1, nu = 0.28, a = 1, peak 1, a strip of 4, 20 elements: w = 0.5 over 0.07  [N/mm] */
double force_after_a_step_in_c99(void);

#ifdef __cplusplus
}
#endif
