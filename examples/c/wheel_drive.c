/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A wheel that a torque drives and then brakes, coupled to microslip step by step, per mm of width:
 *
 *   m dv/dt = F,   I domega/dt = T(t) - R F,   F the force of the contact.
 *
 * Time steps are equal, so dq = v dt is another one in each, from 0.01 to 3.3 elements. The
 * midpoint rule: mean velocities over a step move the contact, whose mean force moves the wheel.
 * Its equation for the mean force is solved by Newton's method with the derivatives of the step.
 * Then energy is balanced to rounding, whatever the steps.
 *
 *   cc wheel_drive.c $(pkg-config --cflags --libs microslip) -lm -o wheel_drive && ./wheel_drive */
#include <math.h>
#include <microslip.h>
#include <stdio.h>
#include <stdlib.h>

enum { STEPS = 400, ELEMENTS = 100 };

static const struct microslip_material material = {82000, 0.28};
static const struct microslip_contact contact = {5, 300, NULL, NULL, 0};
static const struct microslip_kernel kernel = {MICROSLIP_STRIP, 10};
static const struct microslip_grid grid = {ELEMENTS, MICROSLIP_REMEMBERED};

static const double mass = 0.8;        /* m  [N s^2/mm^2] */
static const double inertia = 6000;    /* I  [N s^2] */
static const double radius = 460;      /* R  [mm] */
static const double time_step = 0.001; /* [s] */
static const double most_torque = 0.9; /* of full sliding times R  [1] */

static const char columns[] =
    "# columns\n"
    "#   t [s]: time\n"
    "#   v [mm/s]: velocity\n"
    "#   omega [rad/s]: angular velocity\n"
    "#   step_ratio [1]: dq/dx of the step\n"
    "#   torque [N]: T, mean over the step\n"
    "#   force [N/mm]: F of the contact, mean over the step\n"
    "#   creepage [1]: (v - omega R)/v of the step\n"
    "#   slip_elements [1]: elements in slip\n"
    "#   kinetic [N]: energy of the wheel, per mm of width as all\n"
    "#   elastic [N]: of the contact\n"
    "#   dissipated [N]: by slip, with mean tractions\n"
    "#   work [N]: done by the torque\n"
    "#   missing [N]: kinetic less kinetic at the start + elastic + dissipated - work\n"
    "t\tv\tomega\tstep_ratio\ttorque\tforce\tcreepage\tslip_elements\t"
    "kinetic\telastic\tdissipated\twork\tmissing";

struct wheel {
  double velocity; /* v  [mm/s] */
  double spin;     /* omega  [rad/s] */
  double torque;   /* T, the mean over the step  [N] */
};

static double kinetic_energy(const struct wheel* wheel) {
  return (mass * wheel->velocity * wheel->velocity + inertia * wheel->spin * wheel->spin) / 2;
}

static void check(enum microslip_status status, microslip_rolling* rolling) {
  if (status == MICROSLIP_OK) return;
  fprintf(stderr, "wheel_drive: %s\n", microslip_message(rolling));
  exit(status);
}

/* A step with a mean force, and its derivatives by that force. */
struct motion {
  double creepage, creepage_slope;
  double dq, dq_slope; /* [mm] */
};

static struct motion motion_with(const struct wheel* wheel, double force) {
  const double velocity = wheel->velocity + time_step * force / (2 * mass);
  const double spin = wheel->spin + time_step * (wheel->torque - radius * force) / (2 * inertia);
  const double velocity_slope = time_step / (2 * mass);
  const double spin_slope = -time_step * radius / (2 * inertia);
  const double rolled = radius * spin / velocity;
  const struct motion motion = {1 - rolled,
                                (rolled * velocity_slope - radius * spin_slope) / velocity,
                                velocity * time_step, velocity_slope * time_step};
  return motion;
}

/* By how much a mean force is above the one to which it leads, and the derivative of that  [N/mm].
 */
static double excess(microslip_rolling* rolling, const struct wheel* wheel, double force,
                     double* slope) {
  const struct motion motion = motion_with(wheel, force);
  struct microslip_state state;
  struct microslip_jacobian jacobian;
  check(microslip_set_creepage(rolling, motion.creepage), rolling);
  check(microslip_attempt_with_jacobian(rolling, motion.dq, &state, &jacobian), rolling);
  *slope = 1 - jacobian.by_load.mean_force * motion.creepage_slope -
           jacobian.by_length.mean_force * motion.dq_slope;
  return force - state.mean_force;
}

/* The mean force that leads to itself; the step with it is the one tried last. */
static double find_mean_force(microslip_rolling* rolling, const struct wheel* wheel, double force,
                              double scale) {
  double excess_before = INFINITY;
  for (int trials = 0; trials < 50; ++trials) {
    double slope;
    const double now = excess(rolling, wheel, force, &slope);
    const double accepted = fabs(now) < excess_before ? 1e-13 : 1e-11; /* or rounding */
    if (fabs(now) <= accepted * scale) return force;
    excess_before = fabs(now);
    force -= now / slope;
  }
  fprintf(stderr, "wheel_drive: the midpoint rule finds no force\n");
  exit(MICROSLIP_NO_SOLUTION);
}

int main(void) {
  const double pi = acos(-1.0), end = STEPS * time_step, dx = 2 * contact.half_width / ELEMENTS;
  char message[512];
  microslip_rolling* rolling;
  if (microslip_create(&material, &contact, &kernel, &grid, &rolling, message, sizeof message)) {
    fprintf(stderr, "wheel_drive: %s\n", message);
    return EXIT_FAILURE;
  }
  double full_sliding, force = 0, before = 0, work = 0, dissipated = 0;
  check(microslip_get_full_sliding(rolling, &full_sliding), rolling);
  struct wheel wheel = {1, 1 / radius, 0};
  const double start = kinetic_energy(&wheel);

  printf("# wheel_drive: a wheel that a torque drives and then brakes\n# parameters\n");
  printf("#   mass = %g\n#   inertia = %g\n#   radius = %g\n", mass, inertia, radius);
  printf("#   time_step = %g\n#   most_torque = %g\n", time_step, most_torque);
  printf("#   grid.elements = %d\n%s\n", ELEMENTS, columns);
  for (int k = 0; k < STEPS; ++k) {
    const double middle = (k + 0.5) * time_step;
    wheel.torque = most_torque * full_sliding * radius * sin(2 * pi * middle / end);
    const double guess = 2 * force - before;
    before = force;
    force = find_mean_force(rolling, &wheel, guess, full_sliding);
    const double dq = motion_with(&wheel, force).dq, spin_before = wheel.spin;
    check(microslip_advance(rolling, dq), rolling);
    wheel.velocity += time_step * force / mass;
    wheel.spin += time_step * (wheel.torque - radius * force) / inertia;

    struct microslip_state state;
    double elastic;
    check(microslip_get_state(rolling, &state), rolling);
    check(microslip_get_elastic_energy(rolling, &elastic), rolling);
    const double kinetic = kinetic_energy(&wheel);
    work += wheel.torque * time_step * (spin_before + wheel.spin) / 2;
    dissipated += state.dissipation * dq;
    printf("%.17g\t%.17g\t%.17g\t%.17g\t%.17g\t%.17g\t%.17g\t%d\t", (k + 1) * time_step,
           wheel.velocity, wheel.spin, dq / dx, wheel.torque, force, state.creepage,
           state.slip_elements);
    printf("%.17g\t%.17g\t%.17g\t%.17g\t%.17g\n", kinetic, elastic, dissipated, work,
           kinetic - start + elastic + dissipated - work);
  }
  microslip_destroy(rolling);
  return 0;
}
