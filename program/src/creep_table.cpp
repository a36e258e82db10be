// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "command_line.hpp"
#include "folder_lock.hpp"
#include "interrupts.hpp"
#include "microslip/creep_table/creep_states.hpp"
#include "microslip/creep_table/creep_table_file.hpp"
#include "microslip/program/commands.hpp"
#include "microslip/support/archive.hpp"
#include "microslip/support/parallel.hpp"
#include "microslip/support/sealed_text.hpp"
#include "microslip/support/shown.hpp"
#include "microslip/support/text.hpp"
#include "outputs.hpp"
#include "process.hpp"
#include "provenance.hpp"
#include "sweep_options.hpp"

namespace microslip::program {

namespace {

namespace options = boost::program_options;
namespace fs = std::filesystem;
using Eigen::Index;
using Eigen::VectorXd;

constexpr const char* purpose =
    "makes a table of creep forces of contact ellipses, which programs look up in a microsecond";
constexpr SealedText sealed_part{.mark = "microslip part of a table ", .version = "2"};

/// States that are solved at one a/b.
constexpr std::size_t states_of_group = 50;

Options table_options() {
  const CreepTableLayout standard;
  Options known("Options of table");
  const auto number = [](auto value) {
    return options::value<decltype(value)>()->default_value(value, fmt::format("{}", value));
  };
  known.add_options()("poisson-ratio", number(standard.poisson_ratio), "nu, 0 to 0.5")(
      "least-ratio", number(standard.least_ratio), "least a/b, from 0.05")(
      "largest-ratio", number(standard.largest_ratio), "largest a/b, up to 10")(
      "ratios", number(standard.ratios), "nodes of a/b, 4 to 200")(
      "steps", number(standard.steps), "nodes of the size of the motion, 4 to 200")(
      "polar", number(standard.polar), "nodes from pure spin to none, 3 to 200")(
      "azimuths", number(standard.azimuths), "nodes of the direction of the creepage, 3 to 200")(
      "cells", number(standard.cells),
      "rows, and elements of each, of a circle: nodes are means of solutions on these and on one "
      "more, 4 to 40")(
      "states", number(Index{1000}),
      "random motions that are solved to measure the errors of the table; 0 for none")(
      "error-cells", number(Index{24}), "cells on which these are solved, and one more, 4 to 40")(
      "threads", options::value<std::string>(), "parts at once (default: the number of cores)")(
      "shard", options::value<std::string>(),
      "i/n: only parts i, i + n, i + 2n ...; the shard that ends last writes the table");
  add_common_options(known, "creep_forces.nc", "file, in netCDF's classic format");
  return known;
}

/// A table that is asked for.
struct TableOrder {
  CreepTableLayout layout;
  Index states, error_cells;

  std::size_t groups() const {
    return (static_cast<std::size_t>(states) + states_of_group - 1) / states_of_group;
  }
};

TableOrder order_of(const Given& given) {
  const auto whole = [&](const char* name) { return given[name].as<Index>(); };
  const TableOrder order{.layout = {.poisson_ratio = given["poisson-ratio"].as<double>(),
                                    .least_ratio = given["least-ratio"].as<double>(),
                                    .largest_ratio = given["largest-ratio"].as<double>(),
                                    .ratios = whole("ratios"),
                                    .steps = whole("steps"),
                                    .polar = whole("polar"),
                                    .azimuths = whole("azimuths"),
                                    .cells = whole("cells")},
                         .states = whole("states"),
                         .error_cells = whole("error-cells")};
  validate(order.layout);
  constexpr Index most_states = 1'000'000;
  const auto refuse = [&](const char* name, const std::string& accepted) {
    throw std::invalid_argument(fmt::format("--{} {}: expected {}", name, whole(name), accepted));
  };
  if (order.states < 0 || order.states > most_states) {
    refuse("states", fmt::format("a whole number from 0 to {}", most_states));
  }
  if (order.error_cells < 4 || order.error_cells > 40) {
    refuse("error-cells", "a whole number from 4 to 40");
  }
  return order;
}

/// The work in parts: nodes of one a/b and polar angle, and groups of states. Each is written when it
/// is done, so that an interrupted table goes on, with as many states as it has then, and shards
/// share a folder.
class TableParts {
 public:
  TableParts(const TableOrder& order, fs::path folder)
      : order_(order), maker_(order.layout), folder_(std::move(folder)) {}

  std::size_t count() const { return maker_.parts() + order_.groups(); }
  const fs::path& folder() const { return folder_; }
  bool is_done(std::size_t part) const { return fs::exists(folder_ / name_of(part)); }

  std::vector<double> solve(std::size_t part) const {
    if (part < maker_.parts()) return maker_.solve(part);
    const std::size_t group = part - maker_.parts();
    std::vector<double> numbers;
    for (const CreepState& state :
         random_creep_states(order_.layout, group + 1, states_in(part), order_.error_cells)) {
      numbers.push_back(state.ratio);
      numbers.insert(numbers.end(), state.motion.begin(), state.motion.end());
      numbers.insert(numbers.end(), state.forces.begin(), state.forces.end());
    }
    return numbers;
  }

  void write(std::size_t part, std::vector<double> numbers) const {
    Archive archive;
    exchange(archive, part, numbers);
    write_files(folder_, {{name_of(part), sealed_part.sealed(archive.text())}});
  }

  /// \throws std::invalid_argument for a part of another table, or a damaged one
  std::vector<double> read(std::size_t part) const {
    std::vector<double> numbers;
    try {
      const std::string text = file_text(folder_ / name_of(part));
      Archive archive(sealed_part.members_of(text));
      exchange(archive, part, numbers);
      archive.require_end();
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(
          fmt::format("{} of the folder beside --out: {}; remove the folder to begin anew",
                      name_of(part), error.what()));
    }
    return numbers;
  }

  CreepTableNodes nodes() const {
    std::vector<std::vector<double>> parts;
    for (std::size_t part = 0; part < maker_.parts(); ++part) parts.push_back(read(part));
    return maker_.joined(parts);
  }

  std::vector<CreepState> states() const {
    std::vector<CreepState> states;
    for (std::size_t part = maker_.parts(); part < count(); ++part) {
      const std::vector<double> numbers = read(part);
      for (std::size_t i = 0; i + 7 <= numbers.size(); i += 7) {
        const double* at = numbers.data() + i;
        states.push_back({at[0], {at[1], at[2], at[3]}, {at[4], at[5], at[6]}});
      }
    }
    return states;
  }

 private:
  /// The states of a part: none where it has nodes, and as many as are left in the last one.
  std::size_t states_in(std::size_t part) const {
    if (part < maker_.parts()) return 0;
    const std::size_t before = (part - maker_.parts()) * states_of_group;
    return std::min(static_cast<std::size_t>(order_.states) - before, states_of_group);
  }

  static std::string name_of(std::size_t part) { return fmt::format("part_{}.txt", part + 1); }

  void exchange(Archive& archive, std::size_t part, std::vector<double>& numbers) const {
    const CreepTableLayout& of = order_.layout;
    archive.same("poisson_ratio", of.poisson_ratio);
    archive.same("least_ratio", of.least_ratio);
    archive.same("largest_ratio", of.largest_ratio);
    for (const auto& [name, number] : {std::pair{"ratios", of.ratios},
                                       {"steps", of.steps},
                                       {"polar", of.polar},
                                       {"azimuths", of.azimuths},
                                       {"cells", of.cells},
                                       {"error_cells", order_.error_cells}}) {
      archive.same(name, static_cast<double>(number));
    }
    archive.same("states", static_cast<double>(states_in(part)));
    archive.same("part", static_cast<double>(part));
    const bool has_nodes = part < maker_.parts();
    const auto most = static_cast<Index>(has_nodes ? maker_.values_of(part) : 7 * states_of_group);
    auto count = static_cast<Index>(numbers.size());
    archive.whole("count", count, has_nodes ? most : 0, most);
    VectorXd values = Eigen::Map<const VectorXd>(numbers.data(), archive.reads() ? 0 : count);
    archive.numbers("values", values, count);
    numbers.assign(values.begin(), values.end());
  }

  TableOrder order_;
  CreepTableMaker maker_;
  fs::path folder_;
};

Table states_table(const std::string& name, const std::vector<CreepState>& states,
                   const CreepTable& table) {
  Table found(name,
              "Random states that were solved to measure the errors of a table of creep forces",
              {{"ratio", "1", "a/b"},
               {"creepage", "1", "xi over mu p_0/G"},
               {"lateral_creepage", "1", "eta over mu p_0/G"},
               {"spin", "1", "phi c over mu p_0/G"},
               {"force", "1", "F_x over mu F_n, solved"},
               {"lateral_force", "1", "F_y over mu F_n, solved"},
               {"spin_moment", "1", "M_z over mu F_n c, solved"},
               {"force_error", "1", "of the table"},
               {"lateral_force_error", "1", "of the table"},
               {"spin_moment_error", "1", "of the table"}});
  for (const auto& [ratio, motion, forces] : states) {
    const Eigen::Vector3d error = table.forces(ratio, motion) - forces;
    found.add({ratio, motion[0], motion[1], motion[2], forces[0], forces[1], forces[2], error[0],
               error[1], error[2]});
  }
  return found;
}

/// Puts the parts together, and measures the errors.
int write_table(const TableOrder& order, const TableParts& parts, const fs::path& out,
                const std::string& program, bool is_quiet) {
  CreepTableNodes nodes = parts.nodes();
  const std::vector<CreepState> states = parts.states();
  std::vector<OutputFile> files;
  if (!states.empty()) {
    // With the values that a reader of the file has.
    const CreepTable table(read_creep_table(file_of(nodes, "")));
    nodes.errors = errors_in(states, table, order.error_cells);
    const std::string name = out.stem().string() + "_states";
    files.push_back(output_of(states_table(name, states, table), program, {}));
  }
  files.push_back({out.filename().string(), file_of(nodes, version_line(program))});
  write_files(out.parent_path().empty() ? "." : out.parent_path(), files);
  fs::remove_all(parts.folder());
  const auto unsolved = static_cast<std::size_t>(order.states) - states.size();
  if (unsolved > 0) {
    std::cerr << program << ": warning: " << unsolved << " of " << order.states
              << " random states had no solution on " << order.error_cells
              << " cells, and have no part in the errors\n";
  }
  if (is_quiet) return 0;
  std::cout << "wrote " << out.string() << ": " << order.layout.nodes() << " nodes";
  if (!states.empty()) {
    const CreepTableErrors& errors = nodes.errors;
    std::cout << fmt::format(
        "; errors of {} states over full sliding: rms {:.2g}, 99 % {:.2g}, largest {:.2g}",
        errors.states, errors.rms.maxCoeff(), errors.of_99_percent.maxCoeff(),
        errors.largest.maxCoeff());
  }
  std::cout << '\n';
  return 0;
}

int make(const std::string& program, const Given& given) {
  const TableOrder order = order_of(given);
  const fs::path out = given["out"].as<std::string>();
  const fs::path folder = out.string() + ".parts";
  const ParallelSettings settings = parallel_settings(given);
  require_writable(folder);
  if (fs::is_directory(out) || !out.has_filename()) {
    throw std::invalid_argument(
        fmt::format("--out '{}': expected the name of a file", shown(out.string())));
  }
  Interrupts interrupts("stopped; the same command goes on");
  const TableParts parts(order, folder);
  const Shard shard = settings.shard.value_or(Shard{1, 1});
  std::vector<std::size_t> open;
  std::size_t chosen = 0;
  for (std::size_t part = shard.number - 1; part < parts.count(); part += shard.count) {
    ++chosen;
    if (parts.is_done(part)) {
      parts.read(part);
    } else {
      open.push_back(part);
    }
  }
  const Progress progress = progress_on_terminal(program + " table", settings.quiet);
  std::size_t done = chosen - open.size();
  for_each_case(open.size(), settings.threads, [&](std::size_t i) {
    std::vector<double> numbers = parts.solve(open[i]);
    interrupts.critical([&] {
      parts.write(open[i], std::move(numbers));
      progress(++done, chosen);
    });
  });
  // One of the shards that end at the same time writes the table.
  const FolderLock lock(folder);
  if (chosen > 0 && !fs::exists(folder)) return 0;
  std::size_t missing = 0;
  for (std::size_t part = 0; part < parts.count(); ++part) missing += parts.is_done(part) ? 0 : 1;
  if (missing > 0) {
    if (!settings.quiet) {
      std::cout << missing << " of " << parts.count() << " parts are not done yet\n";
    }
    return 0;
  }
  int status = 0;
  interrupts.last([&] { status = write_table(order, parts, out, program, settings.quiet); });
  return status;
}

}  // namespace

int creep_table(const std::string& name, int argc, const char* const* argv) {
  return run_process(name, [&] {
    const Options known = table_options();
    const Given given = parse(known, argc - 1, argv + 1);
    if (answers(given, known, name + " table", purpose)) return 0;
    return make(name, given);
  });
}

}  // namespace microslip::program
