#include "apps/report/floe_outlines.h"

#include <tinyxml2.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>

#include "core/base/error.h"
#include "core/output/vtk/vtp_array.h"

namespace nilas::report {

namespace {

using Element = tinyxml2::XMLElement;

const Element* child_at(const Element* element, std::initializer_list<const char*> path) {
  for (const char* name : path)
    if (element != nullptr) element = element->FirstChildElement(name);
  return element;
}

void load(const std::filesystem::path& path, tinyxml2::XMLDocument& document) {
  const auto error = document.LoadFile(path.c_str());
  if (error == tinyxml2::XML_SUCCESS) return;
  const std::string message = path.string() + ": cannot be read: " + document.ErrorStr();
  if (error == tinyxml2::XML_ERROR_FILE_NOT_FOUND || error == tinyxml2::XML_ERROR_FILE_COULD_NOT_BE_OPENED)
    throw FileError(message);
  throw InputError(message);
}

/// The values of the array of this name and number type among the children of `parent`. Throws InputError without one.
template <class Number>
std::vector<Number> values_of(const Element* parent, const char* name, const char* type) {
  const Element* array = parent == nullptr ? nullptr : parent->FirstChildElement("DataArray");
  while (array != nullptr && !array->Attribute("Name", name)) array = array->NextSiblingElement("DataArray");
  if (array == nullptr || !array->Attribute("type", type) || array->GetText() == nullptr)
    throw InputError(std::string("the file holds no ") + type + " array " + name);
  const std::string bytes = output::array_bytes(array->GetText());
  std::vector<Number> values(bytes.size() / sizeof(Number));
  std::memcpy(values.data(), bytes.data(), values.size() * sizeof(Number));
  return values;
}

/// Adds the upper faces in G [m] and their floes to a frame. The upper face is the second polygon of each floe.
void add_upper_faces(const Element* piece, IceFrame& frame) {
  const auto points = values_of<float>(child_at(piece, {"Points"}), "Points", "Float32");
  const Element* polygons = child_at(piece, {"Polys"});
  const auto corners = values_of<std::int32_t>(polygons, "connectivity", "Int32");
  const auto ends = values_of<std::int32_t>(polygons, "offsets", "Int32");
  const auto ids = values_of<std::int64_t>(child_at(piece, {"CellData"}), "id", "Int64");
  if (ids.size() != ends.size()) throw InputError("the file does not have one id per polygon");
  std::int64_t count = 0;
  for (std::size_t k = 0; k < ids.size(); ++k) {
    count = k > 0 && ids[k] == ids[k - 1] ? count + 1 : 1;
    if (count != 2) continue;
    if (ends[k] - ends[k - 1] < 3) throw InputError("a polygon has fewer than three corners");
    frame.ids.push_back(ids[k]);
    std::vector<Vec3>& face = frame.outlines.emplace_back();
    for (auto c = static_cast<std::size_t>(ends[k - 1]); c < static_cast<std::size_t>(ends[k]); ++c) {
      const std::size_t p = 3 * static_cast<std::size_t>(corners.at(c));
      face.emplace_back(points.at(p), points.at(p + 1), points.at(p + 2));
    }
  }
}

}  // namespace

std::vector<IceFrameFile> ice_frame_files(const std::filesystem::path& run_folder) {
  const auto list = run_folder / "trajectory.pvd";
  if (!std::filesystem::exists(list)) return {};
  tinyxml2::XMLDocument document;
  load(list, document);
  std::vector<IceFrameFile> frames;
  const Element* set = child_at(document.RootElement(), {"Collection", "DataSet"});
  for (; set != nullptr; set = set->NextSiblingElement("DataSet"))
    if (set->Attribute("name", "ice floes") && set->Attribute("file") != nullptr)
      frames.push_back({set->DoubleAttribute("timestep"), run_folder / set->Attribute("file")});
  return frames;
}

IceFrame read_ice_frame(const IceFrameFile& frame) {
  tinyxml2::XMLDocument document;
  load(frame.file, document);
  IceFrame ice;
  ice.t = frame.t;
  try {
    add_upper_faces(child_at(document.RootElement(), {"PolyData", "Piece"}), ice);
    return ice;
  } catch (const InputError& error) {
    throw InputError(frame.file.string() + ": " + error.what());
  } catch (const std::out_of_range&) {
    throw InputError(frame.file.string() + ": a polygon has a corner that is no point");
  }
}

std::optional<IceFrame> ice_near(const std::filesystem::path& run_folder, double t) {
  const auto frames = ice_frame_files(run_folder);
  const auto nearest = std::min_element(frames.begin(), frames.end(), [&](const auto& a, const auto& b) {
    return std::abs(a.t - t) < std::abs(b.t - t);
  });
  if (nearest == frames.end()) return std::nullopt;
  return read_ice_frame(*nearest);
}

}  // namespace nilas::report
