#pragma once

// Part of ifc_model.cpp: the plain values of IfcPlusPlus's objects.

#include "../building.hpp"

#include <ifcpp/IFC4/include/IfcCartesianPoint.h>
#include <ifcpp/IFC4/include/IfcDirection.h>
#include <ifcpp/IFC4/include/IfcGloballyUniqueId.h>
#include <ifcpp/IFC4/include/IfcLabel.h>
#include <ifcpp/IFC4/include/IfcLengthMeasure.h>
#include <ifcpp/IFC4/include/IfcReal.h>

#include <cmath>
#include <cwctype>
#include <stdexcept>

namespace opal::ifc_importer::ifcpp {

/// What keeps one item from becoming a body; the message goes into the report.
struct Unreadable : std::runtime_error {
  using std::runtime_error::runtime_error;
};

inline void append_utf8(std::string& text, char32_t c) {
  if (c < 0x20 || (c >= 0xD800 && c < 0xE000) || c > 0x10FFFF) c = c == '\t' ? U' ' : U'?';
  if (c < 0x80) {
    text += static_cast<char>(c);
    return;
  }
  const int tails = c < 0x800 ? 1 : c < 0x10000 ? 2 : 3;
  constexpr unsigned char kLead[] = {0, 0xC0, 0xE0, 0xF0};
  text += static_cast<char>(kLead[tails] | static_cast<unsigned char>(c >> (6 * tails)));
  for (int k = tails - 1; k >= 0; --k) text += static_cast<char>(0x80 | (c >> (6 * k) & 0x3F));
}

/// The library leaves "\X4\0001F600", and doubled apostrophes, as they are.
inline std::wstring decoded(const std::wstring& encoded) {
  std::wstring text;
  for (std::size_t at = 0; at < encoded.size(); ++at) {
    const bool is_apostrophe = encoded.compare(at, 2, L"''") == 0;
    const bool is_code = encoded.compare(at, 4, L"\\X4\\") == 0;
    for (std::size_t code = at + 4; is_code && code + 8 <= encoded.size(); code += 8, at = code - 1) {
      std::size_t digits = 0;
      for (; digits < 8 && std::iswxdigit(static_cast<wint_t>(encoded[code + digits])); ++digits) continue;
      if (digits < 8) break;
      text += static_cast<wchar_t>(std::stoul(encoded.substr(code, 8), nullptr, 16));
    }
    if (!is_code) text += encoded[at];
    at += is_apostrophe;
  }
  return text;
}

inline std::string utf8(const std::wstring& wide) {
  std::string text;
  for (const wchar_t c : decoded(wide)) append_utf8(text, static_cast<char32_t>(c));
  return text;
}

/// Text of a label, identifier, ...; empty without one.
template <class Label>
std::string text_of(const shared_ptr<Label>& label) {
  return label ? utf8(label->m_value) : "";
}

template <class Number>
double number_of(const shared_ptr<Number>& number, const char* what) {
  if (!number || !std::isfinite(number->m_value)) throw Unreadable(std::string("has no ") + what);
  return number->m_value;
}

template <class T, class Whatever>
shared_ptr<T> as(const shared_ptr<Whatever>& object) {
  return std::dynamic_pointer_cast<T>(object);
}

template <class T>
shared_ptr<T> locked(const weak_ptr<T>& object) {
  return object.lock();
}

template <class Coordinate>
Point3 coordinates(const std::vector<shared_ptr<Coordinate>>& values, const char* what) {
  if (values.size() < 2 || values.size() > 3)
    throw Unreadable(std::string(what) + " has " + std::to_string(values.size()) + " coordinates");
  Point3 point = Point3::Zero();
  for (std::size_t k = 0; k < values.size(); ++k) point[static_cast<Eigen::Index>(k)] = number_of(values[k], what);
  return point;
}

inline Point3 point_of(const shared_ptr<IfcCartesianPoint>& point, double unit_m) {
  if (!point) throw Unreadable("has no point");
  return unit_m * coordinates(point->m_Coordinates, "a point");
}

/// Unit vector; `fallback` without a direction.
inline Point3 direction_of(const shared_ptr<IfcDirection>& direction, const Point3& fallback) {
  if (!direction) return fallback;
  const Point3 v = coordinates(direction->m_DirectionRatios, "a direction");
  if (v.norm() < 1e-12) throw Unreadable("has a direction without length");
  return v.normalized();
}

}  // namespace opal::ifc_importer::ifcpp
