#include "core/sim/build/module/breaking_settings.h"

#include "core/base/error.h"

namespace nilas::sim {

static fracture::FailureSettings failure_settings(const scene::Scene& scene) {
  NILAS_DEMAND(scene.fracture && scene.water && scene.ice);
  const scene::FractureScene& fracture = *scene.fracture;
  fracture::FailureSettings settings;
  settings.youngs_modulus = scene.ice->youngs_modulus;
  settings.poisson = scene.ice->poisson;
  settings.water_density = scene.water->density;
  settings.gravity = scene.gravity.norm();
  settings.min_area = fracture.min_area;
  settings.max_aspect = fracture.max_aspect;
  if (fracture.bending) {
    settings.bending = true;
    settings.wedge_angle = fracture.bending->wedge_angle_deg * k_deg;
    settings.speed.slope = fracture.bending->speed_slope;
  }
  if (fracture.splitting) {
    settings.splitting = fracture.splitting->model;
    settings.multiplier = fracture.splitting->multiplier;
  }
  if (fracture.cracks) {
    settings.curved = fracture.cracks->path == CrackPathKind::curved;
    settings.segment = fracture.cracks->segment_thicknesses;
  }
  return settings;
}

fracture::BreakingSettings breaking_settings(const scene::Scene& scene) {
  fracture::BreakingSettings settings{failure_settings(scene), {}};
  if (const auto& damage = scene.fracture->damage)
    settings.damage = fracture::DamageRule{damage->exponent, damage->endurance};
  return settings;
}

fracture::PieceLimits piece_limits(const scene::Scene& scene) {
  NILAS_DEMAND(scene.fracture.has_value());
  fracture::PieceLimits limits;
  limits.min_area = scene.fracture->min_area;
  limits.small = scene.fracture->small_pieces;
  return limits;
}

std::string breaking_description(const scene::Scene& scene) {
  NILAS_DEMAND(scene.fracture.has_value());
  std::string text;
  if (scene.fracture->bending) text = "<fracture><bending>: " + name_of(scene.fracture->bending->model);
  if (scene.fracture->splitting)
    text += (text.empty() ? "" : "; ") + ("<fracture><splitting>: " + name_of(scene.fracture->splitting->model));
  if (scene.fracture->cracks) text += "; <fracture><cracks>: " + name_of(scene.fracture->cracks->path);
  if (scene.fracture->damage) text += "; <fracture><damage>";
  return text;
}

}  // namespace nilas::sim
