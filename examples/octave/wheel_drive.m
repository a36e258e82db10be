% SPDX-License-Identifier: GPL-3.0-or-later
% A wheel that a torque drives and then brakes, coupled to microslip step by step, per mm of width:
%
%   m dv/dt = F,   I domega/dt = T(t) - R F,   F the force of the contact.
%
% Time steps are equal, so dq = v dt is another one in each, from 0.01 to 3.3 elements. The midpoint
% rule: mean velocities over a step move the contact, whose mean force moves the wheel. Its equation
% for the mean force is solved by Newton's method with the derivatives of the step. Then energy is
% balanced to rounding, whatever the steps.
%
%   mkoctfile --mex microslip_mex.c -lmicroslip && octave-cli wheel_drive.m
function wheel_drive()
  steps = 400;
  w = struct('mass', 0.8, ...         % m  [N s^2/mm^2]
             'inertia', 6000, ...     % I  [N s^2]
             'radius', 460, ...       % R  [mm]
             'time_step', 0.001, ...  % [s]
             'velocity', 1, 'spin', 1/460, 'torque', 0);
  most_torque = 0.9;                  % of full sliding times R  [1]
  problem = struct('shear_modulus', 82000, 'poisson_ratio', 0.28, 'half_width', 5, ...
                   'peak_traction', 300, 'kernel', 'strip', 'length', 10, 'elements', 100, ...
                   'scheme', 'remembered');
  rolling = microslip_mex('create', problem);
  full_sliding = microslip_mex('full_sliding', rolling);
  dx = 2 * problem.half_width / problem.elements;
  finish = steps * w.time_step;
  start = kinetic_energy(w);
  force = 0; before = 0; work = 0; dissipated = 0;

  fprintf('# wheel_drive: a wheel that a torque drives and then brakes\n# parameters\n');
  fprintf('#   mass = %g\n#   inertia = %g\n#   radius = %g\n', w.mass, w.inertia, w.radius);
  fprintf('#   time_step = %g\n#   most_torque = %g\n', w.time_step, most_torque);
  fprintf('#   grid.elements = %d\n# columns\n', problem.elements);
  columns = {
    't [s]: time'
    'v [mm/s]: velocity'
    'omega [rad/s]: angular velocity'
    'step_ratio [1]: dq/dx of the step'
    'torque [N]: T, mean over the step'
    'force [N/mm]: F of the contact, mean over the step'
    'creepage [1]: (v - omega R)/v of the step'
    'slip_elements [1]: elements in slip'
    'kinetic [N]: energy of the wheel, per mm of width as all'
    'elastic [N]: of the contact'
    'dissipated [N]: by slip, with mean tractions'
    'work [N]: done by the torque'
    'missing [N]: kinetic less kinetic at the start + elastic + dissipated - work'};
  fprintf('#   %s\n', columns{:});
  names = strtok(columns, ' ');
  fprintf('%s\n', strjoin(names', '\t'));

  for k = 0:steps - 1
    middle = (k + 0.5) * w.time_step;
    w.torque = most_torque * full_sliding * w.radius * sin(2 * pi * middle / finish);
    guess = 2 * force - before;
    before = force;
    force = find_mean_force(rolling, w, guess, full_sliding);
    motion = motion_with(w, force);
    dq = motion.dq;
    microslip_mex('advance', rolling, dq);
    spin_before = w.spin;
    w.velocity = w.velocity + w.time_step * force / w.mass;
    w.spin = w.spin + w.time_step * (w.torque - w.radius * force) / w.inertia;

    state = microslip_mex('state', rolling);
    elastic = microslip_mex('elastic_energy', rolling);
    kinetic = kinetic_energy(w);
    work = work + w.torque * w.time_step * (spin_before + w.spin) / 2;
    dissipated = dissipated + state.dissipation * dq;
    row = [(k + 1) * w.time_step, w.velocity, w.spin, dq / dx, w.torque, force, state.creepage, ...
           state.slip_elements, kinetic, elastic, dissipated, work, ...
           kinetic - start + elastic + dissipated - work];
    fprintf('%.17g\t', row(1:end - 1));
    fprintf('%.17g\n', row(end));
  end
  microslip_mex('destroy', rolling);
end

function energy = kinetic_energy(w)
  energy = (w.mass * w.velocity * w.velocity + w.inertia * w.spin * w.spin) / 2;
end

% Creepage and length of a step with a mean force, each with its derivative by that force.
function motion = motion_with(w, force)
  velocity = w.velocity + w.time_step * force / (2 * w.mass);
  spin = w.spin + w.time_step * (w.torque - w.radius * force) / (2 * w.inertia);
  velocity_slope = w.time_step / (2 * w.mass);
  spin_slope = -w.time_step * w.radius / (2 * w.inertia);
  rolled = w.radius * spin / velocity;
  motion.creepage = 1 - rolled;
  motion.creepage_slope = (rolled * velocity_slope - w.radius * spin_slope) / velocity;
  motion.dq = velocity * w.time_step;
  motion.dq_slope = velocity_slope * w.time_step;
end

% By how much a mean force is above the one to which it leads, and the derivative of that  [N/mm].
function [e, slope] = excess(rolling, w, force)
  motion = motion_with(w, force);
  microslip_mex('set_creepage', rolling, motion.creepage);
  [state, jacobian] = microslip_mex('attempt', rolling, motion.dq);
  slope = 1 - jacobian.by_load.mean_force * motion.creepage_slope ...
            - jacobian.by_length.mean_force * motion.dq_slope;
  e = force - state.mean_force;
end

% The mean force that leads to itself; the step with it is the one tried last.
function force = find_mean_force(rolling, w, force, scale)
  before = Inf;
  for trials = 1:50
    [now, slope] = excess(rolling, w, force);
    accepted = 1e-11;  % or rounding
    if abs(now) < before, accepted = 1e-13; end
    if abs(now) <= accepted * scale, return; end
    before = abs(now);
    force = force - now / slope;
  end
  error('the midpoint rule finds no force');
end
