#pragma once
/// Includes Simbody 3.7 as Debian builds it, in C++20 and in every build type. Include this in place of <Simbody.h>, in
/// sources only.
///
/// 1. Its index types convert to and from int, so the rewritten operator== candidates of C++20 are ambiguous. An exact
/// match declared before its headers resolves this.
/// 2. Its State has more members without NDEBUG, and Debian's library is built without NDEBUG. A program compiled with
/// the other layout crashes in realizeTopology(). Its headers are therefore read without NDEBUG (simbody/simbody pull
/// request 738).
#include <concepts>
#include <type_traits>

#include "core/base/math.h"  // Eigen keeps the build type's NDEBUG

namespace SimTK {

template <class T>
concept UniqueIndexLike = std::is_class_v<T> && requires(const T a) {
  { T::isValidExtended(0) } -> std::same_as<bool>;
  { T::Invalid() } -> std::same_as<const T&>;
  { a.operator int() } -> std::same_as<int>;
};

template <UniqueIndexLike T>
constexpr bool operator==(const T& a, const T& b) {
  return a.operator int() == b.operator int();
}

}  // namespace SimTK

#pragma push_macro("NDEBUG")
#undef NDEBUG
#include <Simbody.h>
#pragma pop_macro("NDEBUG")
#include <cassert>  // assert() as the build type wants it
