#pragma once
/// Who finds the contacts of a pair of convex parts.
namespace nilas {

enum class NarrowPhase {
  nilas,       ///< the exact search, after FCL's first answer for pairs without a kept axis
  fcl,         ///< FCL's own distance and penetration, completed to manifolds
  nilas_alone  ///< the exact search without FCL in front of it
};

}  // namespace nilas
