// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "bench.hpp"
#include "microslip/scene/model.hpp"
#include "microslip/support/require.hpp"

namespace microslip::bench {

namespace {

Sizes read_sizes(Scene& scene, const std::string& key) {
  Sizes sizes;
  for (const double size : scene.numbers(key)) {
    require(
        size >= 2 && size <= static_cast<double>(Grid::max_elements) && std::floor(size) == size,
        key, size, "whole numbers from 2 to 4e6");
    sizes.push_back(static_cast<Eigen::Index>(size));
  }
  return sizes;
}

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
  return {.bound = bound,
          .kernels = {{"strip", strip}, {"plane", plane}},
          .force = {-part * bound.total()},
          .creepage = {scene.number("load.creepage")},
          .tolerance = scene.number("solve.tolerance"),
          .parts = read_sizes(scene, "sizes.parts"),
          .steady = read_sizes(scene, "sizes.steady"),
          .points = read_sizes(scene, "sizes.points"),
          .unknowns = read_sizes(scene, "sizes.unknowns"),
          .step = read_sizes(scene, "sizes.step"),
          .rolling = read_sizes(scene, "sizes.rolling"),
          .memory = read_sizes(scene, "sizes.memory"),
          .dense_product = scene.whole("dense.product"),
          .dense_solve = scene.whole("dense.solve"),
          .dense_steady = scene.whole("dense.steady"),
          .dense_step = scene.whole("dense.step"),
          .dense_rolling = scene.whole("dense.rolling"),
          .timing = read_timing(scene)};
}

}  // namespace microslip::bench
