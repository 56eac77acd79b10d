#pragma once
#include <algorithm>
#include <cctype>
#include <string>

namespace nilas::test {

/// The text as the name of a test: everything but letters and digits becomes an underscore.
inline std::string test_name(std::string text) {
  const auto barred = [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); };
  std::replace_if(text.begin(), text.end(), barred, '_');
  return text;
}

}  // namespace nilas::test
