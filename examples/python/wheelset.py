# SPDX-License-Identifier: GPL-3.0-or-later
"""A wheelset runs from a straight track through a transition into a curve to the left. Each wheel is a cone, and touches its
rail in an ellipse whose forces are those of steady rolling.

Lateral displacement y (to the left) and yaw psi of the wheelset are relative to the track, of the curvature k; V is its
speed, r the rolling radius, l half the distance of the contacts, and c the cone's slope. With the sign + of the left wheel
and - of the right one, the motions of the contacts are
  xi = -+(l k + l psi'/V + c y/r),  eta = y'/V - psi,  phi = psi'/V + k -+ c/r.
The suspension holds the wheelset to the track:
  m y'' = Fy + Fy - ky y - dy y',   I psi'' = l (Fx_right - Fx_left) + Mz + Mz - kp psi.
The midpoint rule solves for the mean velocities by Newton's method, with the derivatives of the contacts' resultants by
their motions. examples/c/wheelset.c does the same in C.

  pip install . && python3 examples/python/wheelset.py >wheelset.tsv
"""

import numpy as np

import microslip as ms

steps, every = 1500, 15
speed = 20000  # V  [mm/s]
radius = 460  # r  [mm]
half_gauge = 750  # l  [mm]
cone = 0.1  # c  [1]
curvature = 1 / 8e5  # of the curve  [1/mm]
begins, ends = 0.2, 1.2  # of the transition  [s]
inertias = np.array([1.2, 7e5])  # m  [N s^2/mm], I  [N mm s^2]
stiffness = np.array([2000, 2e9])  # ky  [N/mm], kp  [N mm]
damping = np.array([20, 0])  # dy  [N s/mm]
time_step = 0.002  # [s]

wheel_on_rail = {"material": {"shear_modulus": 80769, "poisson_ratio": 0.3},
                 "contact": {"normal_load": 60000, "radius_1": radius, "lateral_radius_2": 300, "friction": 0.3},
                 "grid": {"rows": 6, "elements": 8}}
sides = ((ms.Patch(wheel_on_rail), 1), (ms.Patch(wheel_on_rail), -1))  # left, right

columns = """t [s]: time, in the middle of a step as all
curvature [1/mm]: of the track
y [mm]: lateral displacement, to the left
psi [1]: yaw
force_left [N], force_right [N]: along the rolling, on the wheels
lateral_left [N], lateral_right [N]: across it
use_left [1], use_right [1]: of friction, size of the force over full sliding""".split("\n")
names = "t curvature y psi force_left force_right lateral_left lateral_right use_left use_right".split()


def curvature_at(time):
    return curvature * min(max((time - begins) / (ends - begins), 0), 1)


def answer(place, velocity, k):
    """Forces and moment on the wheelset, and their derivatives by y, psi, y' and psi'; states of the contacts."""
    (y, psi), (dy, dpsi) = place, velocity
    force = -stiffness * place - damping * velocity
    slopes = np.hstack([-np.diag(stiffness), -np.diag(damping)])
    contacts = []
    for patch, s in sides:
        state, by_motion = patch.steady(creepage=-s * (half_gauge * (k + dpsi / speed) + cone * y / radius),
                                        lateral_creepage=dy / speed - psi, spin=dpsi / speed + k - s * cone / radius,
                                        jacobian=True)
        by_state = np.array([[-s * cone / radius, 0, 0, -s * half_gauge / speed], [0, -1, 1 / speed, 0],
                             [0, 0, 0, 1 / speed]])
        acts = np.array([[0, 1, 0], [-s * half_gauge, 0, 1]])  # Fx on the yaw, Fy on y, and Mz on the yaw
        force = force + acts @ [state.force, state.lateral_force, state.spin_moment]
        slopes = slopes + acts @ by_motion @ by_state
        contacts.append(state)
    return force, slopes, contacts


def step(place, velocity, time):
    """Place and velocity after a step, the place in its middle, and the contacts there."""
    half = time_step / 2
    mean = velocity
    for _ in range(20):
        middle = place + half * mean
        force, slopes, contacts = answer(middle, mean, curvature_at(time + half))
        wrong = inertias * (mean - velocity) / half - force
        by = np.linalg.solve(np.diag(inertias / half) - half * slopes[:, :2] - slopes[:, 2:], wrong)
        mean = mean - by
        if abs(by[0]) < 1e-7 and abs(by[1]) < 1e-10:
            break
    return place + time_step * mean, 2 * mean - velocity, middle, contacts


def main():
    print("# columns")
    for column in columns:
        print(f"#   {column}")
    print("\t".join(names))
    place, velocity = np.array([3.0, 0]), np.zeros(2)
    for i in range(steps):
        time = i * time_step
        place, velocity, middle, contacts = step(place, velocity, time)
        if i % every != 0:
            continue
        forces = [f"{state[name]:.9g}" for name in ("force", "lateral_force") for state in contacts]
        uses = [f"{np.hypot(state.force, state.lateral_force) / state.full_sliding:.6g}" for state in contacts]
        time += time_step / 2
        print("\t".join([f"{time:.3f}", f"{curvature_at(time):.6g}", f"{middle[0]:.9g}", f"{middle[1]:.9g}", *forces,
                         *uses]))


main()
