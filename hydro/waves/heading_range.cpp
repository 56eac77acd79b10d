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
  const double first = headings_.front(), span = headings_.back() - first;
  double widest = 0;
  for (std::size_t i = 1; i < headings_.size(); ++i) widest = std::max(widest, headings_[i] - headings_[i - 1]);
  circle_ = headings_.size() > 2 && 2 * k_pi - span <= widest + k_same_heading;
  round_ = headings_.size() == 1 && body.round;
  mirrored_ = !circle_ && !round_ && body.sides && std::abs(first) < k_same_heading;
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
  const double low = headings_[place.before];
  const double high = above == headings_.end() ? first + 2 * k_pi : *above;
  if (wanted > low && high > low) place.share = (wanted - low) / (high - low);
  return place;
}

std::string HeadingRange::text() const {
  const double last = headings_.back() / k_deg;
  return fmt::format("{:g} to {:g} deg", mirrored_ ? -last : headings_.front() / k_deg, last);
}

}  // namespace nilas::hydro
