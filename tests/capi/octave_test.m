% SPDX-License-Identifier: GPL-3.0-or-later
% microslip_mex: steady rolling is Carter's, and many steps in one call are those one by one.
function octave_test()
  problem = struct('shear_modulus', 82000, 'poisson_ratio', 0.28, 'half_width', 5, 'peak_traction', 300, ...
                   'kernel', 'plane', 'length', 100, 'elements', 40);
  full = pi / 2 * 5 * 300;
  force = [-0.1, 0.5, -0.99] * full;
  s = microslip_mex('steady', problem, 'force', force);
  stick = sqrt(1 - abs(force) / full);
  carter = -sign(force) .* (1 - stick) * 2 * (1 - 0.28) / 82000 * 300;
  assert(s.creepage', carter, 1e-9 * max(abs(carter)));
  assert(size(s.traction), [40, 3]);
  assert(sum(s.traction) * 10 / 40, force, 0.01 * full);
  assert(s.status, zeros(3, 1));
  back = microslip_mex('steady', problem, 'creepage', s.creepage);
  assert(back.force', force, 1e-9 * full);
  expect_error(@() microslip_mex('steady', problem, 'force', [0, 1e5]), ...
               'load 2: .*expected an absolute value below full sliding');
  expect_error(@() microslip_mex('steady', problem, 'power', 0), 'expected creepage or force');

  dq = 0.1 + 0.09 * sin(1:30);
  creepage = 1e-3 * cos(1:30);
  together = microslip_mex('create', problem);
  single = microslip_mex('create', problem);
  states = microslip_mex('roll', together, dq, 'creepage', creepage);
  for k = 1:30
    microslip_mex('set_creepage', single, creepage(k));
    microslip_mex('advance', single, dq(k));
    state = microslip_mex('state', single);
    assert([states.force(k), states.dissipation(k), states.slip_elements(k)], ...
           [state.force, state.dissipation, state.slip_elements]);
  end
  microslip_mex('roll', together, dq, 'force', 900 * cos(1:30));
  expect_error(@() microslip_mex('roll', together, [0.1, -1], 'force', [1, 2]), 'step 2: dq = -1: expected');
  expect_error(@() microslip_mex('roll', together, [0.1, 1], 'force', 1), 'as many numbers as dq has');

  % Bodies of different material creep in free rolling, in the direction of beta.
  unlike = problem;
  unlike.friction = 0.3;
  for beta = [0, 0.2, -0.2]
    unlike.dundurs_beta = beta;
    contact = microslip_mex('create', unlike);
    free = microslip_mex('roll', contact, 0.5 * ones(1, 60), 'force', zeros(1, 60));
    final(find([0, 0.2, -0.2] == beta)) = free.creepage(end);
    microslip_mex('destroy', contact);
  end
  assert(abs(final(1)) < 1e-12);
  assert(abs(final(2)) > 1e-6);
  assert(final(3), -final(2), 1e-9 * abs(final(2)));
  expect_error(@() microslip_mex('steady', unlike, 'force', 0), 'dundurs_beta: expected none');

  microslip_mex('destroy', together);
  microslip_mex('destroy', single);
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
