#pragma once
/// What a call says that refuses its input.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/base/error.h"
#include "tests/support/mentions.h"

namespace nilas::test {

/// Returns the message of the Error that a call throws, or "accepted" where it throws nothing. Other errors pass.
template <class Error = InputError, class Call>
std::string refusal(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

/// Expects that a call throws an Error whose message holds each of the words.
template <class Error = InputError, class Call>
void expect_refusal(const Call& call, const std::vector<std::string>& words) {
  const std::string text = refusal<Error>(call);
  EXPECT_NE(text, "accepted");
  for (const std::string& each : words) EXPECT_TRUE(mentions(text, each)) << "'" << each << "' is not in: " << text;
}

}  // namespace nilas::test
