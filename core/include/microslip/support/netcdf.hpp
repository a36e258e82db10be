// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

namespace microslip {

/// The contents of a file in netCDF's classic format (CDF-1, Unidata), as far as tables need it:
/// dimensions of fixed length, attributes that are texts or numbers, and variables of double or
/// single precision. Python's scipy and xarray, MATLAB, Octave, Julia, R and Fortran read it. We
/// write it by our own few lines, as the library netCDF would bring HDF5 and curl into every program
/// that links a contact.
struct NetcdfFile {
  struct Attribute {
    std::string name;
    std::variant<std::string, double> value;
  };
  struct Dimension {
    std::string name;
    std::size_t length;
  };
  struct Variable {
    std::string name;
    std::vector<std::size_t> dimensions =
        {};  ///< places in the list below, the last one runs first
    std::vector<Attribute> attributes = {};
    std::vector<double> values = {};
    bool is_single = false;  ///< stored in single precision
  };

  std::vector<Dimension> dimensions = {};
  std::vector<Attribute> attributes = {};
  std::vector<Variable> variables = {};

  /// \throws std::invalid_argument for a name that is not there
  const Variable& variable(const std::string& name) const;
  double number(const std::string& attribute) const;
  std::size_t length(const std::string& dimension) const;

  /// The bytes of the file.
  std::string bytes() const;

  /// Its last part, the values of all variables.
  std::string value_bytes() const;
};

/// \throws std::invalid_argument, in one line, for bytes that are no such file, or are cut
NetcdfFile read_netcdf(const std::string& bytes);

}  // namespace microslip
