// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "microslip/scene/table.hpp"
#include "outputs.hpp"

namespace microslip::program {

/// The result of a case.
struct CaseResult {
  std::vector<Table> tables;  ///< none if there is no solution
  std::string status;         ///< "ok", or in one line why there is no solution
};

/// All cases of a sweep in one table.
struct MergedSweep {
  Table table;
  Parameters parameters;
  std::vector<std::string> statuses;
};

/// The results of a sweep on disk:
///   plan.tsv      all cases, written first: the sweep to which the folder belongs
///   cases/07.tsv  a case that is done, a table of one row
///   cases/07/     all its tables, where they are kept
class SweepFolder {
 public:
  /// Makes the folder belong to a sweep. \throws std::invalid_argument if it belongs to another one
  static SweepFolder begin(const std::filesystem::path& path, const std::string& program,
                           const Table& plan, const Parameters& common);

  /// The folder of a sweep that has begun. \throws std::invalid_argument if it is none
  static SweepFolder open(const std::filesystem::path& path, const std::string& program);

  const Table& plan() const { return plan_; }

  /// The status of a case that is done; nothing if it is not.
  /// \param parameters   of its scene
  /// \param with_tables  whether its tables must be there, too
  /// \throws std::invalid_argument if its file has other parameters
  std::optional<std::string> finished(std::size_t index, const Parameters& parameters,
                                      bool with_tables) const;

  /// Writes a case that is done.
  void finish(std::size_t index, const Parameters& parameters, const CaseResult& result,
              bool with_tables) const;

  /// \throws std::invalid_argument that says how many cases are missing
  MergedSweep merged() const;

 private:
  SweepFolder(std::filesystem::path path, std::string program, WrittenTable plan,
              const std::string& plan_text);

  std::string name_of(std::size_t index) const;
  std::filesystem::path file_of(std::size_t index) const;
  std::filesystem::path folder_of(std::size_t index) const;
  Parameters head_of(std::size_t index, const Parameters& parameters) const;
  Table row_of(std::size_t index, const CaseResult& result) const;
  std::optional<WrittenTable> read(std::size_t index) const;
  std::vector<WrittenTable> rows() const;

  std::filesystem::path path_;
  std::string program_;
  Table plan_;
  Parameters common_;
  std::string checksum_;
};

}  // namespace microslip::program
