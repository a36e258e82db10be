// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <initializer_list>
#include <iosfwd>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace microslip {

/// Keys and values in the order in which a program resolved them, defaults included.
using Parameters = std::vector<std::pair<std::string, std::string>>;

/// The input of a program: dotted keys with text values, read strictly. Every reader below converts
/// or throws std::invalid_argument in one line that names the key; keys that nobody asked for are
/// rejected at the end.
class Scene {
 public:
  /// Reads a property tree in INFO format.
  /// \param name  of the source, for messages
  static Scene parse(std::istream& in, const std::string& name);

  /// Replaces what the other scene also gives, and adds the rest.
  void overlay(const Scene& other);

  /// \param assignment  "key.sub=value"; an empty value removes the key
  void set(std::string_view assignment);

  bool has(const std::string& key) const { return values_.count(key) != 0; }

  /// A finite decimal number.
  double number(const std::string& key);
  double number(const std::string& key, double fallback);

  /// A list of them, separated by blanks; not empty.
  std::vector<double> numbers(const std::string& key);

  /// A whole number.
  Eigen::Index whole(const std::string& key);

  /// One of the words in `accepted`; the first is the default of the second form.
  std::string word(const std::string& key, std::initializer_list<std::string_view> accepted);
  std::string word_or_first(const std::string& key,
                            std::initializer_list<std::string_view> accepted);

  /// \throws std::invalid_argument if a key was given that nobody read
  void reject_unread() const;

  /// What was read so far.
  const Parameters& parameters() const { return parameters_; }

 private:
  const std::string& text(const std::string& key);
  std::string known_keys() const;

  std::map<std::string, std::string> values_;
  Parameters parameters_;
};

}  // namespace microslip
