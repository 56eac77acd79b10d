#pragma once
/// Selects a few well-spread points for one pair of parts.
#include <limits>
#include <span>
#include <vector>

#include "contact/detect/surface/overlay.h"

namespace nilas::detect {

/// Number of well-spread points of a pair ...
constexpr std::size_t k_spread_points = 4;
/// ... and including points that the four leave unsupported or that lie deeper.
constexpr std::size_t k_most_points = 8;

/// A point that could sink by less than this share of the thinner part's inner radius is left out [-]. The share is one
/// hundredth of a floe's thickness.
constexpr double k_cover_share = 0.02;
/// The `cover` of flat faces [m].
constexpr double k_four_points_do = std::numeric_limits<double>::infinity();

/// A set that was kept stays while its weighted area is more than this share of the best one's [-], and ...
constexpr double k_kept_area = 0.98;
/// ... while its deepest point is higher than the deepest of all by less than this share of the range [-]. The range is
/// the larger of the gap between the deepest point and the margin, and 1e-4 of the points' spread.
constexpr double k_kept_depth = 1e-3;

/// Keeps the deepest point and the three that span the largest quadrilateral with it, its area weighted by how near the
/// points' gaps are to the deepest against `margin` [m] (all gaps are below it): a floe that lies on a blunt ridge
/// keeps both ends of it, instead of rocking between them.
///
/// Four points hold up a flat face, not a floe that lies on a curved bow. A further point is kept where it could
/// otherwise sink by more than `cover` [m] while the others only just touch, up to k_most_points in all.
///
/// Where the points are their own image in t1, as where a ship meets a floe on its centre line, so is the set kept.
/// Ties, within `tolerance` [m], are broken by geometry alone: the mean nearest to the mean of all, then the set that
/// is its own image in t2, then the one longest along t1, then the one farther ahead on it. So a mirrored contact keeps
/// the mirrored points.
///
/// `last`: the features of the pair's points kept at the last call, or empty. Its first four stay while they spread
/// nearly as well as the best set (k_kept_area) and one of them is nearly as deep as the deepest (k_kept_depth), so
/// that a body that rocks by rounding on more than four corners does not change its corners. Where none of them is the
/// deepest, that one joins them, up to k_most_points in all, and stays while it is nearly as deep.
///
/// Returns how many of the first points left are to be the pair's `last` at the next call.
std::size_t keep_spread_points(double tolerance, double margin, double cover, std::vector<OverlayPoint>& points,
                               std::span<const Feature> last = {});

}  // namespace nilas::detect
