// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_ellipse.hpp"

#include <numbers>
#include <string_view>

namespace microslip::experiments {

namespace {

constexpr auto states = std::to_array<ContactState>({
    {"longitudinal",
     0.2,
     {{{-0.057273, 0.000000}, {-0.056717, 0.000000}, {-0.056721, 0.000000}}},
     {-0.055886, 0.000000}},
    {"longitudinal",
     0.5,
     {{{-0.130464, 0.000000}, {-0.129022, 0.000000}, {-0.129026, 0.000000}}},
     {-0.126872, 0.000000}},
    {"longitudinal",
     1,
     {{{-0.219412, 0.000000}, {-0.217779, 0.000000}, {-0.217232, 0.000000}}},
     {-0.214597, 0.000000}},
    {"longitudinal",
     2,
     {{{-0.296185, 0.000000}, {-0.295463, 0.000000}, {-0.294957, 0.000000}}},
     {-0.293583, 0.000000}},
    {"longitudinal",
     4,
     {{{-0.299904, 0.000000}, {-0.299903, 0.000000}, {-0.299902, 0.000000}}},
     {-0.299901, 0.000000}},
    {"lateral",
     0.2,
     {{{-0.057516, 0.019389}, {-0.056922, 0.019434}, {-0.056869, 0.019446}}},
     {-0.055950, 0.019540}},
    {"lateral",
     0.5,
     {{{-0.130599, 0.034515}, {-0.129192, 0.034957}, {-0.129028, 0.034959}}},
     {-0.126867, 0.035423}},
    {"lateral",
     1,
     {{{-0.219064, 0.035271}, {-0.217259, 0.036101}, {-0.216532, 0.036354}}},
     {-0.213532, 0.037604}},
    {"lateral",
     2,
     {{{-0.295371, 0.009253}, {-0.294561, 0.009923}, {-0.294016, 0.010359}}},
     {-0.292531, 0.011567}},
    {"lateral",
     4,
     {{{-0.299923, 0.003019}, {-0.299923, 0.003041}, {-0.299922, 0.003050}}},
     {-0.299921, 0.003068}},
    {"spin",
     0.2,
     {{{-0.059779, -0.042534}, {-0.058981, -0.041053}, {-0.059434, -0.041102}}},
     {-0.058653, -0.039705}},
    {"spin",
     0.5,
     {{{-0.135327, -0.081695}, {-0.135327, -0.080853}, {-0.135264, -0.080167}}},
     {-0.134941, -0.078509}},
    {"spin",
     1,
     {{{-0.179413, -0.120657}, {-0.180331, -0.120340}, {-0.180936, -0.120156}}},
     {-0.182203, -0.119773}},
    {"spin",
     2,
     {{{-0.130987, -0.147251}, {-0.131269, -0.147148}, {-0.131422, -0.147091}}},
     {-0.131715, -0.146945}},
    {"spin",
     4,
     {{{-0.083477, -0.164730}, {-0.083296, -0.164725}, {-0.083028, -0.164768}}},
     {-0.082336, -0.164828}},
});

const Material material{1, 0.28};
const EllipticBound circle(1, 1, 0.45 / std::numbers::pi);

}  // namespace

std::span<const ContactState> contact_states() { return states; }

SteadyPatch patch_of(const ContactState& state, Eigen::Index rows, Eigen::Index elements) {
  SteadyPatch patch{.material = material, .bound = circle, .rows = rows, .elements = elements};
  const std::string_view kind(state.kind);
  if (kind == "longitudinal") patch.load[0].value = 0.07 * state.level;
  if (kind == "lateral") patch.load[1].value = 0.08 * state.level;
  if (kind == "spin") patch.load[2].value = 0.2 * state.level;
  return patch;
}

StandardPatch contact_rectangles(Eigen::Index elements) {
  return {.material = material, .bound = circle, .elements = elements, .rows = elements};
}

}  // namespace microslip::experiments
