#include <stdexcept>
#include <utility>
#include <vector>

#include "bindings/drawing.hpp"
#include "bindings/values.hpp"
#include "picture/compiled_model.hpp"
#include "picture/errors.hpp"
#include "picture/frame_names.hpp"
#include "picture/frames.hpp"
#include "picture/parse.hpp"
#include "picture/parse_options.hpp"
#include "picture/scene_info.hpp"
#include "plotting/output_file.hpp"
#include "visibility/registry.hpp"

#include <pybind11/stl.h>

namespace py = pybind11;

namespace ligne::python {
namespace {

using SceneArgument = std::shared_ptr<SceneHolder>;

std::string info(const SceneArgument& scene, const py::dict& keywords) {
  Options options;
  options.take(keywords);
  adapt(options, *scene);
  const PictureRequest request = options.request();
  std::string text;
  run(py::none(), options.threads, [&](const Progress&) {
    RunReport report;
    text = info_json(scene->models, scene_info(scene->models, request.view, request.lines, request.page, report));
  });
  return text;
}

const Method& compiling_method(const std::string& name) {
  const std::vector<std::string_view> names = compiling_methods();
  try {
    return *find_method(names[parse_choice(name, names)]);
  } catch (const std::invalid_argument& e) {
    throw RequestError("method", e.what());
  }
}

void compile(const SceneArgument& scene, const std::string& file, const std::string& method_name, const py::dict& parameters,
             py::handle threads) {
  const Method& method = compiling_method(method_name);
  if (scene->models.compiled_for) throw RequestError("model", "is compiled already");
  MethodSettings settings;
  for_each_option(parameters, [&](const std::string& name, py::handle value) {
    set_parameter(settings, method, name, text_of(name, value));
  });
  run(py::none(), threads_of(threads), [&](const Progress&) {
    RunReport report;
    write_output(file, write_compiled_model(compile_model(scene->scene(), method, settings, report)));
  });
}

/// The files that were written.
std::vector<std::string> frames(const SceneArgument& scene, const std::string& file, unsigned count, double turn_degrees,
                                const py::dict& keywords, const py::object& progress) {
  if (count == 0) throw RequestError("frames", "is not above 0");
  Options options;
  options.take(with_format(keywords, file));
  adapt(options, *scene);
  PictureRequest request = request_for(options, *scene);
  const bool as_pages = request.output.format == OutputFormat::pdf && !has_number_place(file);
  const std::vector<std::string> names = numbered_names(file, as_pages ? 1 : count);
  run(progress, options.threads, [&](const Progress& report) {
    request.progress = report;
    RunReport run;
    OutputFiles files;
    std::size_t frame = 0;
    draw_frames(scene->scene(), request, {count, turn_degrees}, as_pages, run, scene->topology(),
                [&](Picture picture) { files.add(names[frame++], std::move(picture.bytes)); });
    files.commit();
  });
  return names;
}

}  // namespace

void add_model_work(py::module_& module) {
  module.def("info", &info, py::arg("scene"), py::arg("options"));
  module.def("compile", &compile, py::arg("scene"), py::arg("file"), py::arg("method"), py::arg("parameters"),
             py::arg("threads"));
  module.def("draw_frames", &frames, py::arg("scene"), py::arg("file"), py::arg("frames"), py::arg("turn"),
             py::arg("options"), py::arg("progress"));
}

}  // namespace ligne::python
