#pragma once
/// Pairs of bodies that are each other's image in the plane y = 0: the one kind of pair whose contact a mirrored scene
/// sees with the roles of its bodies exchanged.
#include "contact/detect/broad/pair_view.h"

namespace nilas {

/// Whether both parts have each other's mirrored vertices to the last bit, and stand as images of each other to a
/// millionth of their size. Bodies of several parts and round ones are not looked at: false.
bool are_images(const Bodies& bodies, const Part& a, const Part& b);

/// The axis across the plane, from A to B, and what the pair of images is apart along it. While the two are apart it
/// is the best axis of all: of the nearest points and their images the means are as near, and face each other across
/// the plane.
Axis axis_across(const Bodies& bodies, const PairView& pair);

/// The y of the plane between a pair of images [m]: 0 to the last bit where that is what their poses are to.
double middle_plane(const Bodies& bodies, const Part& a, const Part& b);

/// Whether a pair of images may touch along the axis across the plane, where `best` is the best of all axes: overlap
/// by up to twice the least. A face of A that is the best axis has an image among the faces of B that is as good;
/// either alone would press one way.
bool serves_instead(const Axis& across, const Axis& best);

}  // namespace nilas
