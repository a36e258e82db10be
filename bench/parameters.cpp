// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench.hpp"
#include "microslip/scene/model.hpp"
#include "microslip/support/require.hpp"

namespace microslip::bench {

namespace {

Timing read_timing(Scene& scene) {
  const double least_time = scene.number("timing.least_time");
  require(least_time > 0, "timing.least_time", least_time, "a positive number");
  const Eigen::Index repetitions = scene.whole("timing.repetitions");
  require(repetitions >= 1 && repetitions <= 100, "timing.repetitions",
          static_cast<double>(repetitions), "a number from 1 to 100");
  return {.least_time = least_time,
          .repetitions = static_cast<int>(repetitions),
          .once_from = scene.whole("timing.once_from")};
}

}  // namespace

BenchParameters read_bench(Scene& scene) {
  const Material material = read_material(scene);
  const HertzBound bound = read_hertz_bound(scene);
  const StripKernel strip(material, scene.number("kernel.width"));
  const PlaneKernel plane(material, scene.number("kernel.length"));
  const double part = scene.number("load.part");
  require(part > 0 && part < 1, "load.part", part, "a number in (0, 1)");
  const auto sizes = [&](const char* key) { return scene.wholes(key, 2, Grid::max_elements); };
  return {.bound = bound,
          .kernels = {{"strip", strip}, {"plane", plane}},
          .force = {-part * bound.total()},
          .creepage = {scene.number("load.creepage")},
          .tolerance = scene.number("solve.tolerance"),
          .parts = sizes("sizes.parts"),
          .steady = sizes("sizes.steady"),
          .unknowns = sizes("sizes.unknowns"),
          .step = sizes("sizes.step"),
          .rolling = sizes("sizes.rolling"),
          .memory = sizes("sizes.memory"),
          .dense_product = scene.whole("dense.product"),
          .dense_solve = scene.whole("dense.solve"),
          .dense_steady = scene.whole("dense.steady"),
          .dense_step = scene.whole("dense.step"),
          .dense_rolling = scene.whole("dense.rolling"),
          .timing = read_timing(scene)};
}

}  // namespace microslip::bench
