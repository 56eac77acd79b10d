#pragma once
#include <string>

namespace nilas_test {

inline bool mentions(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

}  // namespace nilas_test
