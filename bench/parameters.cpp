// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench.hpp"
#include "microslip/scene/keys.hpp"
#include "microslip/scene/model.hpp"

namespace microslip::bench {

BenchParameters read_bench(Scene& scene) {
  using enum Key::Type;
  constexpr Range sizes{2, Grid::max_elements};
  scene.declare(
      {{"load.force_ratio", number, "1", "force over full sliding, where a force is prescribed",
        inner_fraction},
       {"solve.tolerance", number, "1", "of GMRES alone", range(1e-15, 1)},
       {"sizes.parts", wholes, "1", "N of the parts of a computation", sizes},
       {"sizes.steady", wholes, "1", "N of steady rolling", sizes},
       {"sizes.unknowns", wholes, "1", "of the Chebyshev collocation", sizes},
       {"sizes.step", wholes, "1", "N of one step", sizes},
       {"sizes.rolling", wholes, "1", "N of a transient", sizes},
       {"sizes.ellipse", wholes, "1", "joined rows of an ellipse, and cells of each",
        range(2, 100)},
       {"sizes.memory", wholes, "1", "N whose memory is measured", sizes},
       {"dense.product", whole, "1", "largest N of a product with all entries", sizes},
       {"dense.solve", whole, "1", "of a solution", sizes},
       {"dense.steady", whole, "1", "of steady rolling", sizes},
       {"dense.step", whole, "1", "of one step", sizes},
       {"dense.rolling", whole, "1", "of a transient", sizes},
       {"timing.least_time", number, "s", "a repetition takes so long or longer", above_zero},
       {"timing.repetitions", whole, "1", "the median of these counts", range(1, 100)},
       {"timing.once_from", whole, "1", "N from which there is one repetition", range(0, 1e9)}});
  const Material material = read_material(scene);
  const HertzBound bound = read_hertz_bound(scene);
  const StripKernel strip(material, scene.number("kernel.width"));
  const PlaneKernel plane(material, scene.number("kernel.length"));
  return {.bound = bound,
          .kernels = {{"strip", strip}, {"plane", plane}},
          .force = {-scene.number("load.force_ratio") * bound.total()},
          .creepage = {scene.number("load.creepage")},
          .tolerance = scene.number("solve.tolerance"),
          .parts = scene.wholes("sizes.parts"),
          .steady = scene.wholes("sizes.steady"),
          .unknowns = scene.wholes("sizes.unknowns"),
          .step = scene.wholes("sizes.step"),
          .rolling = scene.wholes("sizes.rolling"),
          .ellipse = scene.wholes("sizes.ellipse"),
          .memory = scene.wholes("sizes.memory"),
          .dense_product = scene.whole("dense.product"),
          .dense_solve = scene.whole("dense.solve"),
          .dense_steady = scene.whole("dense.steady"),
          .dense_step = scene.whole("dense.step"),
          .dense_rolling = scene.whole("dense.rolling"),
          .timing = {.least_time = scene.number("timing.least_time"),
                     .repetitions = static_cast<int>(scene.whole("timing.repetitions")),
                     .once_from = scene.whole("timing.once_from")}};
}

}  // namespace microslip::bench
