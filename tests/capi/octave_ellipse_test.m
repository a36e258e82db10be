% SPDX-License-Identifier: GPL-3.0-or-later
% Contact ellipses in Octave, and what they have in common with line contacts: the test of examples/octave.
function octave_ellipse_test()
  bodies = struct('shear_modulus', 80769, 'poisson_ratio', 0.3, 'normal_load', 60000, 'radius_1', 460, ...
                  'lateral_radius_2', 300, 'friction', 0.3, 'rows', 6, 'elements', 8);
  axes = microslip_ellipse_mex('hertz', bodies);
  full = 0.3 * 60000;
  assert(2 / 3 * pi * axes.half_width * axes.lateral_half_width * axes.peak_traction, full, 1e-9 * full);
  by_axes = axes;
  for name = {'shear_modulus', 'poisson_ratio', 'rows', 'elements'}
    by_axes.(name{1}) = bodies.(name{1});
  end

  first = microslip_ellipse_mex('create', bodies);
  second = microslip_ellipse_mex('create', by_axes);
  load = struct('creepage', 5e-4, 'lateral_force', -3000, 'spin', 1e-4);
  [one, slopes] = microslip_ellipse_mex('steady', first, load);
  other = microslip_ellipse_mex('steady', second, load);
  assert(isequal(one, other) && one.lateral_force == -3000 && abs(one.full_sliding - full) < 1e-9 * full);
  % Derivatives are slopes, rows those of resultants.
  step = 1e-7;
  at = struct('creepage', one.creepage, 'lateral_creepage', one.lateral_creepage, 'spin', one.spin);
  more = at;
  more.spin = at.spin + step;
  below = microslip_ellipse_mex('steady', first, at);
  above = microslip_ellipse_mex('steady', first, more);
  found = ([above.force, above.lateral_force, above.spin_moment] - [below.force, below.lateral_force, below.spin_moment])' / step;
  assert(slopes(:, 3), found, 0.02 * max(abs(found)));

  % Attempts leave all as it was; a step after one is that step, and copies go on alike.
  [tried, slopes] = microslip_ellipse_mex('attempt', first, 1, load);
  assert(size(slopes), [3, 3]);
  assert(microslip_ellipse_mex('state', first).distance, 0);
  made = microslip_ellipse_mex('advance', first, 1, load);
  assert(isequal(tried, made) && made.distance == 1);
  copy = microslip_ellipse_mex('copy', first);
  name = tempname();
  microslip_ellipse_mex('save', first, name);
  microslip_ellipse_mex('restore', second, name);
  unlink(name);
  for h = {copy, second}
    microslip_ellipse_mex('set_contact', h{1}, 1.05, 0.9);
  end
  expected = microslip_ellipse_mex('advance', copy, 0.8, load);
  assert(isequal(expected, microslip_ellipse_mex('advance', second, 0.8, load)));
  assert(expected.full_sliding, full * 1.05^2 * 0.9, 1e-6 * full);

  cells = microslip_ellipse_mex('cells', first);
  assert(size(cells.x), [48, 1]);
  assert(cells.slips, double(hypot(cells.slip_x, cells.slip_y) > 0));
  assert(sum(cells.area .* cells.slips) / sum(cells.area), made.slip_share, 1e-9);
  assert(hypot(cells.traction_x, cells.traction_y) <= cells.bound * (1 + 1e-6));
  assert(microslip_ellipse_mex('elastic_energy', first) > 0);
  shifted = microslip_ellipse_mex('shift', first, struct('force', 0));
  assert(shifted.distance, 1);
  assert(abs(shifted.force) < 1e-3);

  expect_error(@() microslip_ellipse_mex('steady', first, struct('force', 1e6)), 'force = 1e.06: expected less than full sliding');
  expect_error(@() microslip_ellipse_mex('steady', first, struct('creepage', 1, 'force', 1)), 'force: expected creepage or force, not both');
  expect_error(@() microslip_ellipse_mex('steady', first, struct('creepege', 1)), 'load: expected no fields but');
  expect_error(@() microslip_ellipse_mex('steady', first), 'expected a load');
  expect_error(@() microslip_ellipse_mex('advance', first, 0, load), 'dq = 0: expected');
  expect_error(@() microslip_ellipse_mex('roll', first), 'expected a command of microslip_ellipse_mex');
  expect_error(@() microslip_ellipse_mex('create', struct('shear_modulus', 1)), 'poisson_ratio: expected in the struct');
  % Neither takes the handle of the other.
  expect_error(@() microslip_mex('state', first), 'expected a handle of a line contact');
  expect_error(@() microslip_ellipse_mex('state', uint64(1)), 'expected a handle of an ellipse');
  for h = {first, second, copy}
    microslip_ellipse_mex('destroy', h{1});
  end
  creep_table_test();
end

function creep_table_test()
  table = microslip_ellipse_mex('open_table', fullfile(fileparts(mfilename('fullpath')), '../../tables/creep_forces.nc'));
  problem = struct('shear_modulus', 82000, 'poisson_ratio', 0.28, 'half_width', 6, 'lateral_half_width', 4.5, ...
                   'peak_traction', 300, 'rows', 12, 'elements', 14);
  motions = [1e-3, 0, 0; 1e-3, -5e-4, 2e-4; 0, 1e-3, -3e-4];
  [forces, slopes] = microslip_ellipse_mex('table_forces', table, problem, motions);
  assert(isequal(forces, microslip_ellipse_mex('table_forces', table, problem, motions)));
  ellipse = microslip_ellipse_mex('create', problem);
  for k = 1:3
    [state, expected] = microslip_ellipse_mex('steady', ellipse, struct('creepage', motions(k, 1), ...
                                              'lateral_creepage', motions(k, 2), 'spin', motions(k, 3)));
    off = abs(forces(k, :) - [state.force, state.lateral_force, state.spin_moment]) ./ [1, 1, sqrt(6 * 4.5)];
    assert(all(off < 0.01 * state.full_sliding));
    assert(slopes(:, :, k), expected, 0.2 * max(abs(expected(:))));
  end
  microslip_ellipse_mex('destroy', ellipse);
  problem.half_width = 56.25;
  expect_error(@() microslip_ellipse_mex('table_forces', table, problem, motions), 'contacts.0.: half_width = 56.25: expected 0.45 to 45');
  expect_error(@() microslip_ellipse_mex('table_forces', table, problem, [1, 2]), 'motions: expected n x 3');
  expect_error(@() microslip_ellipse_mex('table_forces', uint64([1, 1]), problem, motions), 'expected a handle of a table');
  expect_error(@() microslip_ellipse_mex('open_table', '/nowhere'), 'cannot read /nowhere');
  microslip_ellipse_mex('close_table', table);
end

function expect_error(call, pattern)
  message = '';
  try
    call();
  catch problem
    message = problem.message;
  end
  assert(! isempty(regexp(message, pattern)), message);
end
