#include "hydro/waves/vessel_excitation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "hydro/database/heading_circle.h"
#include "hydro/database/wave_number.h"

namespace nilas::hydro {

namespace {

/// Two frequencies of the database and the share of the higher one.
struct FrequencyPlace {
  std::size_t before = 0, after = 0;
  double share = 0;

  template <class Vector>
  Vector of(const std::vector<std::vector<Vector>>& values, std::size_t heading) const {
    if (share == 0) return values[before][heading];
    return (1 - share) * values[before][heading] + share * values[after][heading];
  }
};

FrequencyPlace find_frequency(const Database& database, double frequency) {
  constexpr double k_rounding = 1e-6;  // share of the frequency by which files round periods
  const std::vector<double>& all = database.frequency;
  if (all.empty() || frequency < all.front() * (1 - k_rounding) || frequency > all.back() * (1 + k_rounding))
    throw InputError(fmt::format(
        "{}: found a wave with the period {:g} s; allowed are the periods of the database, {:g} to {:g} s; set "
        "<waves shortest_period> or compute more frequencies",
        database.source, 2 * k_pi / frequency, 2 * k_pi / all.back(), 2 * k_pi / all.front()));
  const double wanted = std::clamp(frequency, all.front(), all.back());
  const auto above = std::min(std::upper_bound(all.begin(), all.end(), wanted), all.end() - 1);
  FrequencyPlace place;
  place.after = static_cast<std::size_t>(above - all.begin());
  place.before = place.after == 0 ? 0 : place.after - 1;
  if (place.after > place.before) place.share = (wanted - all[place.before]) / (all[place.after] - all[place.before]);
  return place;
}

void check_lengths(const Database& database, const WaveField& field) {
  constexpr double k_allowed = 0.02;  // difference of lengths, which changes excitations by about as much
  for (const WaveComponent& wave : field.components()) {
    const double number = wave_number(wave.frequency, database.gravity, database.depth);
    if (std::abs(number / wave.number - 1) > k_allowed)
      throw InputError(fmt::format(
          "{}: the wave with the period {:g} s is {:g} m long in the scene and {:g} m in the database, with its depth "
          "and gravity; allowed: a difference of the share {:g}; set <waves depth>",
          database.source, 2 * k_pi / wave.frequency, 2 * k_pi / wave.number, 2 * k_pi / number, k_allowed));
  }
}

}  // namespace

VesselExcitation::VesselExcitation(const Database& database, const WaveField& field, WaveDrift drift)
    : headings_(database.heading), drift_(drift) {
  if (database.excitation.empty() || database.heading.empty())
    throw InputError(database.source + ": the database has no excitation by waves");
  if (drift != WaveDrift::none && database.drift.empty())
    throw InputError(database.source + ": the database has no mean drift loads; allowed: drift=\"none\"");
  NILAS_DEMAND(database.excitation.size() == database.frequency.size());
  check_lengths(database, field);
  range_ = HeadingRange(headings_, {is_symmetric_port_starboard(database), is_round(database)});
  for (const WaveComponent& component : field.components()) {
    const FrequencyPlace place = find_frequency(database, component.frequency);
    Wave& wave = waves_.emplace_back();
    for (std::size_t k = 0; k < headings_.size(); ++k) {
      wave.excitation.push_back(place.of(database.excitation, k));
      if (drift != WaveDrift::none) wave.drift.push_back(place.of(database.drift, k));
    }
  }
}

void VesselExcitation::check_headings(const WaveField& field, double yaw) const {
  for (const WaveComponent& wave : field.components())
    if (!range_.find(wave.heading - yaw))
      throw InputError(
          fmt::format("found a wave that travels towards {:g} deg relative to the vessel; allowed are the headings of "
                      "the database, {}",
                      std::remainder(wave.heading - yaw, 2 * k_pi) / k_deg, range_.text()));
}

Vec6 VesselExcitation::load(const WaveField& field, const WaveColumn& waves, double yaw, double t) const {
  Vec6 load = Vec6::Zero();
  WavePhasor sum;                                           // of a exp(i t)
  Vec6 drift_cos = Vec6::Zero(), drift_sin = Vec6::Zero();  // of D a exp(i t)
  for (std::size_t i = 0; i < waves_.size(); ++i) {
    const double heading = field.components()[i].heading - yaw;
    const auto place = range_.find(heading);
    if (!place)
      throw SimulationError(fmt::format(
          "at {:g} s the vessel has turned so that a wave travels towards {:g} deg relative to it; the database has "
          "the headings {}",
          t, std::remainder(heading, 2 * k_pi) / k_deg, range_.text()));
    const WavePhasor& a = waves.phasors()[i];
    const ComplexVec6 x = place->of(waves_[i].excitation);
    load += x.real() * a.cos - x.imag() * a.sin;
    if (drift_ == WaveDrift::none) continue;
    const Vec6 drift = place->of(waves_[i].drift);
    if (drift_ == WaveDrift::mean) load += (a.cos * a.cos + a.sin * a.sin) * drift;
    sum.cos += a.cos;
    sum.sin += a.sin;
    drift_cos += a.cos * drift;
    drift_sin += a.sin * drift;
  }
  if (drift_ == WaveDrift::newman) load += sum.cos * drift_cos + sum.sin * drift_sin;
  return load;
}

}  // namespace nilas::hydro
