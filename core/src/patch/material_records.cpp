// SPDX-License-Identifier: GPL-3.0-or-later
#include "material_records.hpp"

#include <algorithm>
#include <iterator>

namespace microslip {

using Eigen::Index;
using Eigen::Vector2d;

namespace {

/// The last record is too close to the one before for a polynomial, by this part of their spacing.
constexpr double too_close = 0.2;

}  // namespace

MaterialRecords::MaterialRecords(double trailing, double leading, double least_spacing)
    : least_spacing_(least_spacing) {
  const auto count = static_cast<std::size_t>((leading - trailing) / least_spacing) + 4;
  for (std::size_t i = 0; i <= count; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(count);
    records_.push_back({trailing + part * (leading - trailing), Vector2d::Zero()});
  }
}

Vector2d MaterialRecords::at(double place) const {
  const Record &edge = records_.back(), &before = records_[records_.size() - 2];
  const double width = edge.place - before.place;
  const bool leaves_edge = records_.size() > 2 && width < too_close * least_spacing_;
  if (leaves_edge && place > before.place) {
    const double part = std::min(1.0, (place - before.place) / width);
    return (1 - part) * before.value + part * edge.value;
  }
  const auto size = static_cast<std::ptrdiff_t>(records_.size()) - (leaves_edge ? 1 : 0);
  const auto after = std::ranges::upper_bound(records_, place, {}, &Record::place);
  const auto last = size - 4;
  const auto first = std::clamp<std::ptrdiff_t>(after - records_.begin() - 2, 0,
                                                std::max<std::ptrdiff_t>(last, 0));
  const auto end = std::min<std::ptrdiff_t>(first + 4, size);
  Vector2d value = Vector2d::Zero();
  for (auto i = first; i < end; ++i) {
    const Record& one = records_[static_cast<std::size_t>(i)];
    double weight = 1;
    for (auto j = first; j < end; ++j) {
      if (j == i) continue;
      const double other = records_[static_cast<std::size_t>(j)].place;
      weight *= (place - other) / (one.place - other);
    }
    value += weight * one.value;
  }
  return value;
}

void MaterialRecords::enter(double place, const Vector2d& value) {
  const std::size_t size = records_.size();
  if (records_[size - 1].place >= place) {  // the edge has gone back in the material
    while (records_.size() > 2 && records_.back().place >= place) records_.pop_back();
  } else if (records_[size - 1].place - records_[size - 2].place < least_spacing_ * (1 - 1e-9)) {
    records_.pop_back();
  }
  records_.push_back({place, value});
}

void MaterialRecords::leave(double place) {
  const auto staying =
      std::ranges::find_if(records_, [&](const Record& r) { return r.place > place; });
  const auto gone = std::max<std::ptrdiff_t>(staying - records_.begin() - 2, 0);
  records_.erase(records_.begin(), records_.begin() + gone);
}

void MaterialRecords::change(const std::function<void(double, Vector2d&)>& by) {
  for (Record& record : records_) by(record.place, record.value);
}

void MaterialRecords::forget(double from, double to) {
  std::erase_if(records_, [&](const Record& r) { return r.place > from && r.place < to; });
}

bool MaterialRecords::has_room(double place, double distance) const {
  const auto after = std::ranges::upper_bound(records_, place, {}, &Record::place);
  return (after == records_.end() || after->place - place >= distance) &&
         (after == records_.begin() || place - std::prev(after)->place >= distance);
}

void MaterialRecords::add(double place, const Vector2d& value, double distance) {
  if (!has_room(place, distance)) return;
  records_.insert(std::ranges::upper_bound(records_, place, {}, &Record::place), {place, value});
}

void MaterialRecords::move(const std::function<double(double, Vector2d&)>& to) {
  for (Record& record : records_) record.place = to(record.place, record.value);
}

void MaterialRecords::archive(Archive& archive) {
  constexpr Index most = 1 << 20;
  auto count = static_cast<Index>(records_.size());
  archive.whole("records", count, 2, most);
  Eigen::VectorXd numbers(3 * count);
  for (Index i = 0; !archive.reads() && i < count; ++i) {
    const Record& record = records_[static_cast<std::size_t>(i)];
    numbers.segment<3>(3 * i) << record.place, record.value;
  }
  archive.numbers("material", numbers, 3 * count);
  archive.number("least_spacing", least_spacing_);
  if (!archive.reads()) return;
  records_.clear();
  for (Index i = 0; i < count; ++i) {
    records_.push_back({numbers[3 * i], numbers.segment<2>(3 * i + 1)});
  }
}

}  // namespace microslip
