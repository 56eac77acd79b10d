#pragma once
#include <string>

namespace nilas::test {

/// Whether a text holds the words, in this order and next to each other.
inline bool mentions(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

}  // namespace nilas::test

namespace nilas_test {

using nilas::test::mentions;

}  // namespace nilas_test
