#pragma once
/// Path of a splitting crack through ice that is not alike everywhere.
#include <vector>

#include "fracture/cut/local_ice.h"

namespace nilas {

/// Energy release rate of a short kink at the angle omega [rad] from the way of a crack that is pulled open straight,
/// over that of going straight on: k_I = cos^3(omega/2) K and k_II = sin(omega/2) cos^2(omega/2) K (Cotterell & Rice
/// 1980, to first order), hence cos^4(omega/2). A quarter at a right angle, as for a crack at an interface (He &
/// Hutchinson 1989).
double kink_release_rate(double omega);

struct CrackPath {
  std::vector<Vec2> points;       ///< from `start` to just beyond the edge where it comes out, in B [m]
  std::vector<double> toughness;  ///< of the ice along segment i [Pa sqrt(m)]
  double length() const;
};

/// The crack grows in segments of at most `segment` [m] from `start`, a point of the edge, through a floe that is
/// pulled open across `angle` [rad, from x]. Each goes where the release rate of a kink, with omega from `angle`, is
/// largest in proportion to toughness^2 at its middle: ahead, at up to 60 degrees from it in steps of 5, or along a
/// weak line that it stands on, at less than 90. It stops at each weak line that it meets, to choose again. Of ways
/// that are as good (1e-9) the straighter, and straight ahead where two are mirror images. Where all ice is alike it is
/// straight. `outline` simple, counter-clockwise. `toughness` is taken where `ice` has no function for it. Throws
/// ContractError unless segment and toughness are positive.
CrackPath crack_path(const std::vector<Vec2>& outline, const Vec2& start, double angle, double segment,
                     double toughness, const LocalIce& ice);

}  // namespace nilas
