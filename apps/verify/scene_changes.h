#pragma once
/// Overrides of scene attributes that many cases use.
#include <string>

#include "apps/verify/setting.h"

namespace nilas::verify {

constexpr double k_gravity = 9.81;  ///< gravity of the scenes [m/s^2]

inline scene::Overrides operator+(scene::Overrides a, const scene::Overrides& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// Sets static and kinetic friction of the scene's first <friction>.
inline scene::Overrides friction(double coefficient) {
  return {{"contact/friction[1]/@static", text(coefficient)}, {"contact/friction[1]/@kinetic", text(coefficient)}};
}

inline scene::Overrides restitution(double coefficient) {
  return {{"contact/friction[1]/@restitution", text(coefficient)}};
}

inline scene::Overrides gravity(const Vec3& value) { return {{"gravity/@value", text(value)}}; }

/// Sets an attribute of a <body>.
template <class Value>
scene::Overrides of(const std::string& body, const std::string& attribute, const Value& value) {
  return {{"body[@name='" + body + "']/@" + attribute, text(value)}};
}
inline scene::Overrides of(const std::string& body, const std::string& attribute, const std::string& value) {
  return {{"body[@name='" + body + "']/@" + attribute, value}};
}
inline scene::Overrides of(const std::string& body, const std::string& attribute, const char* value) {
  return of(body, attribute, std::string(value));
}

/// Returns the horizontal unit vector at this angle [deg] from X towards Y.
inline Vec3 heading(double degrees) { return {std::cos(degrees * k_deg), std::sin(degrees * k_deg), 0}; }

}  // namespace nilas::verify
