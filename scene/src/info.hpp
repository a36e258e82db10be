// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace microslip {

/// Largest number of characters of a key, names of sections included.
inline constexpr std::size_t longest_key = 200;

/// \throws std::invalid_argument if a key is longer
void require_short(const std::string& key);

/// A dotted key with its text, and the line where the key begins.
struct InfoEntry {
  std::string key;
  std::string text;
  int line;
};

/// "scene.info:14: ", for the front of a message.
std::string place_in(const std::string& name, int line);

/// The keys of a text in INFO format, in their order:
///
///   key value            a word, or "words in quotes"; nothing is an empty value
///   half_width 1 mm      a number and its unit need no quotes
///   key "first " \       a value in quotes goes on in the next line
///       "second"
///   section { key 1 }    the brace may stand in the next line; the key is section.key
///   ; comment            up to the end of a line
///
/// Keys and values end at a blank or a semicolon, may contain the escapes of C, and may be in
/// quotes. Other files are not included. An empty section is a key without a value.
/// \param text  lines that end in \n
/// \param name  name of the source, for messages
/// \throws std::invalid_argument in one line, with the place
std::vector<InfoEntry> read_info(const std::string& text, const std::string& name);

}  // namespace microslip
