#pragma once
/// The exception of the library.
#include <stdexcept>
#include <string>

#include "nilas/export.h"

namespace nilas {

/// What went wrong. input: a scene, a problem or an argument; the message names file, line, element and what is
/// allowed where there are any. file: a file cannot be opened, read or written. numerics: the simulation left finite
/// numbers, or a solver stopped a scene that asks for it. defect: a fault of Nilas itself; please report it.
enum class ErrorKind { input, file, numerics, defect };

/// Every function of the library throws this and std::bad_alloc alone.
class NILAS_API Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, const std::string& message);
  ~Error() override;
  ErrorKind kind() const { return kind_; }

 private:
  ErrorKind kind_;
};

}  // namespace nilas
