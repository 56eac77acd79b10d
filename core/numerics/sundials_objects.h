#pragma once
/// Owners of the objects that SUNDIALS hands out.
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <memory>
#include <type_traits>

#include "core/base/error.h"
#include "core/base/math.h"

namespace nilas::numerics::sundials {

class Context {
 public:
  Context() { NILAS_DEMAND(SUNContext_Create(nullptr, &context_) == 0); }
  ~Context() { SUNContext_Free(&context_); }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
  SUNContext get() const { return context_; }

 private:
  SUNContext context_ = nullptr;
};

struct Release {
  void operator()(N_Vector v) const { N_VDestroy(v); }
  void operator()(SUNMatrix m) const { SUNMatDestroy(m); }
  void operator()(SUNLinearSolver s) const { SUNLinSolFree(s); }
};
using Vector = std::unique_ptr<std::remove_pointer_t<N_Vector>, Release>;
using Matrix = std::unique_ptr<std::remove_pointer_t<SUNMatrix>, Release>;
using LinearSolver = std::unique_ptr<std::remove_pointer_t<SUNLinearSolver>, Release>;

inline Eigen::Map<VecX> view(N_Vector v) { return {N_VGetArrayPointer(v), N_VGetLength(v)}; }

inline Vector copy(const VecX& x, const Context& context) {
  Vector v(N_VNew_Serial(x.size(), context.get()));
  NILAS_DEMAND(v != nullptr);
  view(v.get()) = x;
  return v;
}

/// The library prints to the console otherwise; its codes come back from every call.
inline void keep_silent(int, const char*, const char*, char*, void*) {}

}  // namespace nilas::numerics::sundials
