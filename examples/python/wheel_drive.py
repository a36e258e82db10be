# SPDX-License-Identifier: GPL-3.0-or-later
"""A wheel that a torque drives and then brakes, coupled to microslip step by step, per mm of width:

  m dv/dt = F,   I domega/dt = T(t) - R F,   F the force of the contact.

Time steps are equal, so dq = v dt is another one in each, from 0.01 to 3.3 elements. The midpoint
rule: mean velocities over a step move the contact, whose mean force moves the wheel. Its equation
for the mean force is solved by Newton's method with the derivatives of the step. Then energy is
balanced to rounding, whatever the steps.

  pip install . && python3 examples/python/wheel_drive.py
"""

import math

import microslip as ms

steps, elements = 400, 100
mass = 0.8  # m  [N s^2/mm^2]
inertia = 6000  # I  [N s^2]
radius = 460  # R  [mm]
time_step = 0.001  # [s]
most_torque = 0.9  # of full sliding times R  [1]
half_width = 5  # a  [mm]

columns = """t [s]: time
v [mm/s]: velocity
omega [rad/s]: angular velocity
step_ratio [1]: dq/dx of the step
torque [N]: T, mean over the step
force [N/mm]: F of the contact, mean over the step
creepage [1]: (v - omega R)/v of the step
slip_elements [1]: elements in slip
kinetic [N]: energy of the wheel, per mm of width as all
elastic [N]: of the contact
dissipated [N]: by slip, with mean tractions
work [N]: done by the torque
missing [N]: kinetic less kinetic at the start + elastic + dissipated - work""".split("\n")


class Wheel:
    def __init__(self, velocity):
        self.velocity, self.spin, self.torque = velocity, velocity / radius, 0.0

    def kinetic(self):
        return (mass * self.velocity * self.velocity + inertia * self.spin * self.spin) / 2


def motion_with(wheel, force):
    """Creepage and length of a step with a mean force, each with its derivative by that force."""
    velocity = wheel.velocity + time_step * force / (2 * mass)
    spin = wheel.spin + time_step * (wheel.torque - radius * force) / (2 * inertia)
    velocity_slope = time_step / (2 * mass)
    spin_slope = -time_step * radius / (2 * inertia)
    rolled = radius * spin / velocity
    return ((1 - rolled, (rolled * velocity_slope - radius * spin_slope) / velocity),
            (velocity * time_step, velocity_slope * time_step))


def excess(rolling, wheel, force):
    """By how much a mean force is above the one to which it leads, and the derivative of that."""
    (creepage, creepage_slope), (dq, dq_slope) = motion_with(wheel, force)
    state, jacobian = rolling.attempt(dq, creepage=creepage, jacobian=True)
    slope = (1 - jacobian.by_load.mean_force * creepage_slope
             - jacobian.by_length.mean_force * dq_slope)
    return force - state.mean_force, slope


def find_mean_force(rolling, wheel, force, scale):
    """The mean force that leads to itself; the step with it is the one tried last."""
    before = math.inf
    for _ in range(50):
        now, slope = excess(rolling, wheel, force)
        accepted = 1e-13 if abs(now) < before else 1e-11  # or rounding
        if abs(now) <= accepted * scale:
            return force
        before = abs(now)
        force -= now / slope
    raise RuntimeError("the midpoint rule finds no force")


rolling = ms.Rolling(material={"shear_modulus": 82000, "poisson_ratio": 0.28},
                     contact={"half_width": half_width, "peak_traction": 300},
                     kernel={"type": "strip", "width": 10}, grid={"elements": elements})
full_sliding = rolling.full_sliding
dx = 2 * half_width / elements
end = steps * time_step
wheel = Wheel(1)
start = wheel.kinetic()
force = force_before = work = dissipated = 0

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
    guess = 2 * force - force_before
    force_before = force
    force = find_mean_force(rolling, wheel, guess, full_sliding)
    _, (dq, _) = motion_with(wheel, force)
    state = rolling.roll(dq)  # under the creepage that was tried last
    spin_before = wheel.spin
    wheel.velocity += time_step * force / mass
    wheel.spin += time_step * (wheel.torque - radius * force) / inertia

    elastic = rolling.elastic_energy
    kinetic = wheel.kinetic()
    work += wheel.torque * time_step * (spin_before + wheel.spin) / 2
    dissipated += state.dissipation * dq
    missing = kinetic - start + elastic + dissipated - work
    row = ((k + 1) * time_step, wheel.velocity, wheel.spin, dq / dx, wheel.torque, force,
           state.creepage, state.slip_elements, kinetic, elastic, dissipated, work, missing)
    print("\t".join(f"{value:.17g}" for value in row))
