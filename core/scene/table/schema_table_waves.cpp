#include "core/scene/table/schema_table.h"

namespace nilas::scene::schema_table {

static std::vector<AttributeSpec> attenuation_attributes(const WaveScene& values) {
  const Condition decays = when("attenuation", WaveAttenuation::exponential, WaveAttenuation::meylan);
  return {choice("attenuation", values.attenuation, "It says how ice weakens the waves."),
          {.name = "attenuation_rate",
           .unit = "1/m",
           .range = at_least(0),
           .default_value = written(values.attenuation_rate),
           .applies = when("attenuation", WaveAttenuation::exponential),
           .doc = "The energy falls as exp(-rate d) with the distance d behind the ice edge, and the amplitude by half "
                  "this rate. Measured rates are 1e-5 to 1e-3 per metre."},
          {.name = "ice_edge",
           .min_count = 2,
           .max_count = 2,
           .unit = "m",
           .applies = decays,
           .doc = "It is a point of the straight ice edge, x y in the ground frame. Waves in front of it are whole."},
          {.name = "ice_edge_deg",
           .unit = "deg",
           .default_note = "heading_deg",
           .applies = decays,
           .doc = "It is the direction across the edge into the ice, from X towards Y."}};
}

ElementSpec waves_element() {
  const WaveScene values;
  const Condition spectrum = when("kind", WaveKind::jonswap, WaveKind::pierson_moskowitz);
  ElementSpec element{
      .name = "waves",
      .parent = "water",
      .count = Count::many,
      .doc = "It adds waves of linear theory. Several elements add up. Loads on bodies need <hydro><wave_loads>.",
      .attributes = {
          choice("kind", values.kind, "It selects the spectrum."),
          {.name = "height",
           .unit = "m",
           .range = at_least(0),
           .required = true,
           .doc = "It is the height from trough to crest, or the significant height of a spectrum."},
          {.name = "period",
           .unit = "s",
           .range = above(0),
           .required = true,
           .doc = "It is the period, or that of the peak of a spectrum."},
          {.name = "heading_deg",
           .unit = "deg",
           .default_value = written(values.heading_deg),
           .doc = "It is the direction in which the waves travel, from X towards Y."},
          {.name = "phase_deg",
           .unit = "deg",
           .default_value = written(values.phase_deg),
           .applies = when("kind", WaveKind::regular),
           .doc = "It is the phase at the origin of the ground frame and time 0: a crest at 0, the rising surface at "
                  "-90."},
          {.name = "gamma",
           .range = {.min = 1, .max = 20},
           .default_value = written(values.gamma),
           .applies = when("kind", WaveKind::jonswap),
           .doc = "It is the peakedness. With 1 the spectrum is that of Pierson and Moskowitz."},
          {.name = "components",
           .type = ValueType::integer,
           .range = {.min = 1, .max = 10000},
           .default_value = written(values.components),
           .applies = spectrum,
           .doc = "It is the number of waves that stand for the spectrum. Each has the same energy; frequencies within "
                  "the bins and phases follow from <seed>."},
          {.name = "shortest_period",
           .unit = "s",
           .range = above(0),
           .default_note = "a quarter of the period",
           .applies = spectrum,
           .doc = "Shorter waves are left out; the others keep the whole energy."},
          {.name = "spreading",
           .range = {.min = 0, .max = 1000, .min_inclusive = false},
           .default_note = "all waves travel in one direction",
           .applies = spectrum,
           .doc =
               "It is s of the directional density cos^2s((b - heading) / 2). Swell has 25 and more, a wind sea 5 to "
               "15."},
          {.name = "ramp",
           .unit = "s",
           .range = at_least(0),
           .default_value = written(values.ramp),
           .doc = "The waves rise over this time at the start, so that nothing is hit by a whole wave at once."},
          {.name = "depth",
           .unit = "m",
           .range = above(0),
           .default_note = "that of <tank>, else infinite",
           .doc = "It is the depth of the water, on which the length of waves depends."}}};
  for (AttributeSpec& attribute : attenuation_attributes(values)) element.attributes.push_back(std::move(attribute));
  return element;
}

ElementSpec wave_loads_element() {
  const WaveLoadsScene values;
  return {.name = "wave_loads",
          .parent = "hydro",
          .doc = "It adds the loads of <waves>. Without it waves act only through drag.",
          .attributes = {choice("vessel", values.vessel, "It selects the load on the vessel."),
                         [&] {
                           AttributeSpec diffraction =
                               choice("diffraction", values.diffraction, "It says how the hull disturbs the waves.");
                           diffraction.applies = when("vessel", VesselWaveLoads::froude_krylov);
                           return diffraction;
                         }(),
                         choice("floes", values.floes,
                                "It selects the load on free floes and bodies. With <added_mass> the water that "
                                "follows the waves pushes them too."),
                         [&] {
                           AttributeSpec drift = choice("drift", values.drift, "It selects loads of second order.");
                           drift.applies = when("vessel", VesselWaveLoads::database);
                           return drift;
                         }()}};
}

}  // namespace nilas::scene::schema_table
