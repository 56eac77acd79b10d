#include "core/base/random.h"

#include <cmath>

#include "core/base/math.h"

namespace nilas {

static std::uint64_t mix(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

RandomStream::RandomStream(std::uint64_t seed, std::string_view name) : key_(mix(seed + 0x9e3779b97f4a7c15ULL)) {
  for (const char c : name) key_ = mix(key_ ^ (static_cast<unsigned char>(c) + 0x9e3779b97f4a7c15ULL));
}

std::uint64_t RandomStream::bits() { return mix(key_ + 0x9e3779b97f4a7c15ULL * ++counter_); }

double RandomStream::uniform() { return static_cast<double>(bits() >> 11) * 0x1.0p-53; }

double RandomStream::uniform(double low, double high) { return low + (high - low) * uniform(); }

double RandomStream::normal() {
  const double u = 1.0 - uniform();  // in (0, 1], so the logarithm is finite
  return std::sqrt(-2.0 * std::log(u)) * std::cos(2.0 * k_pi * uniform());
}

double RandomStream::lognormal(double mean, double sd) {
  const double s2 = std::log1p(sd * sd / (mean * mean));
  return mean * std::exp(std::sqrt(s2) * normal() - 0.5 * s2);
}

}  // namespace nilas
