#include "bindings/drawing.hpp"
#include "picture/draw_scene.hpp"

#include <array>
#include <utility>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "bindings/arrays.hpp"
#include "bindings/work.hpp"
#include "picture/errors.hpp"
#include "picture/parse/parse_options.hpp"
#include "picture/surface/mixed_scene.hpp"
#include "plotting/writers/output_file.hpp"

namespace py = pybind11;

namespace ligne::python {
namespace {

py::ssize_t rows(std::size_t n) { return static_cast<py::ssize_t>(n); }

/// The input number of a face, -1 for none.
std::int64_t given_face(const Scene& scene, std::uint32_t face) {
  if (face == kNone) return -1;
  return face < scene.face_source.size() ? scene.face_source[face] : face;
}

const DrawnScene& drawn_of(const DrawingHolder& holder) {
  if (const DrawnScene* drawn = holder.drawn()) return *drawn;
  throw RequestError("method", "the floating horizon gives only polylines; a mesh method gives strokes of edges");
}

Point3 point_at(const SourceEdge& edge, double t) { return edge.ends[0] + t * (edge.ends[1] - edge.ends[0]); }

/// Properties of the strokes, as arrays with one row per stroke.
py::dict strokes(const DrawingHolder& holder) {
  const DrawnScene& drawn = drawn_of(holder);
  const SceneVisibility& study = drawn.visibility();
  const StrokeModel& model = *study.result.strokes;
  const Scene& scene = drawn.prepared().scene;
  const std::size_t n = model.strokes.size();
  std::vector<double> points(4 * n), parameter(2 * n), space(6 * n);
  std::vector<std::uint8_t> kind(n), level(n);
  std::vector<std::uint8_t> visible(n);
  std::vector<std::int64_t> edge(2 * n), faces(2 * n), surfaces(2 * n, -1);
  {
    const py::gil_scoped_release released;
    const std::vector<std::uint32_t> surface_of = drawn.surfaces().of_face;
    for (std::size_t i = 0; i < n; ++i) {
      const Stroke& stroke = model.strokes[i];
      const Point2 from = model.lattice.to_mm(stroke.from), to = model.lattice.to_mm(stroke.to);
      points[4 * i] = from.x, points[4 * i + 1] = from.y, points[4 * i + 2] = to.x, points[4 * i + 3] = to.y;
      parameter[2 * i] = stroke.t_from, parameter[2 * i + 1] = stroke.t_to;
      kind[i] = static_cast<std::uint8_t>(stroke.line_class);
      visible[i] = stroke.visible ? 1 : 0;
      level[i] = stroke.level;
      const SourceEdge source = study.source(scene, stroke.source);
      const bool of_scene = stroke.source < model.edge_count;
      const std::array<double, 2> t{stroke.t_from, stroke.t_to};
      for (std::size_t k = 0; k < 2; ++k) {
        const std::uint32_t face = source.faces[k];
        faces[2 * i + k] = given_face(scene, face);
        if (face < surface_of.size() && surface_of[face] != kNone) surfaces[2 * i + k] = surface_of[face];
        edge[2 * i + k] = !of_scene ? -1 : k == 0 ? study.edges[stroke.source].v0 : study.edges[stroke.source].v1;
        const Point3 p = point_at(source, t[k]);
        for (int c = 0; c < 3; ++c) space[6 * i + 3 * k + static_cast<std::size_t>(c)] = p[c];
      }
    }
  }
  py::dict arrays;
  arrays["points"] = owned(std::move(points), {rows(2 * n), 2});
  arrays["points3d"] = owned(std::move(space), {rows(2 * n), 3});
  arrays["parameter"] = owned(std::move(parameter), {rows(n), 2});
  arrays["kind"] = owned(std::move(kind), {rows(n)});
  arrays["visible"] = owned(std::move(visible), {rows(n)});
  arrays["level"] = owned(std::move(level), {rows(n)});
  arrays["edge"] = owned(std::move(edge), {rows(n), 2});
  arrays["faces"] = owned(std::move(faces), {rows(n), 2});
  arrays["surfaces"] = owned(std::move(surfaces), {rows(n), 2});
  return arrays;
}

std::size_t polyline_count(DrawingHolder& holder) {
  const py::gil_scoped_release released;
  std::size_t count = 0;
  for (const Layer& layer : holder.layers().layers) count += layer.lines.size();
  return count;
}

std::size_t stroke_count(const DrawingHolder& holder) {
  return holder.drawn() ? holder.drawn()->visibility().result.strokes->strokes.size() : 0;
}

py::array_t<double> polyline(std::span<const Point2> points) {
  py::array_t<double> array({rows(points.size()), py::ssize_t{2}});
  double* to = array.mutable_data();
  for (const Point2& p : points) *to++ = p.x, *to++ = p.y;
  return array;
}

/// (name, object, list of polylines) per layer, in painting order.
py::list layers(DrawingHolder& holder) {
  Drawing drawing;
  {
    const py::gil_scoped_release released;
    drawing = holder.layers();
  }
  py::list list;
  for (const Layer& layer : drawing.layers) {
    py::list lines;
    for (std::size_t i = 0; i < layer.lines.size(); ++i) lines.append(polyline(layer.lines[i]));
    list.append(py::make_tuple(layer.name, layer.object, lines));
  }
  return list;
}

/// (face, contours, level, lights) per region; None without regions.
py::object regions(const DrawingHolder& holder) {
  const DrawnScene& drawn = drawn_of(holder);
  if (!drawn.visibility().result.regions) return py::none();
  py::list list;
  for (const Region& region : *drawn.visibility().result.regions) {
    py::list contours;
    for (const std::vector<Point2>& contour : region.contours) contours.append(read_only(polyline(contour)));
    list.append(py::make_tuple(given_face(drawn.prepared().scene, region.face), contours, region.level, region.lights));
  }
  return list;
}

py::tuple tuple_of(const Point3& p) { return py::make_tuple(p.x, p.y, p.z); }

/// The members of FittedSurface (_found.py), in order, per surface.
py::list surfaces(const DrawingHolder& holder) {
  const DrawnScene& drawn = drawn_of(holder);
  FoundSurfaces found;
  {
    const py::gil_scoped_release released;
    found = drawn.surfaces();
  }
  py::list list;
  for (const FoundSurface& f : found.list) {
    const PatchSurface& s = f.surface;
    const auto where = [](bool has, py::object value) { return has ? value : py::object(py::none()); };
    list.append(py::make_tuple(kSurfaceKindNames[static_cast<std::size_t>(s.kind)], tuple_of(s.at),
                               where(f.has_axis(), tuple_of(s.axis)), where(f.has_radius(), py::float_(s.radius)),
                               where(s.kind == SurfaceKind::cone, py::float_(s.slope)),
                               where(s.kind == SurfaceKind::torus, py::float_(s.tube)),
                               where(f.has_length(), py::make_tuple(f.along[0], f.along[1])),
                               where(f.has_turn(), py::float_(f.turn)), f.outward, f.sag, f.faces, f.object));
  }
  return list;
}

/// Matrix from model coordinates to page mm, see View::model_to_page.
py::array_t<double> matrix(const DrawingHolder& holder) {
  const glm::dmat4& m = drawn_of(holder).prepared().view().model_to_page;
  py::array_t<double> array({4, 4});
  auto to = array.mutable_unchecked<2>();
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) to(row, column) = m[column][row];
  }
  return read_only(array);
}

py::dict report(const DrawingHolder& holder) {
  const RunReport& run = holder.report();
  py::dict counts, seconds, clear, stages;
  for (const auto& [name, n] : run.study.counts) counts[py::str(name)] = n;
  for (const auto& [name, s] : run.study.seconds) seconds[py::str(name)] = s;
  for (const auto& [name, n] : run.clear.counts) clear[py::str(name)] = n;
  for (const auto& [name, s] : run.stages.seconds) stages[py::str(name)] = s;
  py::dict all;
  all["method"] = run.method;
  all["counts"] = counts;
  all["seconds"] = seconds;
  all["clear"] = clear;
  all["stages"] = stages;
  return all;
}

std::vector<std::string> warnings(const DrawingHolder& holder) {
  std::vector<std::string> texts;
  for (const RunWarning& w : holder.report().warnings) texts.push_back(w.place.empty() ? w.text : w.place + ": " + w.text);
  return texts;
}

MeshFormat mesh_format_of(const std::string& file) {
  try {
    return mesh_format_of_suffix(file);
  } catch (const std::invalid_argument& e) {
    throw RequestError("as-mesh", e.what());
  }
}

}  // namespace

void adapt(Options& options, const SceneHolder& scene) {
  options.picture.lines.quality = scene.request.quality;
  if (!options.picture.page.unit_mm) options.picture.page.unit_mm = scene.request.unit_mm;
  const Method* const compiled_for = scene.models.compiled_for;
  if (compiled_for && !options.picture.lines.method) options.picture.lines.method = compiled_for;
  if (!compiled_for || compiled_for != options.picture.lines.method) return;
  std::vector<std::string> names;
  for (const auto& [name, value] : options.parameters) names.push_back(name);
  require_no_parameters(scene.models, names);
  options.picture.compiled = scene.models.compiled;
}

PictureRequest request_for(const Options& options, const SceneHolder& scene) {
  PictureRequest request = options.request();
  require_parts(scene.models, request);
  return request;
}

std::shared_ptr<DrawingHolder> DrawingHolder::of_scene(std::shared_ptr<const SceneHolder> scene,
                                                       const SurfaceRequest& surfaces, Options options,
                                                       const py::object& progress) {
  auto holder = std::make_shared<DrawingHolder>();
  check_mixed_scene(surfaces);
  if (has_surfaces(surfaces)) {
    run(py::none(), options.threads, [&](const Progress&) {
      auto mixed = std::make_shared<SceneHolder>(*scene);
      add_surfaces(surfaces, mixed->models, options.picture, holder->run_);
      mixed->models.topology = build_topology(mixed->scene());
      scene = std::move(mixed);
    });
  }
  adapt(options, *scene);
  if (options.picture.gray_faces) options.picture.output.format = OutputFormat::png;
  holder->scene_ = std::move(scene);
  holder->options_ = std::move(options);
  const PictureRequest request = request_for(holder->options_, *holder->scene_);
  run(progress, holder->options_.threads, [&](const Progress& report) { holder->draw(request, report); });
  return holder;
}

std::shared_ptr<DrawingHolder> DrawingHolder::of_surface(SurfaceRequest surface, Options options,
                                                         const py::object& progress) {
  auto holder = std::make_shared<DrawingHolder>();
  options.picture.axes = surface.picture.axes;
  holder->surface_ = std::move(surface);
  holder->options_ = std::move(options);
  const PictureRequest request = holder->options_.request();
  run(progress, holder->options_.threads, [&](const Progress& report) { holder->draw(request, report); });
  return holder;
}

void DrawingHolder::draw(const PictureRequest& request, const Progress& progress) {
  PictureRequest picture = request;
  picture.progress = progress;
  RunReport report;
  report.files = run_.files;  // files of surfaces among models, and of earlier drawings
  if (!surface_) {
    drawn_ = std::make_unique<DrawnScene>(
        draw_lines(scene_->scene(), std::move(picture), report, std::nullopt, scene_->topology(), true));
  } else {
    SurfaceRequest surface = *surface_;
    surface.picture = std::move(picture);
    check(surface);
    const std::string mesh = needs_mesh(surface), horizon = needs_horizon(surface);
    if (options_.horizon_given && !mesh.empty()) {
      throw RequestError("method", "horizon can not draw " + mesh + "; a mesh method does");
    }
    if (!horizon.empty() && !drawn_by_horizon(surface)) {
      throw RequestError("method", horizon + " is drawn by method horizon only, and can not be combined with " +
                                       (mesh.empty() ? "a mesh method" : mesh));
    }
    drawn_.reset();
    horizon_.reset();
    std::vector<Surface> surfaces = surfaces_of(surface, report);
    if (drawn_by_horizon(surface, surfaces)) horizon_ = draw_horizon(surface, surfaces, report);
    if (horizon_) {
      horizon_->picture.progress = {};
    } else {
      surface_scene_ = make_surface_scene(surface, surfaces, report);
      drawn_ = std::make_unique<DrawnScene>(
          draw_lines(surface_scene_->scene, surface_scene_->picture, report, surface_scene_->box, std::nullopt, true));
    }
  }
  run_ = std::move(report);
}

/// Locks a mutex whose holder may need the interpreter's lock, which the calling thread has.
static std::unique_lock<std::mutex> lock_without_interpreter(std::mutex& mutex) {
  const py::gil_scoped_release release;
  return std::unique_lock(mutex);
}

Picture DrawingHolder::write(const py::dict& keywords, const py::object& progress) {
  Options options = options_;
  options.take(keywords);
  const PictureRequest request = options.request();
  Picture picture;
  // A thread that waits for its tasks may take up the drawing of another one, so tasks lock nothing.
  const std::unique_lock lock = lock_without_interpreter(mutex_);
  run(progress, options.threads, [&](const Progress& report) {
    RunReport run;
    if (horizon_ && request.output.format != OutputFormat::json) {
      horizon_->picture.output = request.output;
      horizon_->picture.plotter = request.plotter;
      picture = write_horizon(*horizon_, run);
      return;
    }
    if (drawn_ && !request.gray_faces && drawn_->serves(request.output, request.plotter)) {
      drawn_->choose(request.output, request.plotter);
    } else {
      draw(request, report);
    }
    picture = drawn_->write(run);
  });
  return picture;
}

void DrawingHolder::refuse_its_inputs(const std::string& field, const std::string& file) const {
  if (scene_) refuse_inputs(scene_->inputs(), field, file);
  refuse_inputs(run_.files, field, file);
}

std::string DrawingHolder::write_mesh(MeshFormat format) const {
  if (!surface_) throw RequestError("as-mesh", "works for surfaces only; a scene is already a mesh");
  RunReport run;
  return write_surface_mesh(*surface_, format, run);
}

Drawing DrawingHolder::layers() {
  const std::lock_guard lock(mutex_);
  RunReport run;
  return drawn_ ? drawn_->compose(run) : horizon_->drawing;
}

const Page& DrawingHolder::page() const { return drawn_ ? drawn_->prepared().around.placement.page : horizon_->page; }

void add_drawing(py::module_& module) {
  py::class_<DrawingHolder, std::shared_ptr<DrawingHolder>>(module, "Drawing", "What was drawn.")
      .def("strokes", &strokes)
      .def_property_readonly("stroke_count", &stroke_count)
      .def_property_readonly("has_strokes", [](const DrawingHolder& holder) { return holder.drawn() != nullptr; })
      .def_property_readonly("polyline_count", &polyline_count)
      .def("layers", &layers)
      .def("surfaces", &surfaces)
      .def("regions", &regions)
      .def_property_readonly("matrix", &matrix)
      .def_property_readonly(
          "page_mm",
          [](const DrawingHolder& holder) { return py::make_tuple(holder.page().width_mm, holder.page().height_mm); })
      .def_property_readonly("report", &report)
      .def_property_readonly("warnings", &warnings)
      .def("write",
           [](DrawingHolder& holder, const py::dict& options, const py::object& progress) {
             const Picture picture = holder.write(options, progress);
             return py::make_tuple(py::bytes(picture.bytes), picture.preview, picture.plotter_report);
           })
      .def("save",
           [](DrawingHolder& holder, const std::string& file, const std::string& preview, const py::dict& keywords,
              const py::object& progress) {
             holder.refuse_its_inputs("file", file);
             holder.refuse_its_inputs("preview", preview);
             Picture picture = holder.write(with_format(keywords, file), progress);
             const py::gil_scoped_release released;
             OutputFiles files;
             files.add(file, std::move(picture.bytes));
             if (!preview.empty()) files.add(preview, std::move(picture.preview));
             files.commit();
             return picture.plotter_report;
           })
      .def("save_mesh",
           [](const DrawingHolder& holder, const std::string& file) {
             holder.refuse_its_inputs("file", file);
             const py::gil_scoped_release released;
             write_output(file, holder.write_mesh(mesh_format_of(file)));
           })
      .def("write_mesh", [](const DrawingHolder& holder, const std::string& format) {
        return py::bytes(holder.write_mesh(mesh_format_of("mesh." + format)));
      });
  module.def(
      "draw",
      [](std::shared_ptr<SceneHolder> scene, const py::dict& surfaces, const py::dict& keywords,
         const py::object& progress) {
        Options options;
        options.take(keywords);
        return DrawingHolder::of_scene(std::move(scene), surface_request(surfaces), std::move(options), progress);
      },
      py::arg("scene"), py::arg("surfaces"), py::arg("options"), py::arg("progress"));
  std::vector<std::string> kinds(kLineClassNames.begin(), kLineClassNames.end());
  module.attr("kinds") = kinds;
}

}  // namespace ligne::python
