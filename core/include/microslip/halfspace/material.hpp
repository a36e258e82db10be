// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace microslip {

/// Combined elastic constants of two quasi-identical bodies.
struct Material {
  double shear_modulus;  ///< G, in (0, inf)   [N/mm^2]
  double poisson_ratio;  ///< nu, in [0, 0.5]; in the material lateral(), in [-1, 0.5]  [1]
};

/// \throws std::invalid_argument unless G > 0 and nu is in [0, 0.5]
void validate(const Material& material);

/// \throws std::invalid_argument unless G > 0 and nu is in [-1, 0.5]
void validate_also_lateral(const Material& material);

/// The constants G/(1 - nu) and -nu/(1 - nu). With them, the formula for the longitudinal
/// displacement due to a longitudinal line load gives the lateral displacement due to a lateral
/// line load. In plane strain both are logarithms, here with the factor 2/(pi G). On a strip of
/// width 2h with G and nu the lateral displacement is
/// \f[ \frac{2}{\pi G}\,\operatorname{arsinh}\frac hz
///    - \frac{2\nu}{\pi G}\,\frac{h}{\sqrt{z^2+h^2}} . \f]
Material lateral(const Material& material);

/// Two bodies of different material. Goodman's approximation is assumed: tangential tractions have
/// no influence on the normal contact.
struct Bodies {
  Material combined;
  double dundurs_beta = 0;  ///< beta, in [-0.5, 0.5]; > 0 if the second body is the softer one  [1]
};

/// Combined constants of two materials: 1/G and nu/G are means over the bodies, and
/// beta = [(1 - 2 nu_2)/G_2 - (1 - 2 nu_1)/G_1] / 2 [(1 - nu_1)/G_1 + (1 - nu_2)/G_2].
/// \param first  the body that the creepage drives, and on which the tractions act
Bodies combined(const Material& first, const Material& second);

/// The strain difference du/dx of the two surfaces due to the pressure, in plane strain, over mu
/// times that pressure: 2 (1 - nu) beta/(G mu)  [mm^2/N]
/// \param friction  mu, > 0
double pressure_strain(const Bodies& bodies, double friction);

/// 2 (1 - nu) / G, the half-space's strain per unit of a traction's size in plane strain  [mm^2/N].
double compliance(const Material& material);

}  // namespace microslip
