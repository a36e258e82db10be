// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "instants.hpp"
#include "microslip/rolling/load_history.hpp"
#include "microslip/rolling/schemes.hpp"
#include "microslip/scene/model.hpp"
#include "microslip/scene/scene.hpp"

namespace microslip {

/// \file
/// Warnings about values that are accepted and doubtful. Each does nothing where there is no doubt.

/// \param instead  what is safe for any value
void warn_outside(Scene& scene, const SafeRange& safe, const std::string& key, double value,
                  const std::string& instead);

/// Warns if a difference scheme is loaded so near to full sliding that its stick zone is shorter
/// than six elements: the creepage may then be wrong by more than 10 %, and by up to 40 %.
/// \param instead  what is safe for any value
void warn_near_full_sliding(Scene& scene, const Load& load, const TractionBound& bound,
                            Eigen::Index elements, const std::string& instead);

/// Warns if the distance cuts the last step shorter than the scheme is safe with, under a force:
/// the summary has its creepage. Steps that are all unsafe are warned of by themselves.
void warn_of_short_end(Scene& scene, const TransientScene& read);

/// Warns if the creepages under a force are nothing but rounding.
void warn_of_noise(Scene& scene, Eigen::Index elements, double step_ratio);

/// Warns if contact or resultants bend at rows within a step, which takes them to be linear between its
/// ends. Motions are taken as their exact means.
/// \param rows        distances and contact of load.file
/// \param resultants  at a distance, over what friction carries in the scene's contact
void warn_of_missed_rows(Scene& scene, const RunSteps& steps, const LoadHistory& rows,
                         const std::function<Eigen::Vector3d(double)>& resultants);

/// Warns if the cylinder is none of the two bodies of Hertz's contact.
void warn_of_other_radius(Scene& scene, double radius);

/// Warns if a radius cannot belong to a body with this contact: it is below ten half-widths.
void warn_of_small_radius(Scene& scene, const std::string& key, double radius, double half_width);

/// Warns if the elements of a transient do not resolve a table of the bound: the steady state under
/// the largest load of the run is solved on them, and by inversion.
void warn_of_unresolved_table(Scene& scene, const TransientProblem& problem,
                              const LoadHistory& loads);

/// Warns of the largest creepage in the rows of load.file, see warn_of_large_creepage().
void warn_of_large_creepages(Scene& scene, const LoadHistory& loads, const TractionBound& bound);

/// Warns of a column normal_load that is a hundredth of contact.normal_load or less in all rows in
/// which bodies touch, or a hundred times or more.
void warn_of_other_load(Scene& scene, const std::optional<Eigen::VectorXd>& column);

/// Warns of a run by times on which less than the half-width is rolled.
/// \param velocity    of its rows; none in a run by distances  [mm/s]
/// \param half_width  [mm]
void warn_of_short_way(Scene& scene, const LoadHistory& loads,
                       const std::optional<Eigen::VectorXd>& velocity, double half_width);

/// Warns of bodies that turn and roll on by less than a hundredth of the half-width before they turn
/// again, or end there: places that were measured have noise.
/// \param place       q of its rows; none in a run by times  [mm]
/// \param half_width  [mm]
void warn_of_short_turns(Scene& scene, const std::optional<Eigen::VectorXd>& place,
                         double half_width);

/// Whether the bodies are shifted before they roll.
/// \param stops  of a run, rising
inline bool shifts_first(const std::vector<double>& stops) {
  return !stops.empty() && stops.front() == 0;
}

/// Warns if a force is there at once where the contact starts without tractions.
/// \param first_step  its length  [mm]
void warn_of_sudden_force(Scene& scene, const LoadHistory& loads, double first_step);

}  // namespace microslip
