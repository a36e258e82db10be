/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A wheelset runs from a straight track through a transition into a curve to the left. Each wheel is a
 * cone, and touches its rail in an ellipse whose forces are those of steady rolling.
 *
 * Lateral displacement y (to the left) and yaw psi of the wheelset are relative to the track, of the
 * curvature k; V is its speed, r the rolling radius, l half the distance of the contacts, and c the
 * cone's slope. With the sign + of the left wheel and - of the right one, the motions of the contacts are
 *   xi = -+(l k + l psi'/V + c y/r),  eta = y'/V - psi,  phi = psi'/V + k -+ c/r.
 * The suspension holds the wheelset to the track:
 *   m y'' = Fy + Fy - ky y - dy y',   I psi'' = l (Fx_right - Fx_left) + Mz + Mz - kp psi.
 * The midpoint rule solves for the mean velocities by Newton's method, with the derivatives of the
 * contact's resultants by its motion.
 *
 *   cc wheelset.c $(pkg-config --cflags --libs microslip) -lm -o wheelset && ./wheelset >wheelset.tsv */
#include <math.h>
#include <microslip_ellipse.h>
#include <stdio.h>
#include <stdlib.h>

enum { STEPS = 1500, EVERY = 15, LEFT = 0, RIGHT = 1 };

static const struct microslip_material steel = {80769, 0.3};
static const struct microslip_bodies bodies = {60000, 460, 0, 0, 300, 0.3};
static const struct microslip_ellipse_grid grid = {6, 8};

static const double speed = 20000;                  /* V  [mm/s] */
static const double radius = 460;                   /* r  [mm] */
static const double half_gauge = 750;               /* l  [mm] */
static const double cone = 0.1;                     /* c  [1] */
static const double curvature = 1 / 8e5;            /* of the curve  [1/mm] */
static const double begins = 0.2, ends = 1.2;       /* of the transition  [s] */
static const double mass = 1.2;                     /* m  [N s^2/mm] */
static const double inertia = 7e5;                  /* I  [N mm s^2] */
static const double stiffness = 2000, damping = 20; /* ky [N/mm], dy [N s/mm] */
static const double yaw_stiffness = 2e9;            /* kp  [N mm] */
static const double time_step = 0.002;              /* [s] */

struct wheelset {
  double place[2];    /* y [mm], psi */
  double velocity[2]; /* [mm/s], [rad/s] */
};

/* Forces and moment on the wheelset, and their derivatives by y, psi, y' and psi'. */
struct answer {
  double force[2];
  double slope[2][4];
  struct microslip_ellipse_state contact[2];
};

static double curvature_at(double time) {
  const double part = (time - begins) / (ends - begins);
  return curvature * fmin(fmax(part, 0), 1);
}

static void check(enum microslip_status status, microslip_ellipse* ellipse) {
  if (status == MICROSLIP_OK) return;
  fprintf(stderr, "wheelset: %s\n", microslip_ellipse_message(ellipse));
  exit((int)status);
}

static struct answer answer_of(microslip_ellipse* const ellipses[2], const struct wheelset* at,
                               double k) {
  const double y = at->place[0], psi = at->place[1];
  const double dy = at->velocity[0], dpsi = at->velocity[1];
  struct answer answer = {.force = {-stiffness * y - damping * dy, -yaw_stiffness * psi},
                          .slope = {{-stiffness, 0, -damping, 0}, {0, -yaw_stiffness, 0, 0}}};
  for (int side = LEFT; side <= RIGHT; ++side) {
    const double s = side == LEFT ? 1 : -1;
    const struct microslip_ellipse_load load = {
        {MICROSLIP_MOTION, MICROSLIP_MOTION, MICROSLIP_MOTION},
        {-s * (half_gauge * (k + dpsi / speed) + cone * y / radius), dy / speed - psi,
         dpsi / speed + k - s * cone / radius}};
    const double by_state[3][4] = {{-s * cone / radius, 0, 0, -s * half_gauge / speed},
                                   {0, -1, 1 / speed, 0},
                                   {0, 0, 0, 1 / speed}};
    /* What a resultant does: Fx to the yaw, Fy to y, and Mz to the yaw. */
    const double acts[2][3] = {{0, 1, 0}, {-s * half_gauge, 0, 1}};
    double jacobian[9];
    check(microslip_ellipse_solve_steady(ellipses[side], &load, &answer.contact[side], jacobian),
          ellipses[side]);
    for (int i = 0; i < 2; ++i) {
      for (int r = 0; r < 3; ++r) {
        answer.force[i] += acts[i][r] * answer.contact[side].resultants[r];
        for (int m = 0; m < 3; ++m) {
          for (int j = 0; j < 4; ++j) {
            answer.slope[i][j] += acts[i][r] * jacobian[3 * r + m] * by_state[m][j];
          }
        }
      }
    }
  }
  return answer;
}

/* A step; `at` is then the state in its middle, and the answer the one there. */
static struct answer step(microslip_ellipse* const ellipses[2], struct wheelset* set,
                          struct wheelset* at, double time) {
  const double inertias[2] = {mass, inertia}, half = time_step / 2;
  const double k = curvature_at(time + half);
  struct answer answer;
  *at = *set;
  for (int trial = 0; trial < 20; ++trial) {
    for (int i = 0; i < 2; ++i) at->place[i] = set->place[i] + half * at->velocity[i];
    answer = answer_of(ellipses, at, k);
    double wrong[2], matrix[2][2];
    for (int i = 0; i < 2; ++i) {
      wrong[i] = inertias[i] * (at->velocity[i] - set->velocity[i]) / half - answer.force[i];
      for (int j = 0; j < 2; ++j) {
        matrix[i][j] =
            (i == j ? inertias[i] / half : 0) - half * answer.slope[i][j] - answer.slope[i][2 + j];
      }
    }
    const double determinant = matrix[0][0] * matrix[1][1] - matrix[0][1] * matrix[1][0];
    const double by[2] = {(wrong[0] * matrix[1][1] - wrong[1] * matrix[0][1]) / determinant,
                          (wrong[1] * matrix[0][0] - wrong[0] * matrix[1][0]) / determinant};
    for (int i = 0; i < 2; ++i) at->velocity[i] -= by[i];
    if (fabs(by[0]) < 1e-7 && fabs(by[1]) < 1e-10) break;
  }
  for (int i = 0; i < 2; ++i) {
    set->place[i] += time_step * at->velocity[i];
    set->velocity[i] = 2 * at->velocity[i] - set->velocity[i];
  }
  return answer;
}

int main(void) {
  struct microslip_ellipse_contact axes;
  microslip_ellipse* ellipses[2] = {NULL, NULL};
  struct wheelset set = {{3, 0}, {0, 0}}, middle;
  char why[256];
  for (int side = LEFT; side <= RIGHT; ++side) {
    if (microslip_hertz_ellipse(&steel, &bodies, &axes, why, sizeof why) ||
        microslip_ellipse_create(&steel, &axes, &grid, &ellipses[side], why, sizeof why)) {
      fprintf(stderr, "wheelset: %s\n", why);
      return 1;
    }
  }
  puts(
      "# columns\n"
      "#   t [s]: time, in the middle of a step as all\n"
      "#   curvature [1/mm]: of the track\n"
      "#   y [mm]: lateral displacement, to the left\n"
      "#   psi [1]: yaw\n"
      "#   force_left [N], force_right [N]: along the rolling, on the wheels\n"
      "#   lateral_left [N], lateral_right [N]: across it\n"
      "#   use_left [1], use_right [1]: of friction, size of the force over full sliding\n"
      "t\tcurvature\ty\tpsi\tforce_left\tforce_right\tlateral_left\tlateral_right\tuse_left\t"
      "use_right");
  for (int i = 0; i < STEPS; ++i) {
    const double time = i * time_step;
    const struct answer answer = step(ellipses, &set, &middle, time);
    const struct microslip_ellipse_state *l = &answer.contact[LEFT], *r = &answer.contact[RIGHT];
    if (i % EVERY != 0) continue;
    printf("%.3f\t%.6g\t%.9g\t%.9g\t%.9g\t%.9g\t%.9g\t%.9g\t%.6g\t%.6g\n", time + time_step / 2,
           curvature_at(time + time_step / 2), middle.place[0], middle.place[1], l->resultants[0],
           r->resultants[0], l->resultants[1], r->resultants[1],
           hypot(l->resultants[0], l->resultants[1]) / l->full_sliding,
           hypot(r->resultants[0], r->resultants[1]) / r->full_sliding);
  }
  for (int side = LEFT; side <= RIGHT; ++side) microslip_ellipse_destroy(ellipses[side]);
  return 0;
}
