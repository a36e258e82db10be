// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>
#include <iosfwd>
#include <map>
#include <memory>
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

struct Key;

/// A warning about a doubtful value.
struct Warning {
  std::string key;
  std::string line;  ///< "<key> = <value>: ..."
};

/// A warning's line without its value and other numbers, alike for cases of a sweep that are warned
/// of for the same reason.
std::string kind_of_warning(const std::string& line);

/// A key that a scene needs and does not have.
class MissingKey : public BadParameter {
 public:
  /// \param name  a given key that may be a misspelt one; may be empty
  /// \param alternatives  keys of which one is needed
  MissingKey(const std::string& name, const std::vector<std::string>& alternatives,
             const std::string& hint);

  const std::vector<std::string>& alternatives() const { return alternatives_; }
  const std::string& hint() const { return hint_; }

 private:
  std::vector<std::string> alternatives_;
  std::string hint_;
};

/// A column of a table file.
struct FileColumn {
  FileColumn(const char* name_, const char* unit_, bool needed_ = true)
      : name(name_), unit(unit_), needed(needed_) {}

  std::string name;
  std::string unit;  ///< unit of the values that are returned, and of a column without a unit
  bool needed;
  std::string in_file = "";       ///< its name in the file; empty if the name is the same there
  std::string unit_without = "";  ///< unit of a column without one in the file; empty: `unit`
};

/// The input of a program: dotted keys with text values, read strictly. Every reader below converts
/// a value or throws BadParameter; if there is no such key, std::invalid_argument. The message is
/// one line that names the key; with_places() adds file and line. reject_unread() rejects keys that
/// were not read.
class Scene {
 public:
  /// Largest number of bytes of a scene's text; a scene holds some dozens of keys.
  static constexpr std::size_t most_text = 1 << 20;

  /// Returns the text of a file. \throws std::invalid_argument if the file cannot be read
  using FileReader = std::function<std::string(const std::string& path)>;

  /// Reads a property tree in INFO format, without its `#include`: at most most_text bytes of
  /// UTF-8, with lines that end in LF or CRLF.
  /// \param name    name of the source, for messages
  /// \param folder  base of relative file names in the scene; ends in '/' unless empty
  static Scene parse(std::istream& in, const std::string& name, const std::string& folder = "");

  /// Declares further keys, which take precedence over keys of scenes with the same name. The
  /// readers below check the ranges of declared keys; the model checks the ranges of scene keys.
  void declare(std::vector<Key> keys);

  /// The last declared key of this name, otherwise the key of scenes; null if there is neither.
  const Key* known(std::string_view key) const;

  /// The unit of a key in this scene.
  std::string unit_of(const std::string& key) const;

  /// Whether the contact has three dimensions, in this scene or in all or some cases of its sweep.
  bool has_patch() const;

  /// Sets the reader of files. Without a reader, no key may name a file.
  void read_files_by(FileReader reader) { read_file_ = std::move(reader); }

  /// Takes over all keys of the other scene, replacing values of the same keys.
  void overlay(const Scene& other);

  /// \param assignment  "key.sub=value". A value replaces the key and removes "sweep.key.sub". An
  ///                    empty value removes both keys, at least one of which must be there
  void set(std::string_view assignment);

  /// Removes all keys below a section. \return a scene with these keys, without the section's name
  Scene take_section(const std::string& section);

  /// Replaces the text of an existing key; a relative file name refers to the same folder.
  void replace(const std::string& key, const std::string& text);

  bool has(const std::string& key) const { return values_.count(key) != 0; }

  /// The same, as a reader asks: the key counts as one that has a part here, given or not.
  bool has(const std::string& key);

  /// All keys, in the order in which they were first given.
  std::vector<std::string> keys() const;

  /// File and line of a key, for the front of a message: "scene.info:14: ". Empty if there is no
  /// such key, or if set() gave the key.
  std::string place_of(const std::string& key) const;

  /// The text of a key as it was given. \throws std::invalid_argument if there is no such key
  const std::string& text(const std::string& key) const { return value(key).text; }

  /// The one key that is given among keys that exclude each other; empty if none is given.
  /// \throws std::invalid_argument if two are given
  std::string at_most_one_of(const std::vector<std::string>& keys) const;

  /// The same, as a reader asks.
  std::string at_most_one_of(const std::vector<std::string>& keys);

  /// The same. \throws std::invalid_argument also if none is given
  std::string one_of(const std::vector<std::string>& keys);

  /// A finite decimal number, with a point in any locale: 1.5, .5, +5, -1e-3. A number too small
  /// for a double, 1e-400, is rejected like one that is too large. A unit may follow the number,
  /// which is then converted to the unit of the key: "2 cm" of a length is 20. A missing key gives
  /// the key's default.
  double number(const std::string& key);
  double number(const std::string& key, double fallback);

  /// A number above zero.
  double positive(const std::string& key);

  /// A list of finite numbers, separated by blanks; not empty. For a key with a unit, as for
  /// quantities(). Ranges are those of swept_values().
  std::vector<double> numbers(const std::string& key);

  /// A whole number, also as 1e5.
  Eigen::Index whole(const std::string& key);

  /// A list of whole numbers, separated by blanks; not empty.
  std::vector<Eigen::Index> wholes(const std::string& key);

  /// Rejects a value of a known key, naming the accepted values, unless `holds`.
  /// \throws std::logic_error if the key is not known; word() likewise
  void demand(const std::string& key, double value, bool holds) const;
  void demand_in_range(const std::string& key, double value) const;

  /// Reads columns of numbers from the table file that the key names, and returns the result of
  /// `use`. The file has a line of column names, with optional units, "q [mm]", "q[mm]" or "q
  /// (mm)", then rows. Cells are separated by commas, semicolons, tabs or blanks; lines that begin
  /// with # are comments. Numbers have a decimal point or a decimal comma, all the same. Other
  /// columns may hold anything. Where a column is optional, the scene warns of others, unless their
  /// names begin with _, and one of nearly the name of a wanted column is an error. Messages name
  /// key, file and, if there is one, line.
  ///
  /// \param use  called with the wanted columns; an optional column that is missing is empty
  template <class Use>
  auto from_columns(const std::string& key, const std::vector<FileColumn>& wanted, Use use) {
    return with_file(key, [&] { return use(columns(key, wanted)); });
  }

  /// The names of all columns of the table file that the key names.
  std::vector<std::string> column_names(const std::string& key);

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

  /// The text of a key that may have any.
  std::string free_text(const std::string& key);

  /// One of the words of a known key. A missing key gives the key's default.
  std::string word(const std::string& key);

  /// One or more of the words of a known key, separated by blanks. A missing key gives the default.
  std::vector<std::string> words(const std::string& key);

  /// Rejects a given key that was not read. The message has the likely spelling, or all keys that
  /// readers of this scene have read or asked for.
  void reject_unread() const;

  /// The first given key that no scene has, of nearly the name of one; empty if there is none.
  std::string misspelt() const;

  /// Adds a value that follows from other values to the parameters, under "derived" and the key
  /// that would give the value.
  void derive(const std::string& key, double value);

  /// The parameters read or derived so far.
  const Parameters& parameters() const { return parameters_; }

  /// Adds a warning, unless it is there already. The program shows warnings and puts them into
  /// tables.
  void warn(const std::string& key, double value, const std::string& doubt);
  void warn(const std::string& key, const std::string& value, const std::string& doubt);
  const std::vector<Warning>& warnings() const { return warnings_; }

  /// The parameters read so far, and a "warning" for each warning, as shown in tables. Places are
  /// left out, so that the same scene in another file has the same tables.
  Parameters origin() const;

 private:
  struct Place {
    std::string file;  ///< empty if set() gave the value
    int line;
    std::string folder;
  };
  struct Value {
    std::string text;
    Place place;
    std::size_t order;  ///< of the key among all keys, as first given
  };

  std::vector<std::optional<Eigen::VectorXd>> columns(const std::string& key,
                                                      const std::vector<FileColumn>& wanted);
  const Value& value(const std::string& key) const;
  std::string text_of_words(const std::string& key) const;
  void require_word(const std::string& key, const std::string& word) const;
  void put(const std::string& key, const std::string& text, const Place& place);
  void expand_ranges(const std::string& key);
  void remove(const std::string& key);
  const Key& declared(const std::string& key) const;
  void hold_to_range(const std::string& key, double value) const;
  void record(const std::string& key, const std::string& value);
  void ask(const std::string& key);
  std::vector<std::string> keys_with_a_part() const;

  std::map<std::string, Value> values_;
  std::size_t next_order_ = 0;
  Parameters parameters_;
  std::vector<std::string> asked_;  ///< by readers, given or not, each once
  std::vector<Warning> warnings_;
  std::vector<std::shared_ptr<const std::vector<Key>>> declared_;
  FileReader read_file_;
};

/// The error of a missing key with the names of all that are missing, as far as they can be told
/// without a value of those before them: the way a scene is read depends on words and files.
/// \param scene  that was read
/// \param read   reads it; called again, with values for the missing keys
BadParameter all_missing(const Scene& scene, const MissingKey& first,
                         const std::function<void(Scene&)>& read);

/// Turns the error of an argument of core into the error of the key that gives the argument:
/// "half_width = -1 ..." becomes "contact.half_width = -1 ...". Other errors are returned
/// unchanged.
BadParameter in_keys(const BadParameter& error);

/// The same for a scene, where several keys may give an argument. A misspelt key comes first: other
/// keys may be wrong only because it was not read.
BadParameter in_keys(const BadParameter& error, const Scene& scene);

/// Calls an action; a message about an argument that a key gives is then about the key.
template <class Action>
auto with_keys(Action action) {
  try {
    return action();
  } catch (const BadParameter& error) {
    throw in_keys(error);
  }
}

/// Calls an action on a scene; a message about one of its keys, or about an argument that a key
/// gives, then begins with the key's place and name.
template <class Action>
auto with_places(const Scene& scene, Action action) {
  try {
    return action();
  } catch (const BadParameter& error) {
    const BadParameter named = in_keys(error, scene);
    throw std::invalid_argument(scene.place_of(named.name()) + named.what());
  }
}

}  // namespace microslip
