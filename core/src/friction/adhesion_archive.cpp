// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <stdexcept>
#include <string>

#include "adhesion_system.hpp"
#include "microslip/support/archive.hpp"

namespace microslip {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// Rejects a state that was read, unless the condition holds.
void demand(bool holds, const char* what) {
  if (!holds) throw std::invalid_argument(std::string("state: expected ") + what);
}

bool are_different(std::vector<Index> elements) {
  std::ranges::sort(elements);
  return std::ranges::adjacent_find(elements) == elements.end();
}

}  // namespace

void archive_zones(Archive& archive, std::string_view name, std::vector<Zone>& zones, Index size) {
  std::vector<Index> signs;
  for (const Zone zone : zones) signs.push_back(static_cast<Index>(zone));
  archive.wholes(name, signs, size, -1, 1);
  demand(static_cast<Index>(signs.size()) == size, "a zone for each element");
  zones.clear();
  for (const Index sign : signs) zones.push_back(static_cast<Zone>(sign));
}

void archive_compliant(Archive& archive, std::vector<CompliantElement>& compliant, Index size) {
  std::vector<Index> elements;
  for (const CompliantElement& of : compliant) elements.push_back(of.element);
  archive.wholes("compliant", elements, size, 0, size - 1);
  demand(are_different(elements), "compliant elements that differ");
  compliant.resize(elements.size());
  for (std::size_t k = 0; k < elements.size(); ++k) {
    compliant[k].element = elements[k];
    archive.number("compliance", compliant[k].compliance);
    demand(compliant[k].compliance >= 0, "compliances >= 0");
  }
}

void AdhesionSystem::archive(Archive& archive) {
  const Index n = size();
  archive.flag("force_is_prescribed", force_prescribed_);
  archive_compliant(archive, compliant_, n);
  std::vector<Index> in_adhesion, elements, rounds;
  for (Index i = 0; i < n; ++i) {
    if (is_stuck(i)) in_adhesion.push_back(i);
  }
  // Without a base, the next solve makes new factors, without a border.
  for (const Change& change : changes_) {
    if (base_.empty()) break;
    elements.push_back(change.element);
    rounds.push_back(static_cast<Index>(change.rounds));
  }
  archive.wholes("in_adhesion", in_adhesion, n, 0, n - 1);
  archive.wholes("base", base_, n + 1, 0, n);
  archive.wholes("border", elements, n + 1, 0, n);
  archive.wholes("rounds", rounds, n + 1, 0, n);
  archive.flag("border_is_new", border_is_new_);
  if (archive.reads()) {
    demand(rounds.size() == elements.size(), "rounds for each element of the border");
    std::fill(stuck_.begin(), stuck_.end() - 1, 0);
    for (const Index i : in_adhesion) stuck_[to_size(i)] = 1;
    changes_.clear();
    for (std::size_t k = 0; k < elements.size(); ++k) {
      changes_.push_back({.element = elements[k], .rounds = to_size(rounds[k])});
    }
    factorise_again(elements);
  }
  // Columns solved together and columns solved one by one differ in their last bits.
  const auto border = static_cast<Index>(elements.size());
  for (Index k = 0; k < border; ++k) {
    VectorXd column = columns_.col(k), schur = schur_.col(k).head(border);
    archive.numbers("border_column", column, columns_.rows());
    archive.numbers("schur_column", schur, border);
    columns_.col(k) = column;
    schur_.col(k).head(border) = schur;
  }
  if (!archive.reads() || base_.empty()) return;
  const bool is_new = border_is_new_;
  factorise_schur();
  border_is_new_ = is_new;
}

/// Makes the factors of a base that was read, and room for its border.
void AdhesionSystem::factorise_again(const std::vector<Index>& elements) {
  std::fill(position_.begin(), position_.end(), -1);
  if (base_.empty()) return demand(elements.empty(), "a base for the border");
  const Index n = size();
  demand(std::ranges::is_sorted(base_) && are_different(base_) && base_.back() == n,
         "an ascending base that ends with the rigid slip");
  demand(!force_prescribed_ || base_.size() > 1, "a base with elements that carry the force");
  for (std::size_t k = 0; k < base_.size(); ++k) {
    position_[to_size(base_[k])] = static_cast<Index>(k);
  }
  demand(are_different(elements) && std::ranges::find(elements, n) == elements.end(),
         "elements of the border that differ");
  factorise_base();
  demand(elements.size() <= most_changes(), "fewer elements in the border");
  make_room();
  for (std::size_t k = 0; k < elements.size(); ++k) place_row(static_cast<Index>(k));
}

}  // namespace microslip
