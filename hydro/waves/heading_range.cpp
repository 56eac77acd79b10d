#include "hydro/waves/heading_range.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "core/base/error.h"

namespace nilas::hydro {

/// Two headings closer than this are the same: files hold degrees with two decimals and more [rad].
constexpr double k_same_heading = 1e-4;

HeadingRange::HeadingRange(std::vector<double> headings, const BodySymmetry& body) : headings_(std::move(headings)) {
  if (headings_.empty() || !std::is_sorted(headings_.begin(), headings_.end(), std::less_equal<>()))
    throw InputError("the headings of a database must rise");
  const double first = headings_.front();
  circle_ = headings_.size() > 2 && gap_after(headings_.size() - 1) <= k_widest_gap;
  round_ = headings_.size() == 1 && body.round;
  mirrored_ = !circle_ && !round_ && body.sides && std::abs(first) < k_same_heading;
}

/// The angle from a heading to the next one, from the last to the first of the next turn.
double HeadingRange::gap_after(std::size_t k) const {
  return k + 1 < headings_.size() ? headings_[k + 1] - headings_[k] : headings_.front() + 2 * k_pi - headings_.back();
}

std::optional<HeadingPlace> HeadingRange::find(double heading) const {
  HeadingPlace place;
  double wanted = std::remainder(heading, 2 * k_pi);
  const double first = headings_.front(), last = headings_.back();
  if (round_) {
    place.turn = std::remainder(heading - first, 2 * k_pi);
    return place;
  }
  if (mirrored_) {
    place.mirror = wanted < 0;
    wanted = std::abs(wanted);
  } else {
    while (wanted < first - k_same_heading) wanted += 2 * k_pi;
    while (wanted > first + 2 * k_pi) wanted -= 2 * k_pi;
  }
  if (wanted <= first) wanted = first;
  if (wanted > last && !circle_) {
    if (wanted > last + k_same_heading) return std::nullopt;
    wanted = last;
  }
  const auto above = std::upper_bound(headings_.begin(), headings_.end(), wanted);
  place.before = static_cast<std::size_t>(above - headings_.begin()) - 1;
  place.after = (place.before + 1) % headings_.size();
  const double low = headings_[place.before], gap = gap_after(place.before);
  if (!(wanted > low && gap > 0)) return place;
  if (gap > k_widest_gap) {
    // Only the headings at both ends of a wide gap have values.
    if (wanted - low <= k_same_heading) return place;
    if (low + gap - wanted > k_same_heading) return std::nullopt;
    wanted = low + gap;
  }
  place.share = (wanted - low) / gap;
  return place;
}

std::string HeadingRange::text() const {
  const double last = headings_.back() / k_deg;
  double widest = 0;
  for (std::size_t k = 0; k + 1 < headings_.size(); ++k) widest = std::max(widest, gap_after(k));
  const std::string gaps =
      widest > k_widest_gap
          ? fmt::format(", of which the widest gap is {:.4g} deg; values between headings need gaps of at most 45 deg",
                        widest / k_deg)
          : "";
  return fmt::format("{:g} to {:g} deg{}", mirrored_ ? -last : headings_.front() / k_deg, last, gaps);
}

}  // namespace nilas::hydro
