// SPDX-License-Identifier: GPL-3.0-or-later
// Feeds each file of a folder to a reader, where there is no libFuzzer.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "reader.hpp"

namespace microslip::fuzz {

static std::map<std::string, Reader*>& readers() {
  static std::map<std::string, Reader*> all;
  return all;
}

bool list_reader(const char* name, Reader* reader) {
  readers()[name] = reader;
  return true;
}

}  // namespace microslip::fuzz

int main(int argc, char** argv) {
  namespace fs = std::filesystem;
  const auto& readers = microslip::fuzz::readers();
  if (argc != 3 || !readers.contains(argv[1]) || !fs::is_directory(argv[2])) {
    std::cerr << "usage: " << argv[0] << " READER FOLDER\n";
    return 1;
  }
  std::vector<fs::path> files{fs::directory_iterator(argv[2]), {}};
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) {
    std::ifstream in(file, std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(in), {}};
    std::cout << file.filename().string() << std::endl;
    readers.at(argv[1])(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  }
  return files.empty() ? 1 : 0;
}
