// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>
#include <iosfwd>
#include <map>
#include <optional>
#include <span>
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

struct Key;

/// A doubt about a value.
struct Warning {
  std::string key;
  std::string line;  ///< "<key> = <value>: ..."
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

  /// Keys of a reader's own, besides those of scenes, and in front of these where names are the
  /// same. Readers below hold values to their ranges; those of scenes are the models' matter.
  /// \param keys  that live as long as the scene and its copies
  void declare(std::span<const Key> keys) { declared_.push_back(keys); }

  /// A key that was declared last, or else is one of scenes; null if it is neither.
  const Key* known(std::string_view key) const;

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
  /// is converted to that of the key: "2 cm" of a length is 20. Not given, it is the key's default.
  double number(const std::string& key);
  double number(const std::string& key, double fallback);

  /// A number above zero.
  double positive(const std::string& key);

  /// A list of them, separated by blanks; not empty. Of a key with a unit, as quantities() takes
  /// it.
  std::vector<double> numbers(const std::string& key);

  /// A whole number, also as 1e5.
  Eigen::Index whole(const std::string& key);

  /// A list of them, separated by blanks; not empty.
  std::vector<Eigen::Index> wholes(const std::string& key);

  /// Rejects a value of a known key by what that accepts, unless it `holds`.
  /// \throws std::logic_error if the key is not known; word() likewise
  void demand(const std::string& key, double value, bool holds) const;
  void demand_in_range(const std::string& key, double value) const;

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

  /// The text of the file that the key names.
  std::string file(const std::string& key);

  /// Calls an action; a message of its std::invalid_argument then begins with key and file.
  template <class Action>
  auto with_file(const std::string& key, Action action) const {
    try {
      return action();
    } catch (const std::invalid_argument& error) {
      throw BadParameter(key, key + " = '" + shown(text(key)) + "': " + error.what());
    }
  }

  /// One of the words of a known key. Not given, it is the key's default.
  std::string word(const std::string& key);

  /// \throws std::invalid_argument if a key was given that nobody read
  void reject_unread() const;

  /// Adds a value that follows from others to the parameters, as "derived" and the key that it
  /// would have if it were given.
  void derive(const std::string& key, double value);

  /// Parameters that were read or derived so far.
  const Parameters& parameters() const { return parameters_; }

  /// Adds a line, unless it is there, that the program tells its user, and puts into its tables.
  void warn(const std::string& key, double value, const std::string& doubt);
  const std::vector<Warning>& warnings() const { return warnings_; }

  /// Parameters that were read so far, and a "warning" for each warning, as tables show them. No places,
  /// so that the same scene in another file has the same tables.
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
  const Key& declared(const std::string& key) const;
  std::string unit_of(const std::string& key) const;
  void hold_to_range(const std::string& key, double value) const;
  void record(const std::string& key, const std::string& value);

  std::map<std::string, Value> values_;
  std::size_t next_order_ = 0;
  Parameters parameters_;
  std::vector<Warning> warnings_;
  std::vector<std::span<const Key>> declared_;
  FileReader read_file_;
};

/// The error of an argument of core as the error of the key that gives it: "half_width = -1 ..." is
/// "contact.half_width = -1 ...". Other errors are returned as they are.
BadParameter in_keys(const BadParameter& error);

/// Calls an action on a scene; a message about one of its keys, or about an argument that a key
/// gives, then begins with the key's place and name.
template <class Action>
auto with_places(const Scene& scene, Action action) {
  try {
    return action();
  } catch (const BadParameter& error) {
    const BadParameter of_key = in_keys(error);
    throw std::invalid_argument(scene.place_of(of_key.name()) + of_key.what());
  }
}

}  // namespace microslip
