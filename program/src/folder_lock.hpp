// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace microslip::program {

/// A lock on a folder. While the object lives, other processes that lock the same folder wait. The
/// lock leaves nothing in the folder, and ends with its process even if that is killed. On a file
/// system that cannot lock folders (NFS), nobody waits.
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
