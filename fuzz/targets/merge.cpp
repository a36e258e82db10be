// SPDX-License-Identifier: GPL-3.0-or-later
// A folder for `microslip merge`: plan.tsv and, after lines of ----, the files of its cases.
#include <fmt/core.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <vector>

#include "reader.hpp"
#include "sweep_folder.hpp"

namespace {

namespace fs = std::filesystem;

/// In memory where the system offers that, as a file is written for each case of each input.
class Folder {
 public:
  Folder()
      : path_((fs::exists("/dev/shm") ? fs::path("/dev/shm") : fs::temp_directory_path()) /
              fmt::format("microslip_fuzz_{}", getpid())) {
    fs::create_directories(path_ / "cases");
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  void write(const std::string& name, const std::string& content) const {
    std::ofstream(path_ / name, std::ios::binary) << content;
  }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

std::vector<std::string> parts_of(const std::string& text) {
  constexpr std::string_view mark = "----\n";
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (std::size_t end = text.find(mark); end != std::string::npos; end = text.find(mark, begin)) {
    parts.push_back(text.substr(begin, end - begin));
    begin = end + mark.size();
  }
  parts.push_back(text.substr(begin));
  return parts;
}

}  // namespace

MICROSLIP_READER(merge) {
  using namespace microslip;
  const Folder folder;
  const std::vector<std::string> parts = parts_of(fuzz::text_of(data, size));
  folder.write("plan.tsv", parts[0]);
  for (std::size_t i = 1; i < parts.size(); ++i) {
    folder.write(fmt::format("cases/{}.tsv", i), parts[i]);
  }
  fuzz::accepts_or_rejects(
      [&] { program::SweepFolder::open(folder.path(), "microslip").merged(); });
  return 0;
}
