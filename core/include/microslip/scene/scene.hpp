// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>
#include <iosfwd>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "microslip/support/require.hpp"
#include "microslip/support/shown.hpp"

namespace microslip {

/// Keys and values in the order in which a program resolved them, defaults included.
using Parameters = std::vector<std::pair<std::string, std::string>>;

/// The unit of a key that is none of a scene's, or that has another unit than in a scene.
struct Unit {
  std::string_view name;  ///< "1" of a pure number
};

/// A column of a table file.
struct FileColumn {
  FileColumn(const char* name_, const char* unit_, bool needed_ = true)
      : name(name_), unit(unit_), needed(needed_) {}

  std::string name;
  std::string unit;  ///< in which its values are wanted; that of a column without one, too
  bool needed;
};

/// The input of a program: dotted keys with text values, read strictly. Every reader below converts
/// or throws BadParameter, or std::invalid_argument where there is no such key. The message is one
/// line that names the key; with_places() adds file and line. reject_unread() rejects the keys that
/// nobody read.
class Scene {
 public:
  /// Most bytes of a text; a scene holds some dozens of keys.
  static constexpr std::size_t most_text = 1 << 20;

  /// The text of a file. \throws std::invalid_argument if it cannot be read
  using FileReader = std::function<std::string(const std::string& path)>;

  /// Reads a property tree in INFO format, without its `#include`: at most most_text bytes of
  /// UTF-8, with lines that end in LF or CRLF.
  /// \param name    of the source, for messages
  /// \param folder  to which relative file names in it refer; ends in '/' unless empty
  static Scene parse(std::istream& in, const std::string& name, const std::string& folder = "");

  /// Without one, no key may name a file.
  void read_files_by(FileReader reader) { read_file_ = std::move(reader); }

  /// Replaces what the other scene also gives, and adds the rest.
  void overlay(const Scene& other);

  /// \param assignment  "key.sub=value"; an empty value removes the key and "sweep.key.sub", one of
  ///                    which there must be, and any other wins over "sweep.key.sub"
  void set(std::string_view assignment);

  /// Takes all keys below a section out: a scene of their own, in which they lack its name.
  Scene take_section(const std::string& section);

  /// Gives another text to a key that is there; a relative file name refers to the same folder.
  void replace(const std::string& key, const std::string& text);

  bool has(const std::string& key) const { return values_.count(key) != 0; }

  /// In the order in which they were first given.
  std::vector<std::string> keys() const;

  /// File and line of a key, for the front of a message: "scene.info:14: ". Empty if there is no
  /// such key, or if set() gave it.
  std::string place_of(const std::string& key) const;

  /// As it was given. \throws std::invalid_argument if there is no such key
  const std::string& text(const std::string& key) const { return value(key).text; }

  /// The one key that is given of those that exclude each other; empty if none is.
  /// \throws std::invalid_argument if two are
  std::string at_most_one_of(const std::vector<std::string>& keys) const;

  /// The same. \throws std::invalid_argument if none is, too
  std::string one_of(const std::vector<std::string>& keys) const;

  /// A finite decimal number, with a point in any locale: 1.5, .5, +5, -1e-3. One that is too small
  /// for a double, 1e-400, is rejected like one that is too large. After it may stand a unit, which
  /// is converted to that of the key (unit_of_key): "2 cm" of a length is 20.
  double number(const std::string& key);
  double number(const std::string& key, double fallback);
  double number(const std::string& key, Unit unit);

  /// A number above zero.
  double positive(const std::string& key);
  double positive(const std::string& key, Unit unit);

  /// A list of them, separated by blanks; not empty. Of a key with a unit, as quantities() takes
  /// it.
  std::vector<double> numbers(const std::string& key);

  /// A whole number, also as 1e5.
  Eigen::Index whole(const std::string& key);

  /// A list of them, separated by blanks; not empty, and all within a range.
  std::vector<Eigen::Index> wholes(const std::string& key, Eigen::Index least, Eigen::Index most);

  /// What `use` makes of columns of numbers in a table file that the key names: a line of column
  /// names, each perhaps with its unit, "q [mm]" or "q[mm]", then rows, separated by blanks or
  /// tabs; lines that begin with # are comments. Other columns may hold anything. Messages name
  /// key, file and, where there is one, line.
  ///
  /// \param use  called with the columns wanted; those that are neither needed nor there are empty
  template <class Use>
  auto from_columns(const std::string& key, const std::vector<FileColumn>& wanted, Use use) {
    return with_file(key, [&] { return use(columns(key, wanted)); });
  }

  /// Calls an action; a message of its std::invalid_argument then begins with key and file.
  template <class Action>
  auto with_file(const std::string& key, Action action) const {
    try {
      return action();
    } catch (const std::invalid_argument& error) {
      throw BadParameter(key, key + " = '" + shown(text(key)) + "': " + error.what());
    }
  }

  /// One of the words in `accepted`; the first is the default of the second form.
  std::string word(const std::string& key, const std::vector<std::string_view>& accepted);
  std::string word_or_first(const std::string& key, const std::vector<std::string_view>& accepted);

  /// \throws std::invalid_argument if a key was given that nobody read
  void reject_unread() const;

  /// Adds a value that follows from others to the parameters, as "derived" and the key that it
  /// would have if it were given.
  void derive(const std::string& key, double value);

  /// What was read so far, and what was derived.
  const Parameters& parameters() const { return parameters_; }

  /// Adds a line, unless it is there, that the program tells its user, and puts into its tables.
  void warn(const std::string& line);
  const std::vector<std::string>& warnings() const { return warnings_; }

  /// What was read so far, and a "warning" for each: what tables show of their origin.
  Parameters origin() const;

 private:
  struct Place {
    std::string file;  ///< empty if there is none
    int line;
    std::string folder;
  };
  struct Value {
    std::string text;
    Place place;
    std::size_t order;  ///< among all keys, as they were first given
  };

  std::vector<std::optional<Eigen::VectorXd>> columns(const std::string& key,
                                                      const std::vector<FileColumn>& wanted);
  const Value& value(const std::string& key) const;
  void put(const std::string& key, const std::string& text, const Place& place);
  void remove(const std::string& key);

  std::map<std::string, Value> values_;
  std::size_t next_order_ = 0;
  Parameters parameters_;
  std::vector<std::string> warnings_;
  FileReader read_file_;
};

/// Calls an action on a scene; a message about one of its keys then begins with the key's place.
template <class Action>
auto with_places(const Scene& scene, Action action) {
  try {
    return action();
  } catch (const BadParameter& error) {
    throw std::invalid_argument(scene.place_of(error.key()) + error.what());
  }
}

}  // namespace microslip
