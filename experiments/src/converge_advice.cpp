// SPDX-License-Identifier: GPL-3.0-or-later
#include "converge_advice.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "microslip/support/format.hpp"

namespace microslip::experiments {

namespace {

/// Writes a time with two digits: "180 us".
std::string duration(double seconds) {
  const auto [unit, name] = seconds >= 1      ? std::pair(1.0, "s")
                            : seconds >= 1e-3 ? std::pair(1e-3, "ms")
                                              : std::pair(1e-6, "us");
  const double value = seconds / unit;
  return value < 10 ? fmt::format("{} {}", format_roughly(value), name)
                    : fmt::format("{} {}", std::lround(value), name);
}

std::string named(const Candidate& one) {
  constexpr double nothing_but_rounding = 1e-9;
  std::string by = one.scheme == "rows" ? "" : one.scheme + " with";
  if (one.rows > 0) by += fmt::format("{}grid.rows {} and", by.empty() ? "" : " ", one.rows);
  return fmt::format("{} grid.elements {} (error {})", by, one.elements,
                     one.error < nothing_but_rounding ? "below 1e-9" : format_roughly(one.error));
}

std::string cost(const Candidate& one, bool steady) {
  const std::string time = duration(one.time);
  return steady ? time : fmt::format("{}, {} a step", time, duration(one.time / one.steps));
}

struct Accurate {
  std::vector<Candidate> found;   ///< each accurate scheme with its least N; the cheapest first
  std::vector<Candidate> others;  ///< schemes that are not as accurate, with their largest N
};

/// Finds the least N of each scheme from which on all errors are at most `error`.
Accurate accurate(const std::vector<Candidate>& candidates, double error) {
  Accurate all;
  for (auto of = candidates.begin(); of != candidates.end();) {
    const auto end = std::find_if(of, candidates.end(),
                                  [&](const Candidate& one) { return one.scheme != of->scheme; });
    auto first = end;
    while (first != of && std::prev(first)->error <= error) --first;
    if (first != end) {
      all.found.push_back(*first);
    } else {
      all.others.push_back(*std::prev(end));
    }
    of = end;
  }
  std::ranges::sort(all.found, {}, &Candidate::time);
  return all;
}

std::string for_error(const std::vector<Candidate>& candidates, const Wanted& wanted) {
  const std::string wish =
      fmt::format("for an error of {} in the {}: ", format_short(wanted.error), wanted.quantity);
  if (candidates.empty()) return wish + "no scheme solves this scene";
  if (wanted.reference_error > wanted.error / 3) {
    return fmt::format("{}the reference itself may be {} off, more elements are needed", wish,
                       format_roughly(wanted.reference_error));
  }
  const auto& [found, others] = accurate(candidates, wanted.error);
  if (found.empty()) {
    return fmt::format("{}none; the best is {}", wish,
                       named(*std::ranges::min_element(others, {}, &Candidate::error)));
  }
  std::string text =
      fmt::format("{}{}, {}", wish, named(found.front()), cost(found.front(), wanted.steady));
  for (std::size_t k = 1; k < found.size(); ++k) {
    text += fmt::format("{}{}, {}", k == 1 ? "; then " : ", ", named(found[k]),
                        duration(found[k].time));
  }
  for (std::size_t k = 0; k < others.size(); ++k) {
    text += (k == 0 ? "; not by " : ", ") + others[k].scheme;
  }
  return text;
}

std::string for_time(const std::vector<Candidate>& candidates, double step_time) {
  const std::string wish = fmt::format("within {} a step: ", duration(step_time));
  const Candidate* best = nullptr;
  for (const Candidate& one : candidates) {
    if (one.longest_step <= step_time && (best == nullptr || one.error < best->error)) best = &one;
  }
  if (best == nullptr) return wish + "none of these";
  return fmt::format("{}{}, {} on average, the longest {}", wish, named(*best),
                     duration(best->time / best->steps), duration(best->longest_step));
}

}  // namespace

Table advice(const std::vector<Candidate>& candidates, const Wanted& wanted) {
  Table table("advice_timing", "what to take, by the times measured here",
              {{"advice", "1", "a line of text"}});
  table.add({for_error(candidates, wanted)});
  if (wanted.step_time) table.add({for_time(candidates, *wanted.step_time)});
  return table;
}

}  // namespace microslip::experiments
