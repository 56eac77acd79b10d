#include "nilas/scene.h"

#include <utility>

#include "core/scene/read/read_scene.h"
#include "nilas/error.h"
#include "nilas/scene_content.h"
#include "nilas/translate.h"

namespace nilas {

static void demand_scale(double scale) {
  if (!(scale > 0)) throw Error(ErrorKind::input, "scale must be above 0");
}

Scene::Scene(std::unique_ptr<Content> content) : content_(std::move(content)) {}
Scene::Scene(const Scene& other) : content_(std::make_unique<Content>(*other.content_)) {}
Scene::Scene(Scene&& other) noexcept = default;
Scene& Scene::operator=(const Scene& other) {
  if (this != &other) content_ = std::make_unique<Content>(*other.content_);
  return *this;
}
Scene& Scene::operator=(Scene&& other) noexcept = default;
Scene::~Scene() = default;

Scene Scene::read(const std::filesystem::path& file, const std::vector<Setting>& settings, double scale) {
  return library::translated([&] {
    demand_scale(scale);
    return Scene(std::make_unique<Content>(Content{scene::read_scene(file, settings, scale)}));
  });
}

Scene Scene::parse(const std::string& xml, const std::filesystem::path& name, const std::vector<Setting>& settings,
                   double scale) {
  return library::translated([&] {
    demand_scale(scale);
    return Scene(std::make_unique<Content>(Content{scene::read_scene_text(xml, name, settings, scale)}));
  });
}

const std::string& Scene::name() const { return content_->scene.name; }
double Scene::start() const { return content_->scene.time.start; }
double Scene::end() const { return content_->scene.time.end; }
double Scene::step() const { return content_->scene.time.step; }
std::string Scene::xml() const { return content_->scene.as_run; }
std::string Scene::fingerprint() const { return content_->scene.fingerprint; }

std::vector<std::string> Scene::notes() const {
  std::vector<std::string> all = content_->scene.notes;
  all.insert(all.end(), content_->scene.derived.begin(), content_->scene.derived.end());
  return all;
}

std::vector<std::string> Scene::warnings() const {
  std::vector<std::string> all;
  for (const Fault& warning : content_->scene.warnings) all.push_back(warning.text());
  return all;
}

}  // namespace nilas
