// SPDX-License-Identifier: GPL-3.0-or-later
// compare_tables TABLES REFERENCES [STUDY]
//   compares the tables of all studies, or of one, with references: exit status 1 if one differs.
// compare_tables --update TABLES REFERENCES [STUDY]
//   makes those that differ the references, and says what has changed.
// Both folders hold one of each study, with tables *.tsv; *_timing.tsv are left out. The tolerances
// are those of tolerances.txt among the references.
#include <fmt/core.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "comparison.hpp"

namespace {

using namespace microslip;
namespace fs = std::filesystem;

/// Rows that are kept of a large table, so that the references of all studies are one megabyte.
constexpr std::size_t kept_rows = 300;

using Tables = std::map<std::string, WrittenTable>;

std::string text_of(const fs::path& path) {
  std::ostringstream text;
  std::ifstream in(path);
  if (!in || !(text << in.rdbuf())) throw std::invalid_argument(path.string() + ": cannot read it");
  return text.str();
}

Tables tables_in(const fs::path& folder, const tools::Tolerances& tolerances) {
  Tables tables;
  if (!fs::is_directory(folder)) return tables;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().stem();
    if (entry.path().extension() != ".tsv" || name.ends_with("_timing")) continue;
    if (!tolerances.has_reference(fmt::format("{}/{}", folder.filename().string(), name))) continue;
    try {
      const WrittenTable whole = read_table(name, text_of(entry.path()));
      tables.emplace(name, tools::thinned(whole, kept_rows));
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(fmt::format("{}: {}", entry.path().string(), error.what()));
    }
  }
  return tables;
}

tools::Tolerances tolerances_in(const fs::path& file) {
  std::istringstream in(text_of(file));
  return tools::Tolerances(in);
}

/// Says of each table whether it agrees, and returns the names of those that do not.
std::set<std::string> compare(const std::string& study, const Tables& tables,
                              const Tables& references, const tools::Tolerances& tolerances) {
  std::set<std::string> names;
  for (const Tables* some : {&tables, &references}) {
    for (const auto& [name, table] : *some) names.insert(name);
  }
  std::set<std::string> differing;
  for (const std::string& name : names) {
    const std::string table = fmt::format("{}/{}", study, name);
    std::cout << table << ": ";
    if (tables.count(name) == 0 || references.count(name) == 0) {
      std::cout << "differs: "
                << (tables.count(name) == 0 ? "no table" : "no reference; make references makes it")
                << '\n';
      differing.insert(name);
      continue;
    }
    const auto [verdict, text] =
        tools::compare(table, tables.at(name), references.at(name), tolerances);
    const std::map<tools::Verdict, std::string> words{{tools::Verdict::identical, "identical"},
                                                      {tools::Verdict::agrees, "agrees: "},
                                                      {tools::Verdict::differs, "differs: "}};
    std::cout << words.at(verdict) << text << '\n';
    if (verdict == tools::Verdict::differs) differing.insert(name);
  }
  if (names.empty()) throw std::invalid_argument(study + ": no tables");
  return differing;
}

/// Makes tables that differ the references. Those that agree stay: another processor rounds
/// otherwise.
void update(const std::string& study, const Tables& tables, const std::set<std::string>& differing,
            const fs::path& folder) {
  fs::create_directories(folder);
  for (const std::string& name : differing) {
    const fs::path file = folder / (name + ".tsv");
    const auto table = tables.find(name);
    if (table == tables.end()) {
      fs::remove(file);
      continue;
    }
    std::ofstream out(file);
    const WrittenTable kept = tools::without_rounding(table->second);
    kept.table.write(out, study, kept.parameters);
    out.close();
    if (!out) throw std::runtime_error(file.string() + ": cannot write it");
  }
}

std::set<std::string> studies_in(const fs::path& tables, const fs::path& references) {
  std::set<std::string> studies;
  for (const fs::path& folder : {tables, references}) {
    for (const auto& entry : fs::directory_iterator(folder)) {
      if (entry.is_directory()) studies.insert(entry.path().filename());
    }
  }
  return studies;
}

int run(std::vector<std::string> words) {
  const bool updates = !words.empty() && words.front() == "--update";
  if (updates) words.erase(words.begin());
  if (words.size() != 2 && words.size() != 3) {
    throw std::invalid_argument("expected [--update] TABLES REFERENCES [STUDY]");
  }
  const fs::path tables = words[0];
  const fs::path references = words[1];
  const tools::Tolerances tolerances = tolerances_in(references / "tolerances.txt");
  bool all = true;
  for (const std::string& study :
       words.size() == 3 ? std::set{words[2]} : studies_in(tables, references)) {
    const Tables made = tables_in(tables / study, tolerances);
    const std::set<std::string> differing =
        compare(study, made, tables_in(references / study, tolerances), tolerances);
    all = all && differing.empty();
    if (updates) update(study, made, differing, references / study);
  }
  return all || updates ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    std::cerr << "compare_tables: " << error.what() << '\n';
    return 1;
  }
}
