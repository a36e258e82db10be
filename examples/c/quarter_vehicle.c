/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A quarter of a wagon brakes to a halt and stands. Its wheel touches the rail in an ellipse that
 * remembers.
 *
 * The body moves by x and dives by the angle theta about its centre of mass at the height h; at the
 * distance l ahead of it a spring and a damper stand on the wheel, which the body guides along, and
 * which turns by the angle phi. The other end of the wagon does the mirror image. With the radius R of
 * the wheel and the force F of the contact,
 *   wheel's way q = x - (h - R) theta,  rigid shift s = q - R phi,  load N = N0 + l (k theta + c theta'),
 *   M u' = -K p - D u + F g + B b,  p = (x, theta, phi),  u = p',  g = ds/dp,  b = (0, 1, -1).
 * The brake acts between body and wheel, by Coulomb's law: the torque B is T(t) while the wheel turns
 * in it; if the wheel stops, the brake holds it to the body with any torque up to T. The body then
 * swings back, rolls back with the held wheel, and rocks on the stiffness of the contact.
 *
 * The midpoint rule has the mean velocity w over a step, with the mean of F at both ends, which
 * Newton's method finds with the derivative of the contact's step. The wheel stops at the end of a
 * step. So energy is balanced to rounding, but for shifts and turns. The way dq of the contact is
 * extrapolated, and the next step makes up for what it misses. Where |dq| is too small to roll, the
 * bodies are shifted on the spot; then the ellipse keeps its size, and its bound alone follows the load.
 *
 *   cc quarter_vehicle.c $(pkg-config --cflags --libs microslip) -lm -o quarter_vehicle
 *   ./quarter_vehicle [tractions.tsv [REFINEMENT]] >quarter_vehicle.tsv */
#include <math.h>
#include <microslip_ellipse.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { X, DIVE, PHI, SIZE };

static const struct microslip_material steel = {80769, 0.3};
static const struct microslip_bodies bodies = {60000, 460, 0,
                                               0,     300, 0.3}; /* N0 [N], R, 0, 0, rail, mu */
static const struct microslip_ellipse_grid grid = {6, 8};

static const double height = 1300, length = 2500;               /* h, l  [mm] */
static const double body = 5.5, wheel = 0.6;                    /* masses  [N s^2/mm] */
static const double pitch_inertia = 2.2e7, wheel_inertia = 6e4; /* [N mm s^2] */
static const double stiffness = 490, damping = 20;              /* k [N/mm], c [N s/mm] */
static const double start = 1000;                               /* speed  [mm/s] */
static const double torque = 0.55 * 0.3 * 60000 * 460; /* T, after it has grown linearly  [N mm] */
static const double grows = 0.2;                       /* [s] */
static const double stands = 0.15;                     /* time after the halt  [s] */
static const double slow = 50;                         /* [mm/s] */
static const double coarse = 0.002, fine = 0.0002; /* steps above this speed, and below it  [s] */
static const double least = 1e-5;                  /* way of a step that rolls  [mm] */
static const double instants[] = {0.5, 0.7548, 0.7614,
                                  0.9}; /* of which tractions are written  [s] */

static const char columns[] =
    "# columns\n"
    "#   t [s]: time, at the end of a step as all but the means\n"
    "#   v [mm/s]: speed of the body\n"
    "#   dive [1]: theta\n"
    "#   turning [1/s]: of the wheel in the brake, phi' - theta'\n"
    "#   q [mm]: way that the contact has rolled\n"
    "#   dq [mm]: of this step, 0 where the bodies are shifted on the spot\n"
    "#   shift [mm]: rigid shift in the step\n"
    "#   force [N]: F on the wheel\n"
    "#   use [1]: of friction, |F| over full sliding\n"
    "#   load [N]: N\n"
    "#   brake [N mm]: B, mean over the step\n"
    "#   slip_share [1]: of the ellipse\n"
    "#   elastic [N mm]: energy of the contact\n"
    "#   contact_loss [N mm]: energy lost in the contact so far\n"
    "#   brake_loss [N mm], damper_loss [N mm]: the same in the brake and the damper\n"
    "#   missing [N mm]: energy less that at the start, and losses\n"
    "t\tv\tdive\tturning\tq\tdq\tshift\tforce\tuse\tload\tbrake\tslip_share\telastic\tcontact_"
    "loss\t"
    "brake_loss\tdamper_loss\tmissing";

struct vehicle {
  microslip_ellipse *ellipse, *twin;
  double masses[SIZE][SIZE], springs[SIZE][SIZE], dampers[SIZE][SIZE];
  double by_way[SIZE], by_shift[SIZE], by_brake[SIZE];
  double full_sliding, refinement;
  double place[SIZE], velocity[SIZE];
  double force, force_before, time, step, rolled, size;
  double slope; /* of the force by the shift, in the last step that rolled */
  int held;
  double contact_loss, brake_loss, damper_loss, elastic, at_start;
};

/* A step that is solved, or a trial of one. */
struct motion {
  double mean[SIZE], dq, shift, force, brake, size, load;
};

static void fail(const char* why) {
  fprintf(stderr, "quarter_vehicle: %s\n", why);
  exit(EXIT_FAILURE);
}

static void check(enum microslip_status status, microslip_ellipse* ellipse) {
  if (status != MICROSLIP_OK) fail(microslip_ellipse_message(ellipse));
}

static double dot(const double a[SIZE], const double b[SIZE]) {
  return a[X] * b[X] + a[DIVE] * b[DIVE] + a[PHI] * b[PHI];
}

/* a.(matrix b) */
static double form(const double a[SIZE], double matrix[SIZE][SIZE], const double b[SIZE]) {
  double sum = 0;
  for (int i = 0; i < SIZE; ++i) sum += a[i] * dot(matrix[i], b);
  return sum;
}

/* Solves symmetric, positive definite equations, by elimination. */
static void solve(double from[SIZE][SIZE], const double right[SIZE], double x[SIZE]) {
  double m[SIZE][SIZE];
  for (int i = 0; i < SIZE; ++i) {
    x[i] = right[i];
    for (int j = 0; j < SIZE; ++j) m[i][j] = from[i][j];
  }
  for (int k = 0; k < SIZE; ++k) {
    for (int i = k + 1; i < SIZE; ++i) {
      const double part = m[i][k] / m[k][k];
      for (int j = k; j < SIZE; ++j) m[i][j] -= part * m[k][j];
      x[i] -= part * x[k];
    }
  }
  for (int i = SIZE - 1; i >= 0; --i) {
    for (int j = i + 1; j < SIZE; ++j) x[i] -= m[i][j] * x[j];
    x[i] /= m[i][i];
  }
}

static double energy_of(struct vehicle* of) {
  check(microslip_ellipse_get_elastic_energy(of->ellipse, &of->elastic), of->ellipse);
  return (form(of->velocity, of->masses, of->velocity) + form(of->place, of->springs, of->place)) /
             2 +
         of->elastic;
}

static struct vehicle vehicle_at_start(double refinement) {
  const double arm = height - bodies.radius_1;
  struct vehicle of = {
      .masses = {{body + wheel, -arm * wheel, 0},
                 {-arm * wheel, pitch_inertia + arm * arm * wheel, 0},
                 {0, 0, wheel_inertia}},
      .springs = {{0}, {0, stiffness * length * length, 0}, {0}},
      .dampers = {{0}, {0, damping * length * length, 0}, {0}},
      .by_way = {1, -arm, 0},
      .by_shift = {1, -arm, -bodies.radius_1},
      .by_brake = {0, 1, -1},
      .refinement = refinement,
      .velocity = {start, 0, start / bodies.radius_1},
      .size = 1,
  };
  struct microslip_ellipse_contact axes;
  struct microslip_ellipse_state state;
  char why[256];
  if (microslip_hertz_ellipse(&steel, &bodies, &axes, why, sizeof why) ||
      microslip_ellipse_create(&steel, &axes, &grid, &of.ellipse, why, sizeof why)) {
    fail(why);
  }
  check(microslip_ellipse_copy(of.ellipse, &of.twin), of.ellipse);
  check(microslip_ellipse_get_state(of.ellipse, &state), of.ellipse);
  of.full_sliding = state.full_sliding;
  of.at_start = energy_of(&of);
  return of;
}

static struct microslip_ellipse_load along(double motion) {
  const struct microslip_ellipse_load load = {{0, 0, 0}, {motion, 0, 0}};
  return load;
}

/* The force to which a shift leads without rolling; the ellipse stays as it is. */
static double force_of_shift(struct vehicle* of, double shift) {
  const struct microslip_ellipse_load load = along(shift);
  struct microslip_ellipse_state state;
  check(microslip_ellipse_assign(of->twin, of->ellipse), of->twin);
  check(microslip_ellipse_shift(of->twin, &load, &state), of->twin);
  return state.resultants[0];
}

/* Force at the end of a step; `slope` becomes its derivative by the shift. */
static double attempt(struct vehicle* of, double dq, double shift) {
  if (dq == 0)
    return force_of_shift(of, shift); /* whose derivative is nearly that of the last step */
  const struct microslip_ellipse_load load = along(shift / dq);
  struct microslip_ellipse_state state;
  double jacobian[9];
  check(microslip_ellipse_attempt(of->ellipse, dq, &load, &state, jacobian), of->ellipse);
  of->slope = jacobian[0] / dq;
  return state.resultants[0];
}

/* Solves for a step at whose end the wheel turns in the brake with the torque `most`, in the given
 * sense, or is held. */
static struct motion solve_step(struct vehicle* of, int held, double most, double sense) {
  const double dt = of->step;
  double matrix[SIZE][SIZE], right[SIZE], free[SIZE], of_force[SIZE], of_brake[SIZE];
  for (int i = 0; i < SIZE; ++i) {
    right[i] = 2 / dt * dot(of->masses[i], of->velocity) - dot(of->springs[i], of->place);
    for (int j = 0; j < SIZE; ++j) {
      matrix[i][j] = 2 / dt * of->masses[i][j] + dt / 2 * of->springs[i][j] + of->dampers[i][j];
    }
  }
  solve(matrix, right, free);
  solve(matrix, of->by_shift, of_force);
  solve(matrix, of->by_brake, of_brake);
  const double mobility = dot(of->by_brake, of_brake);
  double mean_slope = dot(of->by_shift, of_force);
  if (held) mean_slope -= dot(of->by_shift, of_brake) * dot(of->by_brake, of_force) / mobility;

  struct motion found = {.force = 2 * of->force - of->force_before};
  for (int trial = 0; trial < 30; ++trial) {
    const double mean_force = (of->force + found.force) / 2;
    found.brake = sense * most;
    if (held) { /* b.(2 w - u) = 0 */
      found.brake = (dot(of->by_brake, of->velocity) / 2 - dot(of->by_brake, free) -
                     dot(of->by_brake, of_force) * mean_force) /
                    mobility;
    }
    for (int i = 0; i < SIZE; ++i) {
      found.mean[i] = free[i] + of_force[i] * mean_force + of_brake[i] * found.brake;
    }
    found.shift = dt * dot(of->by_shift, found.mean);
    if (trial == 0) {
      found.dq = dot(of->by_way, of->place) + dt * dot(of->by_way, found.mean) - of->rolled;
      if (fabs(found.dq) < least) found.dq = 0;
      const double dive = of->place[DIVE] + dt * found.mean[DIVE];
      const double diving = 2 * found.mean[DIVE] - of->velocity[DIVE];
      const double part = 1 + length * (stiffness * dive + damping * diving) / bodies.normal_load;
      found.load = part * bodies.normal_load;
      found.size = found.dq != 0 ? cbrt(part) : of->size;
      check(
          microslip_ellipse_set_contact(of->ellipse, found.size, part / (found.size * found.size)),
          of->ellipse);
    }
    const double excess = found.force - attempt(of, found.dq, found.shift);
    if (fabs(excess) <= 1e-9 * of->full_sliding) return found;
    found.force -= excess / (1 - of->slope * dt * mean_slope / 2);
  }
  fail("the midpoint rule finds no force");
  return found;
}

static struct motion make_step(struct vehicle* of, struct microslip_ellipse_state* state) {
  of->step = (of->velocity[X] > slow ? coarse : fine) / of->refinement;
  const double most = torque * fmin((of->time + of->step / 2) / grows, 1);
  const double turning = -dot(of->by_brake, of->velocity);
  struct motion found = solve_step(of, of->held, most, copysign(1, turning));
  if (!of->held) {
    const double at_end = -2 * dot(of->by_brake, found.mean) - turning;
    if (at_end * turning <= 0) {
      of->held = 1;
      found = solve_step(of, 1, most, 0);
    }
  }
  if (of->held && fabs(found.brake) > most) {
    of->held = 0;
    found = solve_step(of, 0, most, copysign(1, found.brake));
  }
  const struct microslip_ellipse_load load =
      along(found.dq == 0 ? found.shift : found.shift / found.dq);
  if (found.dq == 0) {
    check(microslip_ellipse_shift(of->ellipse, &load, state), of->ellipse);
    of->contact_loss += state->dissipation;
  } else {
    check(microslip_ellipse_advance(of->ellipse, found.dq, &load, state), of->ellipse);
    of->contact_loss += fabs(found.dq) * state->dissipation;
  }
  of->brake_loss -= found.brake * of->step * dot(of->by_brake, found.mean);
  of->damper_loss += of->step * form(found.mean, of->dampers, found.mean);
  of->rolled += found.dq;
  for (int i = 0; i < SIZE; ++i) {
    of->place[i] += of->step * found.mean[i];
    of->velocity[i] = 2 * found.mean[i] - of->velocity[i];
  }
  of->size = found.size;
  of->force_before = of->force;
  of->force = found.force;
  of->time += of->step;
  return found;
}

/* Frequency of small rocking: the wheel held to the body, on the contact's stiffness in a small shift
 * in which all sticks, as after a turn  [Hz]. */
static double closed_form(struct vehicle* of) {
  const double small = 1e-7, pi = acos(-1.0);
  const double stiff =
      fmax(of->force - force_of_shift(of, small), force_of_shift(of, -small) - of->force) / small;
  const double along = of->masses[X][X], both = of->masses[X][DIVE];
  const double turning = of->masses[DIVE][DIVE] + wheel_inertia;
  /* (1, -h) by the inverse of the masses of x and of the held theta and phi */
  const double mobility =
      (turning + 2 * height * both + height * height * along) / (along * turning - both * both);
  return sqrt(stiff * mobility) / (2 * pi);
}

static void write_tractions(FILE* file, const struct vehicle* of) {
  const size_t size = microslip_ellipse_size(of->ellipse);
  double* values = malloc(6 * size * sizeof *values);
  int* slips = malloc(size * sizeof *slips);
  if (!values || !slips) fail("no memory");
  const struct microslip_ellipse_cells cells = {.x = values,
                                                .y = values + size,
                                                .bound = values + 2 * size,
                                                .traction_x = values + 3 * size,
                                                .traction_y = values + 4 * size,
                                                .slips = slips};
  check(microslip_ellipse_get_cells(of->ellipse, &cells), of->ellipse);
  for (size_t k = 0; k < size; ++k) {
    fprintf(file, "%.4f\t%.6g\t%.6g\t%.6g\t%.6g\t%.6g\t%d\n", of->time, cells.x[k], cells.y[k],
            cells.bound[k], cells.traction_x[k], cells.traction_y[k], slips[k]);
  }
  fputs("\n", file);
  free(values);
  free(slips);
}

/* The result of the run in a few numbers. */
struct result {
  double halt, distance, rolled_back, first_turn, last_turn, use, creepage, missing;
  int turns;
};

static void print_result(const struct result* result, struct vehicle* of) {
  printf("# halt [s] = %.9g\n# distance [mm] = %.9g\n", result->halt, result->distance);
  printf("# rolled_back [mm] = %.9g\n", result->rolled_back);
  printf("# rocking [Hz] = %.9g\n", (result->turns - 1) / (result->last_turn - result->first_turn));
  printf("# closed_form [Hz] = %.9g\n", closed_form(of));
  printf("# most_use [1] = %.9g\n# most_creepage [1] = %.9g\n", result->use, result->creepage);
  printf("# contact_loss [N mm] = %.9g\n", of->contact_loss);
  printf("# brake_loss [N mm] = %.9g\n", of->brake_loss);
  printf("# damper_loss [N mm] = %.9g\n", of->damper_loss);
  printf("# most_missing [1] = %.9g\n", result->missing / of->at_start);
}

int main(int count, char** words) {
  if (count > 1 && words[1][0] == '-') {
    puts("usage: quarter_vehicle [FILE_OF_TRACTIONS [REFINEMENT]]");
    return strcmp(words[1], "--help") != 0;
  }
  struct vehicle of = vehicle_at_start(count > 2 ? strtod(words[2], NULL) : 1);
  struct result result = {.halt = INFINITY};
  FILE* tractions = count > 1 ? fopen(words[1], "w") : NULL;
  if (count > 1 && !tractions) fail("the file of tractions cannot be written");
  if (tractions) fputs("t\tx\ty\tbound\ttraction_x\ttraction_y\tslips\n", tractions);
  puts(columns);
  double force[3] = {0, 0, 0}, most_rolled = 0; /* at the end of the last three steps */
  size_t written = 0;
  for (int steps = 1; of.time < result.halt + stands; ++steps) {
    const double before = of.velocity[X], place = of.place[X];
    struct microslip_ellipse_state state;
    const struct motion now = make_step(&of, &state);
    const double missing =
        energy_of(&of) - of.at_start + of.contact_loss + of.brake_loss + of.damper_loss;
    const double use = fabs(of.force) / state.full_sliding;
    printf("%.9g\t%.9g\t%.9g\t%.9g\t%.9g\t%.9g\t", of.time, of.velocity[X], of.place[DIVE],
           -dot(of.by_brake, of.velocity), of.rolled, now.dq);
    printf("%.9g\t%.9g\t%.9g\t%.9g\t%.9g\t%.9g\t", now.shift, of.force, use, now.load, now.brake,
           state.slip_share);
    printf("%.9g\t%.9g\t%.9g\t%.9g\t%.9g\n", of.elastic, of.contact_loss, of.brake_loss,
           of.damper_loss, missing);

    force[0] = force[1], force[1] = force[2], force[2] = of.force;
    if (result.halt == INFINITY && of.velocity[X] <= 0) {
      const double part = of.step * before / (before - of.velocity[X]);
      result.halt = of.time - of.step + part;
      result.distance = place + before * part / 2;
    }
    if (result.halt < INFINITY && steps > 2 && force[1] < fmin(force[0], force[2])) {
      const double fall = force[1] - force[0], rise = force[2] - force[1]; /* of a parabola */
      result.last_turn = of.time - of.step * (1.5 - fall / (fall - rise));
      if (++result.turns == 1) result.first_turn = result.last_turn;
    }
    if (of.velocity[X] > slow) result.creepage = fmax(result.creepage, now.shift / now.dq);
    result.use = fmax(result.use, use);
    result.missing = fmax(result.missing, fabs(missing));
    most_rolled = fmax(most_rolled, of.rolled);
    if (tractions && written < sizeof instants / sizeof *instants &&
        of.time > instants[written] - of.step / 2) {
      write_tractions(tractions, &of);
      ++written;
    }
  }
  result.rolled_back = most_rolled - of.rolled;
  print_result(&result, &of);
  if (tractions && fclose(tractions)) fail("the file of tractions cannot be written");
  microslip_ellipse_destroy(of.ellipse);
  microslip_ellipse_destroy(of.twin);
  return 0;
}
