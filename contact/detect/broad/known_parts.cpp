#include "contact/detect/broad/known_parts.h"

#include <algorithm>

namespace nilas::detect {

namespace {

struct BodyOrder {
  bool operator()(const Part& part, int body) const { return part.body < body; }
  bool operator()(int body, const Part& part) const { return body < part.body; }
};

}  // namespace

std::vector<int> KnownParts::keep(const std::vector<char>& gone) {
  std::vector<int> new_body, new_part;
  int bodies_kept = 0, parts_kept = 0;
  for (const char body : gone) new_body.push_back(body ? -1 : bodies_kept++);
  std::vector<char> gone_parts;
  for (Part& part : parts) {
    gone_parts.push_back(gone[part.body]);
    new_part.push_back(gone[part.body] ? -1 : parts_kept++);
    part.body = new_body[part.body];
  }
  bodies::remove_marked(gone_parts, parts);
  bodies::remove_marked(gone_parts, touching);
  bodies::remove_marked(gone, ids);
  bodies::remove_marked(gone, shapes);
  bodies::remove_marked(gone, thickness);
  return new_part;
}

std::vector<int> KnownParts::forget_gone(const bodies::Bodies& bodies) {
  std::vector<char> gone;
  std::size_t kept = 0;
  for (std::size_t b = 0; b < ids.size(); ++b) {
    const bool is_there = kept < bodies.id.size() && bodies.id[kept] == ids[b] && bodies.shape[kept] == shapes[b];
    gone.push_back(is_there ? 0 : 1);
    kept += is_there ? 1 : 0;
  }
  if (kept == ids.size()) return {};
  return keep(gone);
}

void KnownParts::add_new(const bodies::Bodies& bodies) {
  for (std::size_t b = ids.size(); b < bodies.id.size(); ++b) {
    ids.push_back(bodies.id[b]);
    shapes.push_back(bodies.shape[b]);
    thickness.push_back(0);
    for (Part& part : make_parts(bodies, static_cast<int>(b))) {
      touching.push_back(part.cover ? part.cover->tolerance : 0);
      thickness.back() = std::max(thickness.back(), 2 * part.inner_radius);
      parts.push_back(std::move(part));
    }
  }
}

std::pair<std::vector<Part>::const_iterator, std::vector<Part>::const_iterator> KnownParts::of_body(int body) const {
  return std::equal_range(parts.begin(), parts.end(), body, BodyOrder{});
}

}  // namespace nilas::detect
