// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/experiments/claims.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace microslip::experiments {

std::string verdict_of(bool holds) { return holds ? "reproduced" : "refuted"; }

std::string finding_of(bool holds) { return holds ? "ours" : "refuted"; }

Table claims_table(const std::vector<Claim>& claims) {
  constexpr std::array verdicts = {"reproduced", "corrected", "refuted", "not_comparable", "ours"};
  Table table("claims", "what the thesis says, and what was measured",
              {{"claim", "1", "the thesis's statement"},
               {"section", "1", "where it stands"},
               {"thesis_value", "see unit", "its number; nan if it gives none"},
               {"measured_value", "see unit", "ours"},
               {"unit", "1", "unit of the two"},
               {"verdict", "1",
                "reproduced, corrected, refuted, not_comparable, or ours: not of the thesis"},
               {"note", "1", "what the number is, and under which conditions"},
               {"figure", "1", "name of the figure that shows it, or none"}});
  for (const auto& [claim, section, thesis, measured, unit, verdict, note, figure] : claims) {
    if (std::find(verdicts.begin(), verdicts.end(), verdict) == verdicts.end()) {
      throw std::logic_error("claim '" + claim + "': no such verdict: " + verdict);
    }
    if (figure.empty()) throw std::logic_error("claim '" + claim + "': no figure, not even none");
    table.add({claim, section, thesis, measured, unit, verdict, note, figure});
  }
  return table;
}

}  // namespace microslip::experiments
