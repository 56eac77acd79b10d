#pragma once
/// Scenes of a second or less that several tests of the program run.
#include <string>

namespace nilas_test {

/// A ship that meets a floe on either side.
inline constexpr const char* k_ship = R"(<scene version="1" name="ship">
  <time step="0.01" end="1"/>
  <contact law="coulomb" solver="auto" tolerance="1e-6">
    <friction between="hull ice" static="0.2" kinetic="0.1"/>
    <friction between="ice ice" static="0.3" kinetic="0.3"/>
  </contact>
  <water density="1005"/>
  <hydro><buoyancy/><drag form="1" skin="0.005"/></hydro>
  <vessel name="ship" position="0 0">
    <hull generate="icebreaker" length="3" beam="0.8" draught="0.2" depth="0.4" triangles="300"/>
    <mass draught="0.2"/>
    <carriage speed="0.5" ramp="0.05"/>
  </vessel>
  <ice thickness="0.05">
    <floe name="port" outline="2.9 0.02 3.4 0.02 3.4 0.5 2.9 0.5"/>
    <floe name="starboard" outline="2.95 -0.6 3.4 -0.6 3.4 -0.02 2.95 -0.02"/>
  </ice>
</scene>
)";

/// A box that slides.
inline constexpr const char* k_box = R"(<scene version="1" name="box">
  <time step="0.01" start="0" end="0.2"/>
  <contact law="coulomb" solver="pgs" tolerance="1e-9">
    <friction between="structure structure" static="0.3" kinetic="0.3"/>
  </contact>
  <body name="ground" shape="plane" fixed="true"/>
  <body name="box" shape="box" size="1 1 1" mass="2" position="0 0 0.5" velocity="1 0 0"/>
</scene>
)";

/// A heavy box on a light one, which two sweeps of Gauss-Seidel do not solve to 1e-12 m/s. `contact` holds further
/// attributes of <contact>, with the tolerance.
inline std::string stack(const std::string& contact) {
  return R"(<scene version="1" name="stack">
  <time step="0.01" end="0.1"/>
  <contact law="coulomb" solver="nsgs" max_iterations="2" )" +
         contact + R"(>
    <friction between="structure structure" static="0.5" kinetic="0.5"/>
  </contact>
  <body name="ground" shape="plane" fixed="true"/>
  <body name="light" shape="box" size="1 1 1" mass="1" position="0 0 0.5"/>
  <body name="heavy" shape="box" size="1 1 1" mass="1000" position="0 0 1.5" velocity="1 0 0"/>
</scene>
)";
}

}  // namespace nilas_test
