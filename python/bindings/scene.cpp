#include "bindings/scene.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <span>
#include <system_error>
#include <utility>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "bindings/arrays.hpp"
#include "bindings/errors.hpp"
#include "bindings/mesh_scene.hpp"
#include "bindings/options.hpp"
#include "bindings/work.hpp"
#include "files/message_text.hpp"
#include "picture/errors.hpp"
#include "picture/parse/parse.hpp"
#include "scene/clean/named_objects.hpp"
#include "scene/model/precision.hpp"
#include "scene/readers/scene_bytes.hpp"

namespace py = pybind11;

namespace ligne::python {
namespace {

std::shared_ptr<SceneHolder> hold(LoadedModels models, ModelRequest request) {
  auto holder = std::make_shared<SceneHolder>();
  RunReport run;
  report_healing(models, request, run);
  for (const ModelFile& file : models.files) {
    for (const std::string& line : file.warnings.lines()) holder->warnings.push_back(file.name + ": " + line);
    for (const std::string& remark : file.remarks) holder->warnings.push_back(file.name + ": " + remark);
  }
  for (const RunWarning& warning : run.warnings) holder->warnings.push_back(warning.place + ": " + warning.text);
  if (!models.topology) models.topology = build_topology(models.scene);
  holder->models = std::move(models);
  holder->request = std::move(request);
  return holder;
}

std::shared_ptr<SceneHolder> read_files(std::vector<std::string> files, const py::dict& options, py::handle threads) {
  ModelRequest request = model_request(options);
  request.files = std::move(files);
  std::shared_ptr<SceneHolder> holder;
  run(py::none(), threads_of(threads), [&](const Progress&) { holder = hold(load_models(request), request); });
  return holder;
}

template <class T>
MatrixView<T> matrix(const py::array& array) {
  MatrixView<T> m;
  m.data = static_cast<const std::byte*>(array.data());
  m.rows = static_cast<std::size_t>(array.shape(0));
  m.columns = array.ndim() > 1 ? static_cast<std::size_t>(array.shape(1)) : 1;
  m.row_step = array.strides(0);
  m.column_step = array.ndim() > 1 ? array.strides(1) : 0;
  return m;
}

/// The arrays for the conversion, which runs without the interpreter's lock and takes no reference. So the dtypes of
/// the arrays, which are Python objects, are read before.
struct MeshArrays {
  py::array vertices, corners;
  bool vertices_are_single = false, corners_are_signed = true, corners_are_wide = true;
  FaceLists lists;
  FaceLabels labels;
  std::optional<double> precision;
};

Scene scene_of(MeshArrays& arrays) {
  const bool single = arrays.vertices_are_single, wide = arrays.corners_are_wide;
  std::vector<Point3> points =
      single ? read_vertices(matrix<float>(arrays.vertices)) : read_vertices(matrix<double>(arrays.vertices));
  PolygonFaces faces;
  if (arrays.corners_are_signed && wide) {
    read_faces(matrix<std::int64_t>(arrays.corners), arrays.lists, points.size(), faces);
  } else if (arrays.corners_are_signed) {
    read_faces(matrix<std::int32_t>(arrays.corners), arrays.lists, points.size(), faces);
  } else if (wide) {
    read_faces(matrix<std::uint64_t>(arrays.corners), arrays.lists, points.size(), faces);
  } else {
    read_faces(matrix<std::uint32_t>(arrays.corners), arrays.lists, points.size(), faces);
  }
  double largest = 0;
  for (const Point3& p : points) {
    for (int k = 0; k < 3; ++k) largest = std::max(largest, std::abs(p[k]));
  }
  const double stored = single ? half_ulp_float32(largest) : half_ulp_double(largest);
  const double precision = std::max(arrays.precision.value_or(stored), half_ulp_double(largest));
  return assemble(std::move(points), std::move(faces), std::move(arrays.labels), precision);
}

std::shared_ptr<SceneHolder> make_mesh(py::array vertices, py::array corners, std::vector<std::uint32_t> contour_end,
                                       std::vector<std::uint32_t> face_end, std::vector<std::uint32_t> object,
                                       std::vector<std::string> object_names, std::vector<std::uint32_t> material,
                                       const std::vector<std::tuple<std::string, double, double, double, double>>& materials,
                                       std::optional<double> precision, const std::string& up_axis, const py::dict& options,
                                       py::handle threads) {
  ModelRequest request = model_request(options);
  const bool vertices_are_single = vertices.itemsize() == sizeof(float);
  const bool corners_are_signed = corners.dtype().kind() == 'i', corners_are_wide = corners.itemsize() == 8;
  MeshArrays arrays{std::move(vertices),
                    std::move(corners),
                    vertices_are_single,
                    corners_are_signed,
                    corners_are_wide,
                    {std::move(contour_end), std::move(face_end)},
                    {},
                    precision};
  arrays.labels = {std::move(object), std::move(object_names), std::move(material), {}};
  for (const auto& [name, red, green, blue, opacity] : materials) {
    arrays.labels.materials.push_back({name, {red, green, blue}, opacity});
  }
  Axis up = Axis::z;
  try {
    up = parse_axis(up_axis);
  } catch (const std::invalid_argument& e) {
    throw RequestError("up-axis", e.what());
  }
  std::shared_ptr<SceneHolder> holder;
  run(py::none(), threads_of(threads), [&](const Progress&) {
    Scene scene = scene_of(arrays);
    scene.up_axis = up;
    if (request.unit_mm) scene.unit_mm = *request.unit_mm;
    holder = hold(load_model(request, std::move(scene), "mesh"), request);
  });
  return holder;
}

py::object faces_of(const std::shared_ptr<SceneHolder>& holder) {
  const PolygonFaces& faces = holder->scene().faces;
  if (faces.all_triangles()) {
    return view(faces.corners().data(), {static_cast<py::ssize_t>(faces.size()), 3}, py::cast(holder));
  }
  py::list list;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    py::list contours;
    for (std::size_t c = 0; c < faces.contour_count(f); ++c) {
      const auto contour = faces.contour(f, c);
      contours.append(view(contour.data(), {static_cast<py::ssize_t>(contour.size())}, py::cast(holder)));
    }
    list.append(faces.contour_count(f) == 1 ? py::object(contours[0]) : py::object(contours));
  }
  return list;
}

py::object face_source_of(const std::shared_ptr<SceneHolder>& holder) {
  const std::vector<std::uint32_t>& source = holder->scene().face_source;
  if (source.empty()) return py::none();
  return view(source.data(), {static_cast<py::ssize_t>(source.size())}, py::cast(holder));
}

std::vector<std::string> object_names_of(const SceneHolder& holder) {
  std::vector<std::string> names;
  for (const Object& object : holder.scene().objects) names.push_back(object_name(object, names.size()));
  return names;
}

/// The state of a scene for pickle. The topology is computed again.
py::tuple state_of(const SceneHolder& holder) {
  if (holder.models.compiled) {
    PyErr_SetString(PyExc_TypeError, "a compiled model can not be pickled: read() its file instead");
    throw py::error_already_set();
  }
  ByteWriter bytes;
  {
    const py::gil_scoped_release released;
    write_scene(bytes, holder.scene());
  }
  std::vector<std::string> files;
  for (const std::filesystem::path& file : holder.inputs()) files.push_back(file.string());
  return py::make_tuple(py::bytes(bytes.bytes()), holder.scene().face_source, static_cast<int>(holder.request.quality),
                        holder.request.unit_mm, holder.models.object_names, holder.warnings, files);
}

std::shared_ptr<SceneHolder> scene_of_state(const py::tuple& state) {
  constexpr std::size_t kParts = 7;
  if (state.size() != kParts) throw InputError("pickle: is not a scene of this version of ligne");
  const auto text = state[0].cast<std::string>();
  auto holder = std::make_shared<SceneHolder>();
  const int quality = state[2].cast<int>();
  holder->request.quality = quality == 0 ? Quality::clear : Quality::exact;
  holder->request.unit_mm = state[3].cast<std::optional<double>>();
  holder->models.object_names = state[4].cast<std::vector<std::string>>();
  holder->warnings = state[5].cast<std::vector<std::string>>();
  ModelFile& file = holder->models.files.emplace_back();
  for (const auto& name : state[6].cast<std::vector<std::string>>()) file.report.files.emplace_back(name);
  auto face_source = state[1].cast<std::vector<std::uint32_t>>();
  const py::gil_scoped_release released;
  ByteReader bytes(std::as_bytes(std::span(text)), "pickle");
  holder->models.scene = read_scene(bytes);
  bytes.need(face_source.empty() || face_source.size() == holder->scene().faces.size(), "faces have no source");
  holder->models.scene.face_source = std::move(face_source);
  holder->models.topology = build_topology(holder->scene());
  return holder;
}

}  // namespace

InputFiles SceneHolder::inputs() const {
  InputFiles inputs;
  for (const ModelFile& file : models.files) {
    inputs.insert(inputs.end(), file.report.files.begin(), file.report.files.end());
  }
  return inputs;
}

void refuse_inputs(const InputFiles& inputs, const std::string& field, const std::string& file) {
  for (const std::filesystem::path& input : inputs) {
    std::error_code absent;
    if (!file.empty() && std::filesystem::equivalent(file, input, absent) && !absent)
      throw RequestError(field, printable(file, kLongestPath) + " is also an input file, and would be overwritten");
  }
}

void add_scene(py::module_& module) {
  py::class_<SceneHolder, std::shared_ptr<SceneHolder>>(module, "Scene", "A scene after reading and repair.")
      .def_property_readonly("vertices",
                             [](const std::shared_ptr<SceneHolder>& holder) {
                               const std::vector<Point3>& points = holder->scene().vertices;
                               return view(points.empty() ? nullptr : &points.front().x,
                                           {static_cast<py::ssize_t>(points.size()), 3}, py::cast(holder));
                             })
      .def_property_readonly("faces", &faces_of)
      .def_property_readonly("face_source", &face_source_of)
      .def_property_readonly("object_names", &object_names_of)
      .def_property_readonly("face_count", [](const SceneHolder& holder) { return holder.scene().faces.size(); })
      .def_property_readonly("edge_count", [](const SceneHolder& holder) { return holder.topology().edges.size(); })
      .def_property_readonly("unit_mm", [](const SceneHolder& holder) { return holder.scene().unit_mm; })
      .def_property_readonly(
          "up_axis",
          [](const SceneHolder& holder) { return std::string(1, "xyz"[static_cast<unsigned>(holder.scene().up_axis)]); })
      .def_property_readonly("quality",
                             [](const SceneHolder& holder) {
                               return std::string(kQualityNames[static_cast<std::size_t>(holder.request.quality)]);
                             })
      .def_property_readonly("warnings", [](const SceneHolder& holder) { return holder.warnings; })
      .def(py::pickle(&state_of, &scene_of_state));
  module.def("read", &read_files, py::arg("files"), py::arg("options"), py::arg("threads"));
  module.def("mesh", &make_mesh, py::arg("vertices"), py::arg("corners"), py::arg("contour_end"), py::arg("face_end"),
             py::arg("object"), py::arg("object_names"), py::arg("material"), py::arg("materials"), py::arg("precision"),
             py::arg("up_axis"), py::arg("options"), py::arg("threads"));
}

}  // namespace ligne::python
