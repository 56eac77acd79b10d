#pragma once
/// Loop over independent items. Each item writes only its own result, so the bits do not depend on the thread count.
#include <cstddef>

namespace nilas {

template <class Body>
void parallel_for(std::ptrdiff_t count, int threads, const Body& body) {
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1)
  for (std::ptrdiff_t i = 0; i < count; ++i) body(i);
}

}  // namespace nilas
