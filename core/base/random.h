#pragma once
/// Counter-based random streams: the n-th number of a named stream depends on (seed, name, n) only,
/// so fields and samples do not change with thread count or call order elsewhere.
#include <cstdint>
#include <string_view>

namespace nilas {

/// One named stream. Generator: SplitMix64 finaliser over a keyed counter [Steele, Lea, Flood 2014].
class RandomStream {
 public:
  RandomStream(std::uint64_t seed, std::string_view name);
  std::uint64_t bits();
  double uniform();                         ///< uniform in [0, 1)
  double uniform(double low, double high);  ///< uniform in [low, high)
  double normal();                          ///< mean 0, standard deviation 1 (Box-Muller)
  /// Log-normal with the given mean and standard deviation of the variable itself.
  double lognormal(double mean, double sd);

 private:
  std::uint64_t key_;
  std::uint64_t counter_ = 0;
};

}  // namespace nilas
