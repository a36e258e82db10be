// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "command_line.hpp"
#include "drawing.hpp"
#include "figure_file.hpp"
#include "interrupts.hpp"
#include "microslip/program/commands.hpp"
#include "microslip/scene/units.hpp"
#include "microslip/support/format.hpp"
#include "microslip/support/nearest.hpp"
#include "microslip/support/shown.hpp"
#include "process.hpp"
#include "provenance.hpp"

namespace microslip::program {

namespace {

namespace options = boost::program_options;
namespace fs = std::filesystem;

/// The line of column names of a table; empty if there is none.
std::string header_of(const fs::path& table) {
  std::ifstream in(table);
  std::string line;
  while (std::getline(in, line) && line.starts_with('#')) continue;
  return line;
}

[[noreturn]] void reject(const fs::path& folder, const std::string& why) {
  throw std::invalid_argument(
      fmt::format("'{}': expected the folder of a result; {}", shown(folder.string()), why));
}

/// Whether it is the folder of a case of a sweep, which is there as a whole or not at all.
bool is_case(const fs::path& folder) {
  const fs::path cases = fs::absolute(folder).lexically_normal().parent_path();
  return cases.filename() == "cases" && fs::exists(cases.parent_path() / "plan.tsv");
}

/// Which program wrote a result: the first word of its provenance.
/// \param name  of the program of scenes
std::string program_of(const fs::path& folder, const std::string& name) {
  if (!fs::is_directory(folder)) reject(folder, "there is no such folder");
  if (is_case(folder)) return name;
  std::ifstream in(folder / "provenance.txt");
  std::string program;
  if (in >> program) return program;
  reject(folder, fs::exists(folder / "plan.tsv")
                     ? "its sweep has not ended; 'microslip merge' makes sweep.tsv"
                     : "it has no provenance.txt");
}

/// The kind of a result that has a figure of its own.
std::string kind_of(const fs::path& folder) {
  for (const char* kind : {"sweep", "curve", "response", "converge"}) {
    if (fs::exists(folder / fmt::format("{}.tsv", kind))) return kind;
  }
  if (!fs::exists(folder / "traction.tsv")) reject(folder, "it has no traction.tsv");
  const std::string history = header_of(folder / "history.tsv");
  if (header_of(folder / "traction.tsv").starts_with("x\ty\t")) {
    return history.empty() ? "ellipse" : "history";
  }
  if (history.empty()) return "steady";
  return history.starts_with("q\t") ? "transient" : "cylinder";
}

struct Figure {
  std::string name;
  fs::path script;
  std::string ending;  ///< behind the name of the result
};

/// Whether there are enough shifts for a loop of the force.
bool has_loop(const fs::path& folder) {
  constexpr int least = 3;
  std::ifstream in(folder / "shifts.tsv");
  int rows = -2;  // the first two lines are the names and the start
  for (std::string line; std::getline(in, line);) rows += line.starts_with('#') ? 0 : 1;
  return rows >= least;
}

/// All that the scripts know of a study, in the order of their names.
std::vector<Figure> figures_of_study(const fs::path& plots, const std::string& study) {
  std::vector<Figure> figures;
  for (const auto& entry : fs::directory_iterator(plots)) {
    const std::string name = entry.path().stem();
    if (entry.path().extension() != ".gp" || !name.starts_with(study + "_")) continue;
    const std::string figure = name.substr(study.size() + 1);
    figures.push_back({figure, entry.path(), "_" + figure});
  }
  std::ranges::sort(figures, {}, &Figure::name);
  return figures;
}

/// Options that only some results take.
void reject_options_of(const Given& given, const std::vector<const char*>& names,
                       const std::string& kinds) {
  for (const char* name : names) {
    if (given.count(name) == 0 || given[name].defaulted()) continue;
    throw std::invalid_argument(fmt::format("--{}: expected {} with it", name, kinds));
  }
}

/// Returns the range that --x, --q or --time asks for, as gnuplot takes it.
std::string axis_of(const char* option, const Given& given, const Extent& extent,
                    const std::string& unit) {
  const std::string text = given[option].as<std::string>();
  const auto fail = [&](const std::string& expected) {
    throw std::invalid_argument(
        fmt::format("--{} '{}': expected {}", option, shown(text), expected));
  };
  const std::size_t colon = text.find(':');
  const std::string from = text.substr(0, colon);
  const std::string to = colon == std::string::npos ? "" : text.substr(colon + 1);
  const auto least = from.empty() ? extent.least : quantity(from, unit);
  const auto most = to.empty() ? extent.most : quantity(to, unit);
  const std::string in = unit == "1" ? "" : " " + unit;
  if (colon == std::string::npos || !least || !most || !(*least < *most)) {
    fail("two rising numbers as 1:2, of which one may be left out" +
         (in.empty() ? in : ", in" + in));
  }
  if (*least > extent.most || *most < extent.least) {
    fail(fmt::format("a range that meets {} to {}{}", format_short(extent.least),
                     format_short(extent.most), in));
  }
  if (extent.count(*least, *most) < 2) fail("a range with two rows of the table or more");
  return fmt::format("[{}:{}]", from.empty() ? "*" : format_full(*least),
                     to.empty() ? "*" : format_full(*most));
}

/// The figures of a result, or the one of them that is asked for.
std::vector<Figure> chosen(const std::vector<Figure>& figures, const Given& given) {
  if (given.count("figure") == 0) return figures;
  const std::string wanted = given["figure"].as<std::string>();
  const auto found = std::ranges::find(figures, wanted, &Figure::name);
  if (found != figures.end()) return {*found};
  const std::vector<std::string> names = names_of(figures);
  throw std::invalid_argument(fmt::format("--figure '{}': expected {}{}", shown(wanted),
                                          joined(names, ", "), suggestion(nearest(wanted, names))));
}

/// A file has one figure.
void require_one_figure(const std::vector<Figure>& figures) {
  if (figures.size() == 1) return;
  throw std::invalid_argument(fmt::format("--to: expected --figure with it here, one of {}",
                                          joined(names_of(figures), ", ")));
}

/// The folder of a result, which may be named by one of its tables, too; with a name of its own,
/// after which figures are named.
fs::path folder_of(const fs::path& result) {
  const fs::path folder = fs::is_regular_file(result) ? fs::absolute(result).parent_path() : result;
  const fs::path whole = (fs::absolute(folder) / "").lexically_normal().parent_path();
  const fs::path relative = whole.lexically_relative(fs::current_path());
  return relative.string().starts_with('.') ? whole : relative;
}

/// Whether --to wants an animation.
bool wants_gif(const Given& given) {
  return given.count("to") != 0 && fs::path(given["to"].as<std::string>()).extension() == ".gif";
}

/// Where --to wants a figure.
/// \param can_move  whether the figure has an animation, too
fs::path target_of(const Given& given, bool can_move = false) {
  const std::string name = given["to"].as<std::string>();
  const std::string ending = fs::path(name).extension();
  if (ending == ".svg" || ending == ".png" || ending == ".pdf") return name;
  if (can_move && ending == ".gif") return name;
  throw std::invalid_argument(
      fmt::format("--to '{}': expected a name that ends in .svg, .png or .pdf, or in .gif of the "
                  "figure instants",
                  shown(name)));
}

fs::path folder_of_scripts() {
  const fs::path plots = share_folder() / "plots";
  if (fs::is_directory(plots)) return plots;
  throw std::runtime_error(
      fmt::format("cannot read {}: expected the scripts of figures there", shown(plots.string())));
}

void draw_study(const std::string& study, const fs::path& folder, const Given& given) {
  reject_options_of(given, {"x", "q", "time", "over", "value", "by", "only"},
                    "a result of a scene");
  const std::vector<Figure> all = figures_of_study(folder_of_scripts(), study);
  if (all.empty()) reject(folder, fmt::format("the result of {} has no figures", shown(study)));
  const std::vector<Figure> figures = chosen(all, given);
  if (given.count("to") != 0) {
    require_one_figure(figures);
    return draw(figures.front().script, folder, target_of(given));
  }
  for (const Figure& figure : figures) {
    draw(figure.script, folder, folder.string() + figure.ending + ".svg");
  }
}

/// Figures of results that one script has as they are.
Drawing drawing_of_tables(const Result& result, const std::string& column) {
  Drawing drawing{.kind = result.kind};
  const Table table = table_in(result.folder, result.kind).table;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    drawing.horizontal.include(number_of(table.at(i, column)).value_or(NAN));
  }
  if (column == "elements") drawing.unit = "1";
  return drawing;
}

std::string text_of(const Given& given, const char* option) {
  return given.count(option) == 0 ? "" : given[option].as<std::string>();
}

void require_one(const std::vector<Result>& results) {
  if (results.size() == 1) return;
  throw std::invalid_argument(fmt::format("'{}': expected one result, as figures of {} take one",
                                          shown(results[1].name), results.front().kind));
}

Drawing drawing_of(const std::vector<Result>& results, const Given& given) {
  const std::string& kind = results.front().kind;
  if (kind == "sweep" || kind == "curve") {
    reject_options_of(given, {"q", "time"}, "a transient or a cylinder");
    return drawing_of_sweeps(results, {.over = text_of(given, "over"),
                                       .value = text_of(given, "value"),
                                       .by = text_of(given, "by"),
                                       .only = given["only"].as<std::vector<std::string>>()});
  }
  reject_options_of(given, {"value", "by", "only"}, "a sweep or a curve");
  if (kind == "ellipse") {
    reject_options_of(given, {"x", "q", "time", "over"}, "a line contact, a sweep or a curve");
    require_one(results);
    return {.kind = kind};
  }
  if (kind == "history") reject_options_of(given, {"x"}, "a line contact, a sweep or a curve");
  if (kind != "converge" && kind != "shifts") {
    const Drawing drawing = drawing_of_scenes(results, text_of(given, "over"));
    if (drawing.history.values.empty()) {
      reject_options_of(given, {"over"}, "a sweep, a curve, a transient or a cylinder");
    }
    return drawing;
  }
  reject_options_of(given, {"over"}, "a sweep, a curve, a transient or a cylinder");
  require_one(results);
  return drawing_of_tables(results.front(), kind == "shifts" ? "total_shift" : "elements");
}

/// Draws one figure of results.
void draw_results(const std::string& name, const std::vector<Result>& results, const Given& given,
                  const fs::path& figure) {
  const Drawing drawing = drawing_of(results, given);
  std::string settings;
  if (given.count("x") != 0) {
    settings += fmt::format("x_range='{}';", axis_of("x", given, drawing.horizontal, drawing.unit));
  }
  const auto backward = std::ranges::count_if(results, ends_backward);
  if (backward > 0) {
    const bool all = backward == static_cast<std::ptrdiff_t>(results.size());
    settings += fmt::format("x_label='x [mm]{}';", all ? ", rolling to the left at the end" : "");
  }
  if (drawing.history.values.empty()) {
    reject_options_of(given, {"q", "time"}, "a transient or a cylinder");
  }
  const bool over_time = drawing.over == "t";
  reject_options_of(given, {over_time ? "q" : "time"}, over_time ? "--over q" : "--over t");
  const char* axis = over_time ? "time" : "q";
  if (given.count(axis) != 0) {
    settings += fmt::format("history_range='{}';",
                            axis_of(axis, given, drawing.history, over_time ? "s" : "mm"));
  }
  const fs::path script = folder_of_scripts() / fmt::format("{}_{}.gp", name, drawing.kind);
  if (drawing.tables.empty()) return draw(script, results.front().folder, figure, settings);
  const ScratchFolder scratch;
  write_drawing(drawing, scratch.path());
  draw(script, scratch.path(), figure, settings);
}

/// Draws the instants of a run, as small multiples or as an animation of 8 s.
void draw_instants(const std::string& name, const Result& result, const Given& given,
                   const fs::path& figure) {
  reject_options_of(given, {"x", "q", "time", "value", "by", "only"},
                    "a figure other than instants");
  const std::string over = text_of(given, "over");
  require_axis_of_run(over);
  constexpr int length = 800, least = 8, most = 100;  // [s/100]
  const bool animated = figure.extension() == ".gif";
  const std::vector<OutputFile> files = files_of_instants(result, over == "t", animated);
  const ScratchFolder scratch;
  write_files(scratch.path(), files);
  const int panels = static_cast<int>(table_in(scratch.path(), "panels").table.rows());
  draw(folder_of_scripts() / fmt::format("{}_instants.gp", name), scratch.path(), figure,
       fmt::format("delay={};", std::clamp(length / panels, least, most)));
}

/// Behind the folder of the first result.
fs::path name_of_comparison(const std::vector<Result>& results) {
  fs::path name = results.front().folder;
  if (results.size() == 2) name += "_and_" + results[1].folder.filename().string();
  if (results.size() > 2) name += fmt::format("_and_{}_others", results.size() - 1);
  return name;
}

/// \param name  of the program of scenes
void draw_scenes(const std::string& name, std::vector<Result> results, const Given& given) {
  const fs::path first = results.front().folder;
  std::vector<Figure> all{{results.front().kind, "", ""}};
  const bool has_instants = results.size() == 1 && fs::exists(first / "instants.tsv");
  const bool is_instants =
      text_of(given, "figure") == "instants" || (wants_gif(given) && given.count("figure") == 0);
  if (is_instants) {
    results.front().kind = "instants";
    require_one(results);
    if (!has_instants) {
      reject(first, "it has no instants.tsv, which motion.instants of a transient makes");
    }
    return draw_instants(name, results.front(), given,
                         given.count("to") != 0 ? target_of(given, true)
                                                : fs::path(first.string() + "_instants.svg"));
  }
  const bool shows_history =
      std::ranges::any_of(std::vector{"q", "time", "over"},
                          [&](const char* option) { return given.count(option) != 0; });
  const bool is_shifts = text_of(given, "figure") == "shifts";
  const bool is_map = text_of(given, "figure") == "ellipse";
  if (results.size() == 1 && all.front().name == "history" && (is_map || !shows_history)) {
    const bool is_lost = ends_without_contact(results.front());
    if (is_lost && is_map) reject(first, "it ends without contact, and has no map");
    if (!is_lost) all.push_back({"ellipse", "", "_ellipse"});
  }
  if (results.size() == 1 && all.front().name == "transient" && has_loop(first) &&
      (is_shifts || !shows_history)) {
    all.push_back({"shifts", "", "_shifts"});
  }
  if (has_instants && !shows_history) all.push_back({"instants", "", "_instants"});
  const std::vector<Figure> figures = chosen(all, given);
  if (given.count("to") != 0) require_one_figure(figures);
  for (const Figure& figure : figures) {
    results.front().kind = figure.name;
    const fs::path target =
        given.count("to") != 0
            ? target_of(given)
            : fs::path(name_of_comparison(results).string() + figure.ending + ".svg");
    if (figure.name == "instants") {
      draw_instants(name, results.front(), given, target);
    } else {
      draw_results(name, results, given, target);
    }
  }
}

/// \param name  of the program of scenes; the others are studies
void draw_all(const std::string& name, const Given& given) {
  std::vector<Result> results;
  for (const std::string& word : given["result"].as<std::vector<std::string>>()) {
    const fs::path folder = folder_of(word);
    const std::string program = program_of(folder, name);
    const bool is_alone = given["result"].as<std::vector<std::string>>().size() == 1;
    if (program != name && is_alone) return draw_study(program, folder, given);
    if (program != name) reject(folder, "figures of studies are drawn one at a time");
    results.push_back({folder, word, kind_of(folder)});
  }
  draw_scenes(name, results, given);
}

}  // namespace

int plot(const std::string& name, int argc, const char* const* argv) {
  return run_process(name, [&] {
    using Words = std::vector<std::string>;
    Options known("Options of plot");
    const auto word = [] { return options::value<std::string>(); };
    known.add_options()("result", options::value<Words>()->default_value({"out"}, "out"),
                        "the first words: folders of results, or of a study, or tables there; "
                        "several are drawn over one another")("figure", word(),
                                                              "name of the only figure to draw")(
        "to", word(),
        "file that ends in .svg, .png or .pdf (default: RESULT.svg, or RESULT_FIGURE.svg of one "
        "figure of several); .gif is an animation of instants")(
        "x", word(), "a:b, range of the horizontal axis")(
        "q", word(), "a:b, range of the distance rolled")("time", word(),
                                                          "a:b, range of the time, with --over t")(
        "over", word(),
        "of a sweep or a curve: the key on the horizontal axis; of a run: t, the time, in the "
        "place of q")("value", word(), "of a sweep or a curve: the quantity on the vertical axis")(
        "by", word(), "of a sweep or a curve: the key that colours tell apart")(
        "only", options::value<Words>()->default_value({}, ""),
        "of a sweep or a curve: key=value, only cases with this value; repeatable")(
        "version", "print version and revision")("help", "print this");
    const Given given = parse(known, argc - 1, argv + 1, "result", any_number);
    if (answers(given, known, name + " plot", "draws the figures of results, with gnuplot")) {
      return 0;
    }
    Interrupts interrupts(name + ": interrupted, no figure is drawn");
    interrupts.critical([&] { draw_all(name, given); });
    return 0;
  });
}

}  // namespace microslip::program
