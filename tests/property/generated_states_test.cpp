// SPDX-License-Identifier: GPL-3.0-or-later
// A transient that is saved somewhere on its way, and restored into another one, goes on to the
// bit: on contacts, loads, steps and shifts that nobody chose.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "microslip/rolling/transient.hpp"
#include "microslip/support/not_converged.hpp"
#include "property/generated_contacts.hpp"
#include "property/samples.hpp"

namespace microslip::generated_states_test {

using Eigen::Index;

/// The bits of a state's numbers; -0 is another one than 0.
std::vector<double> numbers_of(const TransientState& state) {
  const Evidence& e = state.evidence;
  std::vector<double> all{state.distance,
                          state.scale.half_width,
                          state.scale.bound,
                          state.force,
                          state.creepage,
                          state.dissipation,
                          state.end_dissipation,
                          state.mean_force,
                          static_cast<double>(state.iterations),
                          static_cast<double>(state.adhesion_elements),
                          static_cast<double>(state.slip_elements),
                          e.residual,
                          e.excess,
                          e.backward,
                          e.unresolved,
                          e.dissipated,
                          e.load,
                          e.power,
                          e.full_sliding};
  all.insert(all.end(), state.traction.begin(), state.traction.end());
  all.insert(all.end(), state.slip.begin(), state.slip.end());
  for (const Zone zone : state.zones) all.push_back(static_cast<double>(zone));
  return all;
}

/// Something that happens to a contact that rolls.
struct Event {
  enum class Kind { step, attempt, attempt_with_slopes, shift, start } kind;
  double length;
  Load load;
  ContactScale scale;
};

/// Generates what happens: a load that wanders, by creepage or by force, steps of whole elements
/// and odd ones, forth and back, and, if the contact changes, its size, down to none.
class EventGenerator {
 public:
  EventGenerator(unsigned seed, const SteadyContact& contact, double spacing, bool changes)
      : random_(seed),
        spacing_(spacing),
        creepage_(steady_creepage(contact)),
        full_(full_sliding_force(contact.bound)),
        changes_(changes) {}

  Event next() {
    if (chance(0.05)) by_force_ = !by_force_;
    if (chance(0.1)) level_ = uniform(-1.5, 1.5);
    if (chance(0.1)) whole_ = !whole_;
    if (chance(0.06)) direction_ = -direction_;
    if (changes_ && chance(0.3)) {
      const bool lost = chance(0.05);
      scale_ = {lost ? 0 : uniform(0.6, 1.4), uniform(0.5, 1.5)};
    }
    Event event{.kind = Event::Kind::step,
                .length = direction_ * spacing_ * (whole_ ? 1 : uniform(0.02, 2.5)),
                .load = load(),
                .scale = scale_};
    if (chance(0.03)) {
      event.kind = Event::Kind::shift;
      if (!by_force_) event.load = PrescribedCreepage{level_ * creepage_ * spacing_};
    } else if (chance(0.1)) {
      event.kind = chance(0.5) ? Event::Kind::attempt : Event::Kind::attempt_with_slopes;
    }
    return event;
  }

 private:
  Load load() {
    const double size = level_ * uniform(0.9, 1.1);
    if (!by_force_) return PrescribedCreepage{size * creepage_};
    return PrescribedForce{scale_.carries() ? size / 2 * full_ * scale_.full_sliding() : 0};
  }
  double uniform(double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random_);
  }
  bool chance(double of) { return uniform(0, 1) < of; }

  std::mt19937 random_;
  double spacing_, creepage_, full_;
  bool changes_, by_force_ = false, whole_ = true;
  double level_ = 1, direction_ = 1;
  ContactScale scale_;
};

/// Returns the answer of the event, or the text of its error. An attempt is followed by its step at
/// times.
std::string happens(TransientRolling& rolling, const Event& event, std::vector<double>& answers) {
  answers.clear();
  try {
    rolling.set_contact(event.scale);
    StepJacobian jacobian;
    switch (event.kind) {
      case Event::Kind::shift: {
        const auto* creepage = std::get_if<PrescribedCreepage>(&event.load);
        const Shift shift =
            rolling.shift(creepage != nullptr ? ShiftLoad(PrescribedShift{creepage->value})
                                              : ShiftLoad(std::get<PrescribedForce>(event.load)));
        answers = {shift.distance, shift.dissipation, shift.work};
        break;
      }
      case Event::Kind::attempt:
        answers = numbers_of(rolling.attempt(event.length, event.load));
        return "";
      case Event::Kind::attempt_with_slopes:
        answers = numbers_of(rolling.attempt(event.length, event.load, jacobian));
        for (const double slope : {jacobian.by_load.force, jacobian.by_load.creepage}) {
          answers.push_back(std::isnan(slope) ? HUGE_VAL : slope);  // of a force on a lost contact
        }
        return "";
      default:
        rolling.step(event.length, event.load);
    }
    const std::vector<double> state = numbers_of(rolling.state());
    answers.insert(answers.end(), state.begin(), state.end());
    return "";
  } catch (const std::invalid_argument& error) {
    return error.what();
  } catch (const NotConverged& error) {
    return error.what();
  }
}

class GeneratedStates : public testing::TestWithParam<int> {};

// Elements below and above those from where on products are made by FFT.
INSTANTIATE_TEST_SUITE_P(Elements, GeneratedStates, testing::Values(7, 30, 95, 96, 200));

TEST_P(GeneratedStates, GoOnToTheBit) {
  const Index n = GetParam();
  ContactGenerator generator(seed_of_tests() + 9000);
  std::mt19937 random(seed_of_tests() + static_cast<unsigned>(n));
  const int cases = samples(n < 100 ? 24 : 12);
  int changes = 0, errors = 0;
  for (int i = 0; i < cases; ++i) {
    const auto [kind, contact] = generator.next();
    if (contact.kernel.plane_length().value_or(HUGE_VAL) < 2 * half_width) continue;
    const TransientProblem problem{.contact = contact,
                                   .grid = Grid({.half_width = half_width, .elements = n}),
                                   .basis = constant_basis(),
                                   .scheme = Remembered{}};
    SCOPED_TRACE(kind + ", case " + std::to_string(i));
    EventGenerator events(static_cast<unsigned>(random()), contact, problem.grid.spacing(),
                          i % 3 == 2);
    const Start start = i % 4 == 1
                            ? Start(CattaneoShift{std::get<PrescribedForce>(contact.load).value})
                            : Start(Rest{});
    TransientRolling one(problem, start);
    std::vector<double> answers, others;
    const int before = std::uniform_int_distribution<int>(0, 150)(random);
    Event last{};
    for (int k = 0; k < before; ++k) happens(one, last = events.next(), answers);

    const std::string saved = one.save();
    EXPECT_EQ(one.save(), saved);
    TransientRolling other(problem, SavedState{saved});
    EXPECT_EQ(other.save(), saved);
    EXPECT_EQ(numbers_of(other.state()), numbers_of(one.state()));
    EXPECT_EQ(other.elastic_energy(), one.elastic_energy());
    for (int k = 0; k < 200; ++k) {
      // First the step that was tried, which must not be solved again.
      Event event = k == 0 && before > 0 ? last : events.next();
      if (k == 0) event.kind = Event::Kind::step;
      const int zones = static_cast<int>(one.state().adhesion_elements);
      const std::string error = happens(one, event, answers);
      ASSERT_EQ(happens(other, event, others), error) << "event " << k;
      ASSERT_EQ(others, answers) << "event " << k << " after " << before;
      changes += zones == one.state().adhesion_elements ? 0 : 1;
      errors += error.empty() ? 0 : 1;
    }
    EXPECT_EQ(other.traction_at_nodes(), one.traction_at_nodes());
    EXPECT_EQ(other.save(), one.save());
    EXPECT_EQ(other.condition(), one.condition());
  }
  EXPECT_GT(changes, 100);  // or nothing would have been tried
  EXPECT_LT(errors, 20 * cases);
}

}  // namespace microslip::generated_states_test
