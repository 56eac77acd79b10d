#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "nilas/scene.h"
#include "nilas/schema.h"
#include "python/binding/module.h"
#include "python/binding/simulation_docs.h"

namespace nilas::python {

namespace py = pybind11;

namespace {

py::dict dict_of(const AttributeInfo& info) {
  py::dict all;
  all["name"] = info.name;
  all["type"] = info.type;
  all["min_count"] = info.min_count;
  all["max_count"] = info.max_count;
  all["unit"] = info.unit;
  all["default"] = info.default_value;
  all["default_note"] = info.default_note;
  all["allowed"] = info.allowed;
  all["choices"] = info.choices;
  all["required"] = info.required;
  all["doc"] = info.doc;
  return all;
}

py::list schema() {
  py::list elements;
  for (const ElementInfo& info : scene_schema()) {
    py::dict element;
    element["name"] = info.name;
    element["parent"] = info.parent;
    element["may_repeat"] = info.may_repeat;
    element["doc"] = info.doc;
    py::list attributes;
    for (const AttributeInfo& attribute : info.attributes) attributes.append(dict_of(attribute));
    element["attributes"] = attributes;
    elements.append(element);
  }
  return elements;
}

}  // namespace

void bind_scenes(py::module_& module) {
  py::class_<Scene>(module, "CheckedScene", docs::k_checked_scene)
      .def_static("read", &Scene::read, py::arg("file"), py::arg("settings") = std::vector<Setting>(),
                  py::arg("scale") = 1.0, docs::k_read_scene)
      .def_static("parse", &Scene::parse, py::arg("xml"), py::arg("name"), py::arg("settings") = std::vector<Setting>(),
                  py::arg("scale") = 1.0, docs::k_parse_scene)
      .def_property_readonly("name", &Scene::name)
      .def_property_readonly("start", &Scene::start, "[s]")
      .def_property_readonly("end", &Scene::end, "[s]")
      .def_property_readonly("step", &Scene::step, "[s]")
      .def_property_readonly("xml", &Scene::xml, "The scene with every default written out.")
      .def_property_readonly("fingerprint", &Scene::fingerprint)
      .def_property_readonly("notes", &Scene::notes)
      .def_property_readonly("warnings", &Scene::warnings);
  module.def("schema", &schema, "The table of elements and attributes of a scene.");
}

}  // namespace nilas::python
