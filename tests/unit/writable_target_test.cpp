// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/support/writable_target.hpp"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/un.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <random>
#include <string>

namespace microslip::writable_target_test {

namespace fs = std::filesystem;

class WritableTarget : public testing::Test {
 protected:
  WritableTarget() {
    std::string name = (fs::temp_directory_path() / "microslip-target-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    folder_ = name;
  }
  ~WritableTarget() override { fs::remove_all(folder_); }

  fs::path at(const std::string& name) const { return folder_ / name; }

  /// Why a path is refused; empty if it is not.
  static std::string reason(const fs::path& path) {
    try {
      writable_target(path);
      return "";
    } catch (const NotWritable& error) {
      EXPECT_EQ(error.what(), "cannot write " + path.string() + ": " + error.reason());
      return error.reason();
    }
  }

 private:
  fs::path folder_;
};

TEST_F(WritableTarget, IsThePathOfAFileAndOfNone) {
  std::ofstream(at("file")) << "old";
  EXPECT_EQ(writable_target(at("file")), at("file"));
  EXPECT_EQ(writable_target(at("new")), at("new"));
  EXPECT_EQ(writable_target("name_without_folder"), "name_without_folder");
}

TEST_F(WritableTarget, RefusesWhatIsNoRegularFile) {
  fs::create_directory(at("folder"));
  ASSERT_EQ(mkfifo(at("pipe").c_str(), 0600), 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  ASSERT_LT(at("socket").string().copy(address.sun_path, sizeof address.sun_path - 1), 100U);
  const int socket_of = socket(AF_UNIX, SOCK_STREAM, 0);
  ASSERT_EQ(bind(socket_of, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  close(socket_of);
  for (const std::string name : {"folder", "pipe", "socket"}) {
    fs::create_symlink(name, at("link-to-" + name));
  }
  for (const std::string link : {"", "link-to-"}) {
    EXPECT_EQ(reason(at(link + "folder")), "Is a directory");
    EXPECT_EQ(reason(at(link + "pipe")), "it is a pipe, expected a regular file");
    EXPECT_EQ(reason(at(link + "socket")), "it is a socket, expected a regular file");
  }
  EXPECT_EQ(reason(at("folder/")), "expected the name of a file");
  EXPECT_EQ(reason(""), "expected the name of a file");
  EXPECT_EQ(reason(at("folder/..")), "Is a directory");
}

TEST_F(WritableTarget, RefusesADevice) {
  // The null device, by another name.
  if (mknod(at("device").c_str(), S_IFCHR | 0600, makedev(1, 3)) != 0) {
    GTEST_SKIP() << "only root makes devices";
  }
  fs::create_symlink("device", at("link"));
  EXPECT_EQ(reason(at("device")), "it is a device, expected a regular file");
  EXPECT_EQ(reason(at("link")), "it is a device, expected a regular file");
}

TEST_F(WritableTarget, FollowsALinkToAFileThatIsNotThere) {
  fs::create_symlink("later", at("link"));
  EXPECT_EQ(writable_target(at("link")), at("later"));
}

TEST_F(WritableTarget, RefusesALoopOfLinks) {
  fs::create_symlink("b", at("a"));
  fs::create_symlink("a", at("b"));
  EXPECT_EQ(reason(at("a")), "Too many levels of symbolic links");
}

TEST_F(WritableTarget, RefusesAFileThatLostItsName) {
  const fs::path file = at("file");
  std::ofstream out(file);
  std::FILE* open = std::fopen(file.c_str(), "r");
  ASSERT_NE(open, nullptr);
  fs::remove(file);
  const fs::path link = "/proc/self/fd/" + std::to_string(fileno(open));
  if (fs::exists(link)) {
    EXPECT_EQ(reason(link), "its link leads to a file without a name");
  }
  std::fclose(open);
}

/// Chains of links, relative and absolute, through folders that are links themselves: the system
/// reads through the path what is written to the target.
TEST_F(WritableTarget, IsTheFileThatTheSystemFinds) {
  std::mt19937 random(42);
  const auto any = [&](int below) {
    return std::uniform_int_distribution<int>(0, below - 1)(random);
  };
  for (int i = 0; i < 3; ++i) fs::create_directories(at(std::to_string(i)) / "deep");
  fs::create_directory_symlink(at("2/deep"), at("0/way"));
  const std::vector<std::string> folders = {"0", "1", "2", "0/deep", "1/deep", "0/way"};
  for (int chain = 0; chain < 300; ++chain) {
    const std::string name = std::to_string(chain);
    fs::path last = at(folders[static_cast<std::size_t>(any(6))]) / ("file" + name);
    const fs::path file = last;
    if (any(2) == 0) std::ofstream(file) << "old";
    for (int link = any(8); link > 0; --link) {
      const fs::path folder = at(folders[static_cast<std::size_t>(any(6))]);
      const fs::path next = folder / ("link" + name + "-" + std::to_string(link));
      // The folder's real path, as a relative text is read from there.
      fs::create_symlink(any(2) == 0 ? last : fs::relative(last, folder), next);
      last = next;
    }
    std::ofstream(writable_target(last)) << name;
    std::string read;
    std::ifstream(last) >> read;
    EXPECT_EQ(read, name) << last;
    EXPECT_TRUE(fs::equivalent(writable_target(last), file));
    EXPECT_FALSE(fs::is_symlink(writable_target(last)));
  }
}

}  // namespace microslip::writable_target_test
