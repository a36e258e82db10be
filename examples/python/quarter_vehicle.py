# SPDX-License-Identifier: GPL-3.0-or-later
"""A quarter of a wagon brakes to a halt and stands. Its wheel touches the rail in an ellipse that remembers.

The body moves by x and dives by the angle theta about its centre of mass at the height h; at the distance l ahead of
it a spring and a damper stand on the wheel, which the body guides along, and which turns by the angle phi. The other
end of the wagon does the mirror image. With the radius R of the wheel and the force F of the contact,
  wheel's way q = x - (h - R) theta,   rigid shift s = q - R phi,   load N = N0 + l (k theta + c theta'),
  M u' = -K p - D u + F g + B b,   p = (x, theta, phi),  u = p',  g = ds/dp,  b = (0, 1, -1).
The brake acts between body and wheel, by Coulomb's law: the torque B is T(t) while the wheel turns in it; if the wheel
stops, the brake holds it to the body with any torque up to T. The body then swings back, rolls back with the held wheel,
and rocks on the stiffness of the contact.

The midpoint rule has the mean velocity w over a step, with the mean of F at both ends, which Newton's method finds with the
derivative of the contact's step. The wheel stops at the end of a step. So energy is balanced to rounding, but for
shifts and turns. The way dq of the contact is extrapolated, and the next step makes up for what it misses. Where |dq|
is too small to roll, the bodies are shifted on the spot; then the ellipse keeps its size, and its bound alone follows the
load. examples/c/quarter_vehicle.c does the same in C.

  pip install . && python3 examples/python/quarter_vehicle.py [tractions.tsv [REFINEMENT]] >quarter_vehicle.tsv
"""

import math
import sys
import warnings

import numpy as np

import microslip as ms

friction, load = 0.3, 60000  # of the rail [1], N0 [N]
radius, height, length = 460, 1300, 2500  # R, h, l  [mm]
body, wheel = 5.5, 0.6  # masses  [N s^2/mm]
pitch_inertia, wheel_inertia = 2.2e7, 6e4  # [N mm s^2]
stiffness, damping = 490, 20  # k [N/mm], c [N s/mm]
start = 1000  # speed  [mm/s]
torque = 0.55 * friction * load * radius  # T, after it has grown linearly  [N mm]
grows = 0.2  # [s]
stands = 0.15  # time after the halt  [s]
slow = 50  # [mm/s]
coarse, fine = 0.002, 0.0002  # steps above this speed, and below it  [s]
least = 1e-5  # way of a step that rolls  [mm]
instants = (0.5, 0.7548, 0.7614, 0.9)  # of which the tractions are written  [s]

wheel_on_rail = {"material": {"shear_modulus": 80769, "poisson_ratio": 0.3},
                 "contact": {"normal_load": load, "radius_1": radius, "lateral_radius_2": 300, "friction": friction},
                 "grid": {"rows": 6, "elements": 8}}

arm = height - radius
by_way = np.array([1.0, -arm, 0])
by_shift = np.array([1.0, -arm, -radius])  # g
by_brake = np.array([0, 1.0, -1])  # b
masses = np.array([[body + wheel, -arm * wheel, 0], [-arm * wheel, pitch_inertia + arm**2 * wheel, 0],
                   [0, 0, wheel_inertia]])
springs = np.diag([0, stiffness * length**2, 0])
dampers = np.diag([0, damping * length**2, 0])

columns = """t [s]: time, at the end of a step as all but the means
v [mm/s]: speed of the body
dive [1]: theta
turning [1/s]: of the wheel in the brake, phi' - theta'
q [mm]: way that the contact has rolled
dq [mm]: of this step, 0 where the bodies are shifted on the spot
shift [mm]: rigid shift in the step
force [N]: F on the wheel
use [1]: of friction, |F| over full sliding
load [N]: N
brake [N mm]: B, mean over the step
slip_share [1]: of the ellipse
elastic [N mm]: energy of the contact
contact_loss [N mm]: energy lost in the contact so far
brake_loss [N mm], damper_loss [N mm]: the same in the brake and the damper
missing [N mm]: energy less that at the start, and losses""".split("\n")
names = ("t v dive turning q dq shift force use load brake slip_share elastic contact_loss brake_loss damper_loss "
         "missing").split()


class Vehicle:
    def __init__(self, refinement):
        self.patch = ms.Patch(wheel_on_rail)
        self.full_sliding = self.patch.state.full_sliding
        self.refinement = refinement
        self.place, self.velocity = np.zeros(3), np.array([start, 0, start / radius])
        self.force = self.force_before = 0.0
        self.time, self.rolled, self.size = 0.0, 0.0, 1.0
        self.held = False
        self.contact_loss = self.brake_loss = self.damper_loss = 0.0
        self.slope = 0.0  # of the force by the shift, in the last step that rolled
        self.at_start = self.energy()

    def energy(self):
        return ((self.velocity @ masses @ self.velocity + self.place @ springs @ self.place) / 2
                + self.patch.elastic_energy)

    def attempt(self, dq, shift):
        """Force at the end of a step, and its derivative by the shift."""
        if dq == 0:  # whose derivative is nearly that of the last step
            return self.patch.copy().shift(shift=shift).force, self.slope
        state, jacobian = self.patch.attempt(dq, creepage=shift / dq, jacobian=True)
        self.slope = jacobian[0, 0] / dq
        return state.force, self.slope

    def solve(self, held, most, sense):
        """Mean velocity over a step, way, shift, force at the end, and torque of the brake.

        held   whether the wheel does not turn in the brake at the end
        most   T; sense is its sign where the wheel turns
        """
        dt = self.dt
        matrix = 2 / dt * masses + dt / 2 * springs + dampers
        free = np.linalg.solve(matrix, 2 / dt * masses @ self.velocity - springs @ self.place)
        of_force, of_brake = np.linalg.solve(matrix, by_shift), np.linalg.solve(matrix, by_brake)

        def motion(mean_force):
            brake = sense * most
            if held:  # b.(2 w - u) = 0
                brake = (by_brake @ (self.velocity / 2 - free - of_force * mean_force)) / (by_brake @ of_brake)
            return free + of_force * mean_force + of_brake * brake, brake

        mean_slope = by_shift @ of_force
        if held:
            mean_slope -= (by_shift @ of_brake) * (by_brake @ of_force) / (by_brake @ of_brake)
        force = 2 * self.force - self.force_before
        mean, _ = motion((self.force + force) / 2)
        dq = by_way @ (self.place + dt * mean) - self.rolled
        dive, diving = self.place[1] + dt * mean[1], 2 * mean[1] - self.velocity[1]
        part = 1 + length * (stiffness * dive + damping * diving) / load
        if abs(dq) < least:
            dq = 0
        size = self.size if dq == 0 else part ** (1 / 3)
        self.patch.set_contact(size, part / size**2)
        for _ in range(30):
            mean, brake = motion((self.force + force) / 2)
            shift = dt * by_shift @ mean
            found, slope = self.attempt(dq, shift)
            excess = force - found
            if abs(excess) <= 1e-9 * self.full_sliding:
                return mean, dq, shift, force, brake, size, part * load
            force -= excess / (1 - slope * dt * mean_slope / 2)
        raise RuntimeError("the midpoint rule finds no force")

    def step(self):
        """Makes a step, and returns a row of the table."""
        self.dt = (coarse if self.velocity[0] > slow else fine) / self.refinement
        most = torque * min((self.time + self.dt / 2) / grows, 1)
        turning = -by_brake @ self.velocity
        found = self.solve(self.held, most, math.copysign(1, turning))
        if not self.held and -by_brake @ (2 * found[0] - self.velocity) * turning <= 0:
            self.held = True
            found = self.solve(True, most, 0)
        if self.held and abs(found[4]) > most:
            self.held = False
            found = self.solve(False, most, math.copysign(1, found[4]))
        mean, dq, shift, force, brake, self.size, normal = found
        if dq == 0:
            state = self.patch.shift(shift=shift)
            self.contact_loss += state.dissipation
        else:
            state = self.patch.roll(dq, creepage=shift / dq)
            self.contact_loss += abs(dq) * state.dissipation
        self.brake_loss -= brake * self.dt * by_brake @ mean
        self.damper_loss += self.dt * mean @ dampers @ mean
        self.rolled += dq
        self.place = self.place + self.dt * mean
        self.velocity = 2 * mean - self.velocity
        self.force_before, self.force = self.force, force
        self.time += self.dt
        missing = self.energy() - self.at_start + self.contact_loss + self.brake_loss + self.damper_loss
        return (self.time, self.velocity[0], self.place[1], -by_brake @ self.velocity, self.rolled, dq, shift, force,
                abs(force) / state.full_sliding, normal, brake, state.slip_share, self.patch.elastic_energy,
                self.contact_loss, self.brake_loss, self.damper_loss, missing)

    def closed_form(self):
        """Frequency of small rocking: the wheel held to the body, on the contact's stiffness in a small shift in which
        all sticks, as after a turn  [Hz]."""
        small = 1e-7
        stiff = max(sign * (self.force - self.patch.copy().shift(shift=sign * small).force) for sign in (1, -1)) / small
        held = masses[:2, :2] + np.diag([0, wheel_inertia])
        mobility = np.array([1, -height]) @ np.linalg.solve(held, np.array([1, -height]))
        return math.sqrt(stiff * mobility) / (2 * math.pi)


def write_tractions(file, vehicle):
    patch = vehicle.patch
    for x, y, bound, traction, slips in zip(*(field.reshape(-1, *field.shape[2:]) for field in (
            patch.x, patch.y, patch.bound, patch.traction, patch.slips))):
        print(f"{vehicle.time:.4f}", *(f"{value:.6g}" for value in (x, y, bound, *traction)), int(slips), sep="\t",
              file=file)
    print(file=file)


def main():
    if sys.argv[1:2] and sys.argv[1].startswith("-"):
        print("usage: quarter_vehicle.py [FILE_OF_TRACTIONS [REFINEMENT]]")
        sys.exit(sys.argv[1] != "--help")
    warnings.simplefilter("ignore", ms.LoadWarning)  # the creepage of a wheel that does not turn is 1
    vehicle = Vehicle(float(sys.argv[2]) if len(sys.argv) > 2 else 1)
    tractions = open(sys.argv[1], "w", encoding="ascii") if len(sys.argv) > 1 else None
    if tractions:
        print("t\tx\ty\tbound\ttraction_x\ttraction_y\tslips", file=tractions)
    print("# columns")
    for column in columns:
        print(f"#   {column}")
    print("\t".join(names))
    halt = distance = None
    turns, written, most_use, most_missing, least_rolled = [], 0, 0.0, 0.0, math.inf
    most_creepage = most_rolled = 0.0
    rows = []
    while halt is None or vehicle.time < halt + stands:
        before, place = vehicle.velocity[0], vehicle.place[0]
        rows.append(dict(zip(names, vehicle.step())))
        now = rows[-1]
        print("\t".join(f"{value:.9g}" for value in now.values()))
        if halt is None and now["v"] <= 0:
            part = vehicle.dt * before / (before - now["v"])
            halt, distance = now["t"] - vehicle.dt + part, place + before * part / 2
        if halt is not None and len(rows) > 2 and (  # a least force, by a parabola
                rows[-2]["force"] < min(rows[-3]["force"], now["force"])):
            fall, rise = rows[-2]["force"] - rows[-3]["force"], now["force"] - rows[-2]["force"]
            turns.append(now["t"] - vehicle.dt * (1.5 - fall / (fall - rise)))
        if now["v"] > slow:
            most_creepage = max(most_creepage, now["shift"] / now["dq"])
        most_use = max(most_use, now["use"])
        most_missing = max(most_missing, abs(now["missing"]))
        most_rolled = max(most_rolled, now["q"])
        if tractions and written < len(instants) and now["t"] > instants[written] - vehicle.dt / 2:
            write_tractions(tractions, vehicle)
            written += 1
    for name, value in (
            ("halt [s]", halt), ("distance [mm]", distance), ("rolled_back [mm]", most_rolled - vehicle.rolled),
            ("rocking [Hz]", (len(turns) - 1) / (turns[-1] - turns[0])), ("closed_form [Hz]", vehicle.closed_form()),
            ("most_use [1]", most_use), ("most_creepage [1]", most_creepage),
            ("contact_loss [N mm]", vehicle.contact_loss), ("brake_loss [N mm]", vehicle.brake_loss),
            ("damper_loss [N mm]", vehicle.damper_loss), ("most_missing [1]", most_missing / vehicle.at_start)):
        print(f"# {name} = {value:.9g}")


main()
