#pragma once
/// Pairs of bodies that are each other's image in the plane y = 0. A mirrored scene sees the contact of such a pair,
/// and of no other, with the roles of its bodies exchanged.
#include "contact/detect/broad/pair_view.h"

namespace nilas::detect {

/// Returns whether the vertices of both parts are mirror images to the last bit, and their poses to a millionth of
/// their size. Bodies of several parts and round ones are not compared: false.
bool are_images(const bodies::Bodies& bodies, const Part& a, const Part& b);

/// Returns the axis across the plane, from A to B, with the separation along it. While the two are apart it is the best
/// axis of all. The reason is that the means of the nearest points and their images are as near, and face each other
/// across the plane.
Axis axis_across(const bodies::Bodies& bodies, const PairView& pair);

/// Returns the y of the plane between a pair of images [m]. It is 0 to the last bit where the poses are exact images.
double middle_plane(const bodies::Bodies& bodies, const Part& a, const Part& b);

/// Returns whether a pair of images may touch along the axis across the plane, where `best` is the best of all axes. It
/// may while the overlap along it is at most twice the least. A face of A that is the best axis has an image among the
/// faces of B that is as good. Either face alone would press the pair to one side.
bool serves_instead(const Axis& across, const Axis& best);

}  // namespace nilas::detect
