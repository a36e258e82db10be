# SPDX-License-Identifier: GPL-3.0-or-later
"""A wheel that a torque drives and then brakes, coupled to microslip step by step, per mm of width:

  m dv/dt = F,   I domega/dt = T(t) - R F,   F the force of the contact.

Time steps are equal, so dq = v dt is another one in each, from 0.01 to 3.3 elements. The midpoint
rule: mean velocities over a step move the contact, whose mean force moves the wheel. Its equation
for the mean force is solved by secants. Then energy is balanced to rounding, whatever the steps.

  MICROSLIP_LIBRARY=lib/libmicroslip.so python3 wheel_drive.py
"""

import math

import microslip

steps, elements = 400, 100
mass = 0.8  # m  [N s^2/mm^2]
inertia = 6000  # I  [N s^2]
radius = 460  # R  [mm]
time_step = 0.001  # [s]
most_torque = 0.9  # of full sliding times R  [1]
contact = microslip.Contact(half_width=5, peak_traction=300)

columns = """t [s]: time
v [mm/s]: velocity
omega [1/s]: angular velocity
step_ratio [1]: dq/dx of the step
torque [N]: T, mean over the step
force [N/mm]: F of the contact, mean over the step
creepage [1]: (v - omega R)/v of the step
slip_elements [1]: elements in slip
kinetic [N]: energy of the wheel, per mm of width as all
elastic [N]: of the contact
dissipated [N]: by slip, with mean tractions
work [N]: done by the torque
missing [N]: kinetic less that of the start + elastic + dissipated - work""".split("\n")


class Wheel:
    def __init__(self, velocity):
        self.velocity, self.spin, self.torque = velocity, velocity / radius, 0.0

    def kinetic(self):
        return (mass * self.velocity * self.velocity + inertia * self.spin * self.spin) / 2


def set_motion(rolling, wheel, force):
    """Sets the creepage of a step with a mean force; returns how far it rolls  [mm]."""
    velocity = wheel.velocity + time_step * force / (2 * mass)
    spin = wheel.spin + time_step * (wheel.torque - radius * force) / (2 * inertia)
    rolling.set_creepage((velocity - radius * spin) / velocity)
    return velocity * time_step


def find_mean_force(rolling, wheel, guess, scale):
    """The mean force that leads to itself. The excess over what it leads to grows at least as fast."""

    def excess(force):
        return force - rolling.attempt(set_motion(rolling, wheel, force)).mean_force

    before, excess_before = guess, excess(guess)
    force, slope = before - excess_before, 1
    for _ in range(100):
        now = excess(force)
        accepted = 1e-15 if abs(now) < abs(excess_before) else 1e-11  # or rounding
        if abs(now) <= accepted * scale:
            return force
        if now != excess_before:
            slope = max(1, (now - excess_before) / (force - before))
        before, excess_before = force, now
        force -= now / slope
    raise RuntimeError("the midpoint rule finds no force")


rolling = microslip.Rolling(microslip.Material(82000, 0.28), contact,
                            microslip.Kernel(microslip.Kernel.STRIP, 10), microslip.Grid(elements))
full_sliding = rolling.full_sliding
dx = 2 * contact.half_width / elements
end = steps * time_step
wheel = Wheel(1)
start = wheel.kinetic()
force = work = dissipated = 0

print("# wheel_drive: a wheel that a torque drives and then brakes\n# parameters")
for name in ("mass", "inertia", "radius", "time_step", "most_torque"):
    print(f"#   {name} = {globals()[name]:g}")
print(f"#   grid.elements = {elements}\n# columns")
for column in columns:
    print("#   " + column)
print("\t".join(column.split(" ")[0] for column in columns))

for k in range(steps):
    middle = (k + 0.5) * time_step
    wheel.torque = most_torque * full_sliding * radius * math.sin(2 * math.pi * middle / end)
    force = find_mean_force(rolling, wheel, force, full_sliding)
    dq = set_motion(rolling, wheel, force)
    rolling.advance(dq)
    spin_before = wheel.spin
    wheel.velocity += time_step * force / mass
    wheel.spin += time_step * (wheel.torque - radius * force) / inertia

    state = rolling.state
    elastic = rolling.elastic_energy
    kinetic = wheel.kinetic()
    work += wheel.torque * time_step * (spin_before + wheel.spin) / 2
    dissipated += state.dissipation * dq
    missing = kinetic - start + elastic + dissipated - work
    row = ((k + 1) * time_step, wheel.velocity, wheel.spin, dq / dx, wheel.torque, force,
           state.creepage, state.slip_elements, kinetic, elastic, dissipated, work, missing)
    print("\t".join(f"{value:.17g}" for value in row))
