% SPDX-License-Identifier: GPL-3.0-or-later
% A wheelset runs from a straight track through a transition into a curve to the left. Each wheel is a
% cone, and touches its rail in an ellipse whose forces are those of steady rolling.
%
% Lateral displacement y (to the left) and yaw psi of the wheelset are relative to the track, of the
% curvature k; V is its speed, r the rolling radius, l half the distance of the contacts, and c the
% cone's slope. With the sign + of the left wheel and - of the right one, the motions of the contacts are
%   xi = -+(l k + l psi'/V + c y/r),  eta = y'/V - psi,  phi = psi'/V + k -+ c/r.
% The suspension holds the wheelset to the track:
%   m y'' = Fy + Fy - ky y - dy y',   I psi'' = l (Fx_right - Fx_left) + Mz + Mz - kp psi.
% The midpoint rule solves for the mean velocities by Newton's method, with the derivatives of the
% contacts' resultants by their motions. examples/c/wheelset.c does the same in C.
%
%   mkoctfile --mex microslip_ellipse_mex.c -lmicroslip && octave-cli wheelset.m
function wheelset()
  steps = 1500; every = 15;
  w = struct('speed', 20000, ...                  % V  [mm/s]
             'radius', 460, ...                   % r  [mm]
             'half_gauge', 750, ...               % l  [mm]
             'cone', 0.1, ...                     % c  [1]
             'curvature', 1/8e5, ...              % of the curve  [1/mm]
             'begins', 0.2, 'ends', 1.2, ...      % of the transition  [s]
             'inertias', [1.2; 7e5], ...          % m  [N s^2/mm], I  [N mm s^2]
             'stiffness', [2000; 2e9], ...        % ky  [N/mm], kp  [N mm]
             'damping', [20; 0], ...              % dy  [N s/mm]
             'time_step', 0.002);                 % [s]
  wheel_on_rail = struct('shear_modulus', 80769, 'poisson_ratio', 0.3, 'normal_load', 60000, ...
                         'radius_1', w.radius, 'lateral_radius_2', 300, 'friction', 0.3, ...
                         'rows', 6, 'elements', 8);
  w.ellipses = {microslip_ellipse_mex('create', wheel_on_rail), ...
                microslip_ellipse_mex('create', wheel_on_rail)};  % left, right

  columns = {
    't [s]: time, in the middle of a step as all'
    'curvature [1/mm]: of the track'
    'y [mm]: lateral displacement, to the left'
    'psi [1]: yaw'
    'force_left [N], force_right [N]: along the rolling, on the wheels'
    'lateral_left [N], lateral_right [N]: across it'
    'use_left [1], use_right [1]: of friction, size of the force over full sliding'};
  fprintf('# columns\n');
  fprintf('#   %s\n', columns{:});
  names = {'t', 'curvature', 'y', 'psi', 'force_left', 'force_right', 'lateral_left', ...
           'lateral_right', 'use_left', 'use_right'};
  fprintf('%s\n', strjoin(names, "\t"));

  place = [3; 0];
  velocity = [0; 0];
  for i = 0:steps - 1
    time = i * w.time_step;
    [place, velocity, middle, left, right] = make_step(w, place, velocity, time);
    if mod(i, every) ~= 0, continue; end
    time = time + w.time_step / 2;
    fprintf('%.3f\t%.6g\t%.9g\t%.9g\t%.9g\t%.9g\t%.9g\t%.9g\t%.6g\t%.6g\n', time, ...
            curvature_at(w, time), middle(1), middle(2), left.force, right.force, ...
            left.lateral_force, right.lateral_force, ...
            hypot(left.force, left.lateral_force) / left.full_sliding, ...
            hypot(right.force, right.lateral_force) / right.full_sliding);
  end
  for side = 1:2, microslip_ellipse_mex('destroy', w.ellipses{side}); end
end

function k = curvature_at(w, time)
  k = w.curvature * min(max((time - w.begins) / (w.ends - w.begins), 0), 1);
end

% Forces and moment on the wheelset, and their derivatives by y, psi, y' and psi'; states of the contacts.
function [force, slopes, contacts] = answer(w, place, velocity, k)
  force = -w.stiffness .* place - w.damping .* velocity;
  slopes = [-diag(w.stiffness), -diag(w.damping)];
  contacts = cell(1, 2);
  for side = 1:2
    s = 3 - 2 * side;  % + of the left one
    load = struct('creepage', -s * (w.half_gauge * (k + velocity(2) / w.speed) + w.cone * place(1) / w.radius), ...
                  'lateral_creepage', velocity(1) / w.speed - place(2), ...
                  'spin', velocity(2) / w.speed + k - s * w.cone / w.radius);
    [state, by_motion] = microslip_ellipse_mex('steady', w.ellipses{side}, load);
    by_state = [-s * w.cone / w.radius, 0, 0, -s * w.half_gauge / w.speed
                0, -1, 1 / w.speed, 0
                0, 0, 0, 1 / w.speed];
    acts = [0, 1, 0; -s * w.half_gauge, 0, 1];  % Fx on the yaw, Fy on y, and Mz on the yaw
    force = force + acts * [state.force; state.lateral_force; state.spin_moment];
    slopes = slopes + acts * by_motion * by_state;
    contacts{side} = state;
  end
end

% Place and velocity after a step, the place in its middle, and the contacts there.
function [place, velocity, middle, left, right] = make_step(w, place, velocity, time)
  half = w.time_step / 2;
  average = velocity;
  for trial = 1:20
    middle = place + half * average;
    [force, slopes, contacts] = answer(w, middle, average, curvature_at(w, time + half));
    wrong = w.inertias .* (average - velocity) / half - force;
    by = (diag(w.inertias / half) - half * slopes(:, 1:2) - slopes(:, 3:4)) \ wrong;
    average = average - by;
    if abs(by(1)) < 1e-7 && abs(by(2)) < 1e-10, break; end
  end
  place = place + w.time_step * average;
  velocity = 2 * average - velocity;
  [left, right] = contacts{:};
end
