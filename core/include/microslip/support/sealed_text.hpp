// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace microslip {

/// The form of a saved text: a first line of a mark and a version, members, and a last line with the
/// checksum of all before it.
struct SealedText {
  std::string_view mark;  ///< ends in a blank
  std::string_view version;

  std::string sealed(std::string_view members) const;

  /// The members of a sealed text, which must outlive them.
  /// \throws std::invalid_argument unless the text is whole and of this mark and version
  std::string_view members_of(std::string_view text) const;
};

}  // namespace microslip
