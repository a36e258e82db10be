// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace microslip::program {

/// As long as it lives, other processes wait that lock the same folder. Nothing is left in the
/// folder, and the lock of a process that was killed is gone with it. Where the file system cannot
/// lock folders (NFS), there is no waiting.
class FolderLock {
 public:
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int descriptor_;
};

}  // namespace microslip::program
