// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes of the cases of an input file of CONTACT.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <sstream>
#include <stdexcept>

#include "input_problem.hpp"
#include "microslip/patch/patch_grid.hpp"
#include "microslip/scene/contact_input.hpp"
#include "microslip/scene/model.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/require.hpp"
#include "microslip/support/shown.hpp"

namespace microslip {

namespace {

using Kind = InputProblem::Kind;

/// A component's keys: of the load, then of a shift.
struct ComponentKeys {
  const char *motion, *ratio, *shift, *force;
};

constexpr std::array<ComponentKeys, 3> component_keys{
    {{"creepage", "force_ratio", "shift", "force"},
     {"lateral_creepage", "lateral_force_ratio", "lateral_shift", "lateral_force"},
     {"spin", "", "rotation", ""}}};

/// A scene that is being written.
class SceneText {
 public:
  void begin(const char* section) { text_ += fmt::format("\n{} {{\n", section); }
  void end() { text_ += "}\n"; }
  void comment(const std::string& line) { text_ += "; " + line + "\n"; }
  void key(const char* name, const std::string& value) {
    text_ += fmt::format("  {} {}\n", name, value);
  }
  void key(const char* name, double value) { key(name, format_short(value)); }
  void top(const char* name, const char* value) { text_ += fmt::format("\n{} {}\n", name, value); }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// Writes the scene of a problem.
class InputSceneWriter {
 public:
  InputSceneWriter(const InputProblem& problem, const std::string& file, bool direct)
      : problem_(problem), contact_(problem.contact), file_(file), direct_(direct) {
    set_grid();
  }

  ImportedScene scene() {
    const bool steps = problem_.kind != Kind::steady || rolls_until_steady();
    write_head();
    out_.top("problem", steps ? "transient" : "steady");
    write_contact();
    if (elements_ > 0) write_grid();
    if (!steps && direct_) out_.top("leading_edge", "standard");
    write_load();
    if (steps) {
      write_start();
      write_steps();
    } else if (direct_) {
      out_.begin("step");
      out_.key("ratio", 1);
      out_.end();
    }
    return {out_.text(), notes_};
  }

 private:
  /// By CONTACT's scheme an ellipse rolls by steps of an element until it is steady.
  bool rolls_until_steady() const {
    return problem_.kind == Kind::steady && direct_ && contact_.is_ellipse;
  }

  /// Whether steady rolling has steps by CONTACT's scheme that are no elements.
  bool has_other_step() const {
    constexpr double same = 0.01;  // as in CONTACT
    return problem_.kind == Kind::steady && direct_ && problem_.step > 0 &&
           std::abs(problem_.step / spacing() - 1) > same;
  }

  std::size_t components() const { return contact_.is_ellipse ? 3 : 1; }
  /// The component of the load that a component of the scene is.
  std::size_t of_load(std::size_t j) const { return problem_.across() ? 1 : j; }
  double width() const { return contact_.is_ellipse ? 1 : 2 * contact_.lateral; }
  double spacing() const { return 2 * contact_.half_width / static_cast<double>(elements_); }

  void set_grid() {
    const auto whole = [](double count) { return std::llround(count); };
    notes_ = problem_.notes;
    if (!contact_.is_ellipse || direct_) {
      elements_ = whole(contact_.elements);
      rows_ = whole(contact_.rows);
      if (has_other_step() && !contact_.is_ellipse) {
        notes_.push_back(fmt::format(
            "{}:{}: DQ = {}: with G = 2 it is the step of steady rolling, and in the scene it is "
            "an "
            "element, {} mm: results differ",
            shown(file_), problem_.line, format_short(problem_.step), format_short(spacing())));
      }
      if (direct_ && !contact_.fits) {
        notes_.push_back(
            fmt::format("{}:{}: the contact has {} by {} elements along and across, which are at "
                        "other places than "
                        "CONTACT's: results differ by the errors of the grids",
                        shown(file_), problem_.line, elements_, rows_));
      }
      return;
    }
    if (problem_.kind == Kind::steady) return;
    const PatchGrid grid = fitting_grid(PatchShape::ellipse(contact_.half_width, contact_.lateral));
    elements_ = grid.elements;
    rows_ = grid.rows;
  }

  void write_head() {
    const std::string cases = problem_.first == problem_.last
                                  ? fmt::format("case {}", problem_.last)
                                  : fmt::format("cases {} to {}", problem_.first, problem_.last);
    out_.comment(fmt::format("{}, {} of the input file {} of CONTACT", problem_.description(),
                             cases, shown(file_)));
    for (const std::string& note : notes_) out_.comment(note);
    if (direct_) {
      out_.comment("The scheme and the elements are CONTACT's, for comparison.");
      if (rolls_until_steady()) out_.comment("It rolls until it is steady; see the last step.");
    } else if (contact_.is_ellipse) {
      out_.comment("The elements are microslip's; CONTACT's scheme: import with --scheme direct.");
    }
    if (problem_.kind == Kind::shift) {
      out_.comment("The result is in shifts.tsv; a transient needs a step, which is short here.");
    }
  }

  void write_contact() {
    out_.begin("material");
    out_.key("shear_modulus", contact_.material.shear_modulus);
    out_.key("poisson_ratio", contact_.material.poisson_ratio);
    out_.end();
    out_.begin("contact");
    const double a = contact_.half_width, load = contact_.load / width();
    const bool by_radii = contact_.radius > 0;
    if (by_radii) {
      out_.key("radius_1", contact_.radius);
      if (contact_.is_ellipse) out_.key("lateral_radius_1", contact_.lateral_radius);
    } else {
      out_.key("half_width", a);
      if (contact_.is_ellipse) out_.key("lateral_half_width", contact_.lateral);
    }
    if (by_radii || contact_.is_ellipse) {
      out_.key("normal_load", load);
      out_.key("friction", contact_.friction);
    } else {
      out_.key("peak_traction", contact_.friction * 2 * load / (std::numbers::pi * a));
    }
    out_.end();
    if (contact_.is_ellipse) return;
    if (problem_.across()) out_.top("direction", "lateral");
    out_.begin("kernel");
    out_.key("type", "strip");
    out_.key("width", width());
    out_.end();
  }

  void write_grid() {
    out_.begin("grid");
    out_.key("elements", std::to_string(elements_));
    if (contact_.is_ellipse) out_.key("rows", std::to_string(rows_));
    out_.end();
  }

  /// Nothing moves behind a shift.
  void write_load() {
    out_.begin("load");
    for (std::size_t j = 0; j < components(); ++j) {
      const auto& [by_force, value] = problem_.load[of_load(j)];
      const bool is_still = problem_.kind == Kind::shift;
      out_.key(by_force ? component_keys[j].ratio : component_keys[j].motion, is_still ? 0 : value);
    }
    out_.end();
  }

  void write_start() {
    const bool by_force = problem_.load[0].by_resultant || problem_.load[1].by_resultant;
    out_.begin("start");
    const bool shifts = !problem_.shifts.empty() || (rolls_until_steady() && by_force);
    out_.key("type", shifts ? "cattaneo" : "rest");
    if (!problem_.shifts.empty()) {
      for (std::size_t j = 0; j < components(); ++j) write_shifts(j);
    }
    out_.end();
  }

  void write_shifts(std::size_t j) {
    const bool by_force = problem_.shifts.front()[of_load(j)].by_resultant;
    const double unit = by_force ? contact_.friction * contact_.load / width() : 1;
    std::string values;
    for (const PatchLoad& shift : problem_.shifts) {
      values += (values.empty() ? "" : " ") + format_short(unit * shift[of_load(j)].value);
    }
    if (problem_.shifts.size() > 1) values = "\"" + values + "\"";
    out_.key(by_force ? component_keys[j].force : component_keys[j].shift, values);
  }

  void write_steps() {
    constexpr double still = 1e-5;       // of a half-width, which any scheme can roll
    constexpr double until_steady = 24;  // half-widths, in which what was before fades to 1e-9
    const double a = contact_.half_width;
    const bool by_own_steps = problem_.kind == Kind::steps;
    out_.begin("step");
    out_.key("scheme", direct_ ? "direct" : "remembered");
    out_.key("ratio", by_own_steps || has_other_step() ? problem_.step / spacing() : 1);
    out_.end();
    out_.begin("motion");
    out_.key("distance", by_own_steps                    ? problem_.steps * problem_.step
                         : problem_.kind == Kind::steady ? until_steady * a
                                                         : still * a);
    out_.end();
  }

  const InputProblem& problem_;
  const InputContact& contact_;
  const std::string& file_;
  bool direct_;
  long long elements_ = 0, rows_ = 0;  ///< of the scene; 0 for the program's choice
  std::vector<std::string> notes_;
  SceneText out_;
};

/// Refuses a scene that microslip does not solve.
void require_solvable(const ImportedScene& imported, const InputProblem& problem,
                      const std::string& file) {
  std::istringstream in(imported.text);
  Scene scene = Scene::parse(in, "scene");
  try {
    with_places(scene, [&] { return read_model(scene); });
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("{}:{}: case {} has no scene: {}", shown(file),
                                            problem.line, problem.last, error.what()));
  }
}

ImportedScene scene_of(const InputCases& read, std::size_t index, bool direct) {
  const InputProblem problem = problem_of_input(read.cases(), index, read.file(), direct);
  ImportedScene scene = InputSceneWriter(problem, read.file(), direct).scene();
  require_solvable(scene, problem, read.file());
  return scene;
}

}  // namespace

ImportedScene scene_of_input(std::string_view text, const std::string& name,
                             const InputImport& import) {
  InputCases read(text, name);
  const auto wanted = static_cast<std::size_t>(import.number);
  while (wanted == 0 || read.cases().size() < wanted) {
    if (read.next()) continue;
    const std::size_t found = read.cases().size();
    if (wanted == 0 && found == 1) return scene_of(read, 0, import.direct);
    if (found == 0) throw std::invalid_argument(fmt::format("{}: it has no case", shown(name)));
    throw std::invalid_argument(
        wanted == 0
            ? fmt::format("{} has {} cases: expected --case and one of 1 to {}; --list "
                          "describes them",
                          shown(name), found, found)
            : fmt::format("--case {}: expected a case of {}, 1 to {}", wanted, shown(name), found));
  }
  read.require_more();
  return scene_of(read, wanted - 1, import.direct);
}

InputList cases_of_input(std::string_view text, const std::string& name, bool direct) {
  InputCases read(text, name);
  InputList list;
  const auto describe = [&](std::size_t index) -> std::string {
    try {
      const InputProblem problem = problem_of_input(read.cases(), index, name, direct);
      require_solvable(InputSceneWriter(problem, name, direct).scene(), problem, name);
      return problem.description();
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
  };
  try {
    while (read.next()) {
      const std::size_t index = read.cases().size() - 1;
      list.lines.push_back(fmt::format("case {}: {}", index + 1, describe(index)));
    }
  } catch (const std::invalid_argument& error) {
    list.error = error.what();
  }
  return list;
}

}  // namespace microslip
