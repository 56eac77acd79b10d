#pragma once
/// A floe whose place in the field is still open, and the bounds of the field.
#include <vector>

#include "core/base/math.h"
#include "core/field/spec/convex_contact.h"

namespace nilas::field {

struct LooseFloe {
  std::vector<Vec2> shape;     ///< convex, counter-clockwise about the centroid [m]
  double area = 0;             ///< [m^2]
  double polar_moment = 0;     ///< integral of r^2 over the area, about the centroid [m^4]
  double radius = 0;           ///< radius of the circle about the centroid that contains the shape [m]
  Vec2 centre = Vec2::Zero();  ///< centroid in G [m]
  double angle = 0;            ///< angle of the shape in G [rad]
  std::vector<Vec2> notched;   ///< the ice itself, where `shape` is only its convex hull; same axes [m]
  double fill = 1;             ///< area of the ice over that of the shape
};

/// A floe of the given outline in G: its centroid becomes the centre, and its angle is zero.
LooseFloe loose_floe(std::vector<Vec2> outline);
/// A floe of a simple counter-clockwise outline that need not be convex; packed as its convex hull.
LooseFloe hulled_floe(const std::vector<Vec2>& outline);
/// The ice of a floe in its place, counter-clockwise [m].
std::vector<Vec2> placed_ice(const LooseFloe& floe);
/// The same floe scaled about its centroid to `area` of its shape [m^2].
LooseFloe with_area(LooseFloe floe, double area);
/// Places the floe's shape, scaled by `scale` about the centroid, in G.
void place_outline(const LooseFloe& floe, double scale, ConvexOutline& outline);
std::vector<ConvexOutline> placed_outlines(const std::vector<LooseFloe>& floes);

/// Convex region that floes keep out of.
struct Obstacle {
  ConvexOutline outline;
  Vec2 low = Vec2::Zero(), high = Vec2::Zero();  ///< bounding box [m]
};
Obstacle obstacle(std::vector<Vec2> outline);

/// The rectangle that contains the field, without the obstacles.
struct FieldBounds {
  Vec2 low = Vec2::Zero(), high = Vec2::Ones();
  std::vector<Obstacle> obstacles;
};
/// True when the circle comes within `distance` of the obstacle's bounding box.
bool is_near(const Obstacle& obstacle, const Vec2& centre, double radius, double distance);

}  // namespace nilas::field
