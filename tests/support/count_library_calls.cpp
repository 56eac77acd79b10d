/// Counts a program's calls of FCL's narrow phase and of libccd from outside: preloaded, it is found before both
/// libraries. At the end it writes "collide N", "distance N" and "ccd N" to the file that NILAS_LIBRARY_CALLS names.
#include <dlfcn.h>
#include <errno.h>

#include <atomic>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace {

struct Calls {
  std::atomic<long> collide{0}, distance{0}, ccd{0};
  ~Calls() {
    // A shell that starts the program is preloaded as well.
    if (std::string_view(program_invocation_short_name) != "nilas") return;
    const char* file = std::getenv("NILAS_LIBRARY_CALLS");
    if (std::FILE* out = file ? std::fopen(file, "w") : nullptr) {
      std::fprintf(out, "collide %ld\ndistance %ld\nccd %ld\n", collide.load(), distance.load(), ccd.load());
      std::fclose(out);
    }
  }
};

Calls calls;  // The library's only state lives as long as the program that it counts for.

template <class Function>
Function* next(const char* symbol) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, symbol));
}

}  // namespace

#define FCL_COLLIDE                                                                                   \
  "_ZN3fcl7collideIdEEmPKNS_17CollisionGeometryIT_EERKN5Eigen9TransformIS2_Li3ELi1ELi0EEES5_SA_RKNS_" \
  "16CollisionRequestIS2_EERNS_15CollisionResultIS2_EE"
#define FCL_DISTANCE                                                                                     \
  "_ZN3fcl8distanceIdEET_PKNS_17CollisionGeometryIS1_EERKN5Eigen9TransformIS1_Li3ELi1ELi0EEES5_SA_RKNS_" \
  "15DistanceRequestIS1_EERNS_14DistanceResultIS1_EE"

// All arguments of both are pointers or references.
using Collide = std::size_t(const void*, const void*, const void*, const void*, const void*, void*);
using Distance = double(const void*, const void*, const void*, const void*, const void*, void*);

std::size_t count_collide(const void* a, const void* pose_a, const void* b, const void* pose_b, const void* request,
                          void* result) asm(FCL_COLLIDE);
std::size_t count_collide(const void* a, const void* pose_a, const void* b, const void* pose_b, const void* request,
                          void* result) {
  static Collide* const real = next<Collide>(FCL_COLLIDE);
  ++calls.collide;
  return real(a, pose_a, b, pose_b, request, result);
}

double count_distance(const void* a, const void* pose_a, const void* b, const void* pose_b, const void* request,
                      void* result) asm(FCL_DISTANCE);
double count_distance(const void* a, const void* pose_a, const void* b, const void* pose_b, const void* request,
                      void* result) {
  static Distance* const real = next<Distance>(FCL_DISTANCE);
  ++calls.distance;
  return real(a, pose_a, b, pose_b, request, result);
}

// FCL's GJK and EPA use these functions of libccd: distances to the simplex, and the polytope of the penetration.
extern "C" {

double ccdVec3PointSegmentDist2(const void* point, const void* start, const void* end, void* nearest) {
  using Real = double(const void*, const void*, const void*, void*);
  static Real* const real = next<Real>("ccdVec3PointSegmentDist2");
  ++calls.ccd;
  return real(point, start, end, nearest);
}

double ccdVec3PointTriDist2(const void* point, const void* a, const void* b, const void* c, void* nearest) {
  using Real = double(const void*, const void*, const void*, const void*, void*);
  static Real* const real = next<Real>("ccdVec3PointTriDist2");
  ++calls.ccd;
  return real(point, a, b, c, nearest);
}

void ccdPtInit(void* polytope) {
  using Real = void(void*);
  static Real* const real = next<Real>("ccdPtInit");
  ++calls.ccd;
  real(polytope);
}
}
