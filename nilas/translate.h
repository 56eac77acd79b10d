#pragma once
/// The one place where exceptions of the parts become those of the library.
#include <exception>
#include <filesystem>
#include <new>

#include "core/base/error.h"
#include "nilas/error.h"

namespace nilas::library {

/// Throws the exception that is being handled as an Error. Call within a handler.
[[noreturn]] void rethrow_as_error();

/// Calls body() and turns its exceptions into Error.
template <class Body>
auto translated(const Body& body) {
  try {
    return body();
  } catch (...) {
    rethrow_as_error();
  }
}

}  // namespace nilas::library
