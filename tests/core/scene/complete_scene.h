#pragma once
/// Every element that this version builds, with values that differ from the defaults; and the files it names.
#include <algorithm>
#include <string>

#include "tests/core/scene/scene_files.h"

namespace nilas::testing {

inline void write_inputs(const SceneFolder& folder) {
  folder.write("hulls/icebreaker/fluid.stl", "solid fluid");
  folder.write("hulls/icebreaker/part-01.stl", "solid one");
  folder.write("hulls/icebreaker/part-02.stl", "solid two");
  folder.write("hulls/icebreaker/hull.json", "{}");
  folder.write("hulls/icebreaker/notes.txt", "not read by a run");
  folder.write("cells.csv", "x_m,y_m,z_m,ax,ay,az\n");
  folder.write("floes.geojson", "{}");
  folder.write("floes.json", "[]");
  folder.write("quay.stl", "solid quay");
  folder.write("keel.csv", "z_m,u_m_s,v_m_s\n0,0.1,0\n");
  folder.write("tide.csv", "t_s,u_m_s,v_m_s\n0,0.1,0\n");
  folder.write("coefficients.csv", "angle_deg,cx,cy,cn\n");
  folder.write("ship.1", "1 1 1 1 1");
  folder.write("ship.hst", "1 1 0");
}

inline const char* const k_complete_scene = R"(<?xml version="1.0" encoding="UTF-8"?>
<scene version="1" name="towing-broken-ice" xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance"
       xsi:noNamespaceSchemaLocation="scene.xsd">
  <time step="0.02" start="1" end="60"/>
  <gravity value="0 0 -9.8"/>
  <seed value="7"/>
  <contact law="pyramid" solver="pgs" tolerance="1e-7" max_iterations="200" on_failure="stop"
           integrator="semi-implicit-euler" stabilisation="split-impulse" erp="0.3" slop="1e-4" max_speed="0.5"
           detection="discrete" margin="0.01" gyroscopic="false" axes_deg="30" warm_start="false">
    <friction between="ice ice"  static="0.30" kinetic="0.30" rolling="0" spinning="0" restitution="0.1"/>
    <friction between="hull ice" kinetic="0.10"/>
    <friction between="quay *" static="0.2" elastic="true" stiffness="2e6" edge_factor="0.8" tangential_ratio="0.9"
              damping_ratio="0.3"/>
  </contact>
  <water density="1000" level="0.5">
    <current velocity="0.1 0.2 0" profile="keel.csv" series="tide.csv"/>
    <waves kind="jonswap" height="0.1" period="2" heading_deg="30" gamma="2" components="20" shortest_period="0.8"
           spreading="8" ramp="3" depth="2" attenuation="exponential" attenuation_rate="2e-4" ice_edge="5 1"
           ice_edge_deg="10"/>
    <waves height="0.05" period="3" phase_deg="45"/>
  </water>
  <hydro>
    <buoyancy/>
    <drag form="1.1" skin="0.006"/>
    <database file="ship.1" length="2" density="1020" gravity="9.8" depth="80" reference="0 0 -1" origin="0.1 0 0.2"
              rotation_deg="180"/>
    <virtual_drag coefficient="0.2" velocity="0.389 0 0"/>
    <wave_loads vessel="none" floes="none"/>
    <propeller_wash>
      <jet thruster="stern" diameter="0.2" position="-3 0 -0.2"/>
      <jet thrust="40" diameter="0.1" position="2 0 -0.2" direction="0 -2 0"/>
    </propeller_wash>
  </hydro>
  <wind speed="12" direction_deg="60" density="1.3" profile="power" exponent="0.1" gusts="npd" floe_drag="0.003"/>
  <tank length="40" width="20" depth="2.5" wall_thickness="0.3" floor="false"/>
  <vessel name="polaris" hull="hulls/icebreaker" position="1 2" heading_deg="20">
    <wind_area model="coefficients" file="coefficients.csv" frontal="0.5" lateral="2" length="6" midship="2.8"
               lateral_centroid="-0.1" height="0.3"/>
    <mass value="1500" cog="2.9 0 0.1" inertia="90 3200 3250 0 5 0"/>
    <carriage speed="0.3" heading_deg="10" ramp="2" ramp_shape="smooth" joint="2.9 0 0.2" free="heave yaw">
      <force_balance kind="six-cells" stiffness="2e7" damping="2e4" layout="cells.csv"/>
    </carriage>
  </vessel>
  <ice density="910" youngs_modulus="7e7" poisson="0.33" thickness="0.05">
    <field kind="packed" region="0 -5 40 5" concentration="0.75" breakable="true" overlap_tolerance="2e-3">
      <size distribution="lognormal" mean="0.9" sd="0.2" min="0.4" max="1.5"/>
      <shape kind="polygon" vertices="4 8"/>
    </field>
    <field kind="grid" region="0 5 40 6" rows="2" columns="3" gap="0.01" stagger="true" shear_deg="15" fixed="true"
           z="0.02" thickness="0.06"/>
    <field kind="file" file="floes.geojson" velocity="0.1 0 0"/>
    <field kind="channel" region="0 6 40 10" concentration="0.7" channel_width="2.5" overlap_tolerance="0">
      <size distribution="as-library"/>
      <shape library="floes.json"/>
    </field>
    <vary property="thickness" distribution="lognormal" cov="0.1" correlation_length="2"/>
    <vary property="flexural_strength" distribution="weibull" cov="0.2" mean="5e4" correlation_length="2"
          with="thickness" correlation="0.4"/>
    <floe name="big" outline="0 0 2 0 2 1 0 1" velocity="0 0.1 0" z="-0.01" thickness="0.07"/>
  </ice>
  <output folder="runs/towing" trajectory_every="0.5" contacts="none" problems="never" bodies="true"/>
  <view camera_elevation_deg="25" camera_heading_deg="200" camera_distance="12" target="3 0 0" mesh="fluid"
        wireframe="false" normals="false"/>
  <body name="box" shape="box" size="1 2 3" mass="12" inertia="13 10 5 0 0 0" position="5 6 7" rotation_deg="10 20 30"
        velocity="1 0 0" angular_velocity="0 0 1"/>
  <body name="ball" shape="sphere" radius="0.25" density="500"/>
  <body name="post" shape="cylinder" radius="0.2" height="4" fixed="true"/>
  <body name="ground" shape="plane"/>
  <body name="quay" shape="mesh" mesh="quay.stl" material="quay" fixed="true"/>
</scene>
)";

/// The line of the complete scene in which this text stands first; 0 where it has none.
inline int line_of(const std::string& text) {
  const std::string scene = k_complete_scene;
  const auto at = scene.find(text);
  if (at == std::string::npos) return 0;
  return 1 + static_cast<int>(std::count(scene.begin(), scene.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

}  // namespace nilas::testing
