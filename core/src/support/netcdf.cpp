// SPDX-License-Identifier: GPL-3.0-or-later
#include "microslip/support/netcdf.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <stdexcept>
#include <string_view>

namespace microslip {

namespace {

constexpr std::string_view magic{"CDF\001", 4};
enum Tag : std::uint32_t { absent = 0, dimension_tag = 10, variable_tag = 11, attribute_tag = 12 };
enum Type : std::uint32_t { text_type = 2, single_type = 5, double_type = 6 };

/// Numbers are big-endian, and texts end at multiples of four bytes.
class Writer {
 public:
  const std::string& bytes() const { return bytes_; }

  template <class Number>
  void put(Number number) {
    for (std::size_t i = sizeof number; i-- > 0;) {
      bytes_ += static_cast<char>(number >> (8 * i) & 0xff);
    }
  }
  void put_whole(std::size_t number) { put(static_cast<std::uint32_t>(number)); }
  void put_double(double number) { put(std::bit_cast<std::uint64_t>(number)); }
  void put_single(double number) { put(std::bit_cast<std::uint32_t>(static_cast<float>(number))); }

  void put_text(const std::string& text) {
    put_whole(text.size());
    bytes_ += text;
    while (bytes_.size() % 4 != 0) bytes_ += '\0';
  }

  void put_list(Tag tag, std::size_t size) {
    put_whole(size == 0 ? absent : tag);
    put_whole(size);
  }

  void put_attributes(const std::vector<NetcdfFile::Attribute>& attributes) {
    put_list(attribute_tag, attributes.size());
    for (const auto& [name, value] : attributes) {
      put_text(name);
      if (const auto* text = std::get_if<std::string>(&value)) {
        put_whole(text_type);
        put_text(*text);
      } else {
        put_whole(double_type);
        put_whole(1);
        put_double(std::get<double>(value));
      }
    }
  }

 private:
  std::string bytes_;
};

class Reader {
 public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {}

  void move_to(std::size_t place) { at_ = place; }

  template <class Number>
  Number take() {
    Number number = 0;
    for (const char byte : part(sizeof number)) {
      number = static_cast<Number>(number << 8) | static_cast<unsigned char>(byte);
    }
    return number;
  }
  std::size_t whole() { return take<std::uint32_t>(); }
  double double_precision() { return std::bit_cast<double>(take<std::uint64_t>()); }
  double single_precision() { return std::bit_cast<float>(take<std::uint32_t>()); }

  std::string text() {
    const std::size_t size = whole();
    const std::string found(part(size));
    part((4 - size % 4) % 4);
    return found;
  }

  /// The length of a list.
  std::size_t list(Tag tag) {
    const std::size_t found = whole(), size = whole();
    if (found != (size == 0 ? absent : tag) && found != tag) fail("a list");
    if (size > bytes_.size()) fail("a shorter list");
    return size;
  }

  std::vector<NetcdfFile::Attribute> attributes() {
    std::vector<NetcdfFile::Attribute> found;
    for (std::size_t left = list(attribute_tag); left > 0; --left) {
      std::string name = text();
      const std::size_t type = whole();
      if (type == text_type) {
        found.push_back({std::move(name), text()});
      } else if (type == double_type && whole() == 1) {
        found.push_back({std::move(name), double_precision()});
      } else {
        fail("attributes that are texts or single numbers");
      }
    }
    return found;
  }

  [[noreturn]] static void fail(std::string_view expected) {
    throw std::invalid_argument(fmt::format("not a table of netCDF: expected {}", expected));
  }

 private:
  std::string_view part(std::size_t size) {
    if (at_ > bytes_.size() || size > bytes_.size() - at_) fail("more bytes; the file is cut");
    at_ += size;
    return bytes_.substr(at_ - size, size);
  }

  std::string_view bytes_;
  std::size_t at_ = 0;
};

std::size_t size_of(const NetcdfFile& file, const NetcdfFile::Variable& variable) {
  std::size_t size = 1;
  for (const std::size_t dimension : variable.dimensions) {
    size *= file.dimensions[dimension].length;
  }
  return size;
}

/// \param begins  of the variables' values in the file
std::string head_of(const NetcdfFile& file, const std::vector<std::size_t>& begins) {
  Writer writer;
  for (const char byte : magic) writer.put(static_cast<std::uint8_t>(byte));
  writer.put_whole(0);  // records
  writer.put_list(dimension_tag, file.dimensions.size());
  for (const auto& [name, length] : file.dimensions) {
    writer.put_text(name);
    writer.put_whole(length);
  }
  writer.put_attributes(file.attributes);
  writer.put_list(variable_tag, file.variables.size());
  for (std::size_t i = 0; i < file.variables.size(); ++i) {
    const NetcdfFile::Variable& variable = file.variables[i];
    writer.put_text(variable.name);
    writer.put_whole(variable.dimensions.size());
    for (const std::size_t dimension : variable.dimensions) writer.put_whole(dimension);
    writer.put_attributes(variable.attributes);
    writer.put_whole(variable.is_single ? single_type : double_type);
    writer.put_whole(size_of(file, variable) * (variable.is_single ? 4 : 8));
    writer.put_whole(begins[i]);
  }
  return writer.bytes();
}

template <class Named>
const Named& named(const std::vector<Named>& among, const std::string& name, const char* kind) {
  const auto found = std::ranges::find(among, name, &Named::name);
  if (found == among.end()) {
    throw std::invalid_argument(fmt::format("expected a {} '{}' in the table", kind, name));
  }
  return *found;
}

}  // namespace

const NetcdfFile::Variable& NetcdfFile::variable(const std::string& name) const {
  return named(variables, name, "variable");
}

double NetcdfFile::number(const std::string& attribute) const {
  const auto* value = std::get_if<double>(&named(attributes, attribute, "number").value);
  if (value == nullptr) {
    throw std::invalid_argument(fmt::format("expected a number as '{}' of the table", attribute));
  }
  return *value;
}

std::size_t NetcdfFile::length(const std::string& dimension) const {
  return named(dimensions, dimension, "dimension").length;
}

std::string NetcdfFile::bytes() const {
  std::vector<std::size_t> begins(variables.size(), 0);
  std::size_t end = head_of(*this, begins).size();
  for (std::size_t i = 0; i < variables.size(); ++i) {
    begins[i] = end;
    end += size_of(*this, variables[i]) * (variables[i].is_single ? 4 : 8);
  }
  return head_of(*this, begins) + value_bytes();
}

std::string NetcdfFile::value_bytes() const {
  Writer values;
  for (const Variable& variable : variables) {
    if (variable.values.size() != size_of(*this, variable)) {
      throw std::invalid_argument(
          fmt::format("{}: expected as many values as its dimensions say", variable.name));
    }
    for (const double value : variable.values) {
      variable.is_single ? values.put_single(value) : values.put_double(value);
    }
  }
  return values.bytes();
}

NetcdfFile read_netcdf(const std::string& bytes) {
  if (!std::string_view(bytes).starts_with(magic)) Reader::fail("CDF and the version 1 in front");
  Reader reader(bytes);
  reader.move_to(magic.size());
  if (reader.whole() != 0) Reader::fail("no records");
  NetcdfFile file;
  for (std::size_t left = reader.list(dimension_tag); left > 0; --left) {
    std::string name = reader.text();
    const std::size_t length = reader.whole();
    if (length == 0 || length > bytes.size()) Reader::fail("dimensions of fixed length");
    file.dimensions.push_back({std::move(name), length});
  }
  file.attributes = reader.attributes();
  std::vector<std::size_t> begins;
  for (std::size_t left = reader.list(variable_tag); left > 0; --left) {
    NetcdfFile::Variable variable{.name = reader.text()};
    for (std::size_t rank = reader.whole(); rank > 0; --rank) {
      variable.dimensions.push_back(reader.whole());
      if (variable.dimensions.back() >= file.dimensions.size()) Reader::fail("its dimensions");
    }
    variable.attributes = reader.attributes();
    const std::size_t type = reader.whole();
    if (type != single_type && type != double_type) Reader::fail("real numbers");
    variable.is_single = type == single_type;
    reader.whole();
    begins.push_back(reader.whole());
    file.variables.push_back(std::move(variable));
  }
  for (std::size_t i = 0; i < begins.size(); ++i) {
    NetcdfFile::Variable& variable = file.variables[i];
    std::size_t size = 1;
    for (const std::size_t dimension : variable.dimensions) {
      size *= file.dimensions[dimension].length;
      if (size > bytes.size()) Reader::fail("more bytes; the file is cut");
    }
    reader.move_to(begins[i]);
    variable.values.resize(size);
    for (double& value : variable.values) {
      value = variable.is_single ? reader.single_precision() : reader.double_precision();
    }
  }
  return file;
}

}  // namespace microslip
