#pragma once
/// The path of a splitting crack through ice whose toughness varies from place to place.
#include <vector>

#include "fracture/cut/local_ice.h"

namespace nilas::fracture {

/// The energy release rate of a short kink at the angle omega [rad] from a crack that is pulled open, over that of
/// straight growth. To first order (Cotterell and Rice 1980) k_I = cos^3(omega/2) K and
/// k_II = sin(omega/2) cos^2(omega/2) K, hence the ratio is cos^4(omega/2). It is a quarter at a right angle. He and
/// Hutchinson (1989) study the same competition for a crack that meets an interface.
double kink_release_rate(double omega);

struct CrackPath {
  std::vector<Vec2> points;  ///< The points from `start` to just beyond the edge where it leaves the ice, in B [m].
  std::vector<double> toughness;  ///< Toughness of the ice along segment i [Pa sqrt(m)].
  double length() const;
};

/// The path of a crack that grows from `start`, a point of the edge, through a floe that is pulled open across `angle`
/// [rad, from x]. It grows in segments of at most `segment` [m]. Each takes the direction with the largest ratio of the
/// kink's release rate, with omega from `angle`, to toughness^2 at its middle. Candidates are directions at up to 60
/// degrees from `angle` in steps of 5, and the weak line at the crack's end at less than 90 degrees. The crack stops at
/// each weak line that it meets, to choose again. Of candidates that are equal within 1e-9 it takes the straighter one.
/// Of two mirror images it takes neither and goes straight. In uniform ice it is straight. `outline` must be simple and
/// counter-clockwise. `toughness` is used where `ice` has no function for it. Throws ContractError unless segment and
/// toughness are positive.
CrackPath crack_path(const std::vector<Vec2>& outline, const Vec2& start, double angle, double segment,
                     double toughness, const LocalIce& ice);

}  // namespace nilas::fracture
