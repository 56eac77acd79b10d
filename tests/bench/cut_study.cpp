/// Random cuts, ordinary and adversarial: conservation errors of each class, refusals with their reasons, and cost.
/// usage: bench_cut_study CUTS     CUTS: number of cuts of all classes together
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <map>
#include <string>

#include "tests/support/cut_judge.h"

namespace {

using namespace nilas;
using namespace nilas::test;

struct Tally {
  int cuts = 0, thrown = 0, bad = 0, slivers = 0;
  std::size_t pieces = 0;
  std::map<std::string, int> refused;
  double area = 0, area_over_bound = 0, overlap = 0, motion = 0, birth_overlap = 0, seconds = 0;
};

void raise(double& worst, double value) { worst = std::max(worst, value); }

void cut_floe_too(const CutCase& made, RandomStream& random, Tally& tally) {
  const Vec2 centroid = geometry::polygon_moments(made.outline).centroid;
  const fracture::FloeState floe = random_floe(made.outline, random);
  if (!sound(floe.outline)) return;
  Lines cracks = made.cracks;
  for (auto& crack : cracks)
    for (Vec2& p : crack) p -= centroid;
  fracture::PieceLimits limits;
  limits.min_area = 1e-3 * geometry::polygon_moments(floe.outline).area;
  limits.small = SmallPieces::brash;
  const fracture::FloeCut cut = fracture::cut_floe(floe, cracks, limits);
  if (cut.status == fracture::FloeCutStatus::geometry) ++tally.refused["floe: " + cut.message];
  if (cut.status != fracture::FloeCutStatus::cut) return;
  raise(tally.motion, motion_error(floe, cut).worst());
  raise(tally.birth_overlap, deepest_overlap(pieces_in_plane(floe, cut)));
}

void study(CutClass kind, RandomStream& random, Tally& tally) {
  const CutCase made = cut_case(kind, random);
  const auto start = std::chrono::steady_clock::now();
  const fracture::CutResult cut = fracture::cut_outline(made.outline, made.cracks);
  tally.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  ++tally.cuts;
  tally.pieces += cut.pieces.size();
  tally.slivers += cut.slivers;
  if (cut.pieces.empty()) {
    ++tally.refused[fracture::name_of(cut.status)];
    return;
  }
  for (const fracture::CutPiece& piece : cut.pieces)
    if (!sound(piece.outline)) ++tally.bad;
  const double error = area_error(made.outline, cut.pieces), area = geometry::polygon_moments(made.outline).area;
  raise(tally.area, error / area);
  raise(tally.area_over_bound, error / (fracture::snap_resolution(made.outline) * perimeter(made.outline)));
  raise(tally.overlap, deepest_overlap(cut.pieces));
  if (cut.status == fracture::CutStatus::cut) cut_floe_too(made, random, tally);
}

void print(const char* name, const Tally& t) {
  std::printf("%-17s %7d %8zu %4d %4d %5d  %8.1e %6.3f  %8.1e %8.1e %8.1e %7.3f ", name, t.cuts, t.pieces, t.bad,
              t.thrown, t.slivers, t.area, t.area_over_bound, t.overlap, t.birth_overlap, t.motion,
              1e3 * t.seconds / t.cuts);
  for (const auto& [why, times] : t.refused) std::printf(" %s %d", why.c_str(), times);
  std::printf("\n");
  std::fflush(stdout);
}

}  // namespace

int main(int count, char** words) {
  const int cuts = count > 1 ? std::atoi(words[1]) : 100000;
  std::printf(
      "area: error over the area, and over its bound (perimeter x resolution); overlap [m]: of the outlines, and of\n"
      "the pieces about their own centroids; motion: worst of mass, momentum, angular momentum, energy\n");
  std::printf("%-17s %7s %8s %4s %4s %5s  %8s %6s  %8s %8s %8s %7s  refused\n", "class", "cuts", "pieces", "bad",
              "thr.", "sliv.", "area", "bound", "overlap", "birth", "motion", "ms/cut");
  for (int c = 0; c < k_num_cut_classes; ++c) {
    RandomStream random(20140401, k_cut_class_names[c]);
    Tally tally;
    for (int i = 0; i < cuts / k_num_cut_classes; ++i) try {
        study(static_cast<CutClass>(c), random, tally);
      } catch (const std::exception& error) {
        if (++tally.thrown == 1) std::printf("%s\n", error.what());
      }
    print(k_cut_class_names[c], tally);
  }
}
