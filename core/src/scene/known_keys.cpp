// SPDX-License-Identifier: GPL-3.0-or-later
#include "known_keys.hpp"

#include <cmath>
#include <stdexcept>

#include "microslip/scene/keys.hpp"

namespace microslip {

namespace {

const Key& known(std::string_view name) {
  const Key* key = find_key(name);
  if (key == nullptr) throw std::logic_error("no key of scenes: " + std::string(name));
  return *key;
}

}  // namespace

std::string known_word(Scene& scene, std::string_view key) {
  const Key& found = known(key);
  const std::string name(key);
  return found.first_is_default ? scene.word_or_first(name, words_of(found))
                                : scene.word(name, words_of(found));
}

double known_number(Scene& scene, std::string_view key) {
  const double fallback = known(key).fallback;
  if (std::isnan(fallback)) throw std::logic_error("no default: " + std::string(key));
  return scene.number(std::string(key), fallback);
}

}  // namespace microslip
