// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "microslip/scene/keys.hpp"
#include "microslip/scene/scene.hpp"

namespace microslip::experiments {

/// A condition on the values of a key, besides the range of each. The note states it in lists of
/// keys and in messages; a note alone is for a condition that the reader of the study checks.
struct Demand {
  constexpr Demand(const char* note_ = "", bool (*holds_)(double value) = nullptr,
                   bool (*follows_)(double value, double before) = nullptr, std::size_t least_ = 1)
      : note(note_), holds(holds_), follows(follows_), least(least_) {}

  std::string_view note;
  bool (*holds)(double value);                   ///< for each value; may be null
  bool (*follows)(double value, double before);  ///< for each but the first; may be null
  std::size_t least;                             ///< number of values
};

constexpr bool is_odd(double value) { return static_cast<Eigen::Index>(value) % 2 == 1; }
constexpr bool is_above(double value, double before) { return value > before; }
constexpr bool is_at_most(double value, double before) { return value <= before; }
constexpr bool is_twice(double value, double before) { return value == 2 * before; }

inline constexpr Demand odd("odd", is_odd), rising("in rising order", nullptr, is_above),
    falling("in falling order", nullptr, is_at_most),
    three_or_more("three or more", nullptr, nullptr, 3),
    two_or_more_rising("two or more, in rising order", nullptr, is_above, 2),
    two_or_more_doubling("two or more, each twice the one before", nullptr, is_twice, 2);

/// Leads to a member of a member: in(&P::cylinder, &Cylinder::mass).
template <class Outer, class Inner>
auto in(Outer outer, Inner inner) {
  return [=](auto& p) -> auto& { return p.*outer.*inner; };
}

void demand(const Scene& scene, const std::string& key, const Demand& demanded,
            const std::vector<double>& values);

/// Reads a key as its type says, and demands what is demanded.
std::vector<double> read_values(Scene& scene, const Key& key, const Demand& demanded);

template <class Value>
constexpr Key::Type type_of = std::is_same_v<Value, double>                ? Key::Type::number
                              : std::is_arithmetic_v<Value>                ? Key::Type::whole
                              : std::is_same_v<Value, std::vector<double>> ? Key::Type::list
                                                                           : Key::Type::wholes;

/// The keys of a study in the order in which they are read, each beside the parameter that it sets:
/// a member of P. The type of the member is the type of the key.
template <class P>
class StudyKeys {
 public:
  struct Entry {
    /// \param member  pointer to a member, or in()
    template <class Member>
    Entry(Member member, const char* name, const char* unit, const char* meaning,
          microslip::Range range, const Demand& demand = {})
        : key{name, type_of<Value<Member>>, unit, meaning, range, demand.note},
          demanded(demand),
          set([member](P& p, const std::vector<double>& values) {
            auto& target = std::invoke(member, p);
            if constexpr (std::is_arithmetic_v<Value<Member>>) {
              target = static_cast<Value<Member>>(values.front());
            } else {
              target.assign(values.begin(), values.end());
            }
          }) {}

    template <class Member>
    Entry(Member member, const char* name, const char* meaning, microslip::Range range,
          const Demand& demand = {})
        : Entry(member, name, "1", meaning, range, demand) {}

    /// A key of scenes, which has unit, meaning and range there.
    template <class Member>
    Entry(Member member, const char* name) : Entry(member, name, "", {}) {}

    template <class Member>
    using Value = std::remove_reference_t<std::invoke_result_t<Member, P&>>;

    Key key;
    Demand demanded;
    std::function<void(P& p, const std::vector<double>& values)> set;
  };

  /// Declares all keys, so that messages about any key know them.
  StudyKeys(Scene& scene, std::vector<Entry> entries)
      : scene_(scene), entries_(std::move(entries)) {
    std::vector<Key> own;
    for (const Entry& entry : entries_) {
      if (!entry.key.meaning.empty()) own.push_back(entry.key);
    }
    scene.declare(std::move(own));
  }

  /// \param p  has all other parameters
  P read(P p) const {
    for (const Entry& entry : entries_) {
      entry.set(p, read_values(scene_, entry.key, entry.demanded));
    }
    return p;
  }

 private:
  Scene& scene_;
  std::vector<Entry> entries_;
};

}  // namespace microslip::experiments
