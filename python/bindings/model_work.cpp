#include <stdexcept>
#include <utility>
#include <vector>

#include "bindings/drawing.hpp"
#include "bindings/values.hpp"
#include "picture/errors.hpp"
#include "picture/models/compiled_model.hpp"
#include "picture/pages/frames.hpp"
#include "picture/parse/parse.hpp"
#include "picture/parse/parse_options.hpp"
#include "plotting/writers/output_file.hpp"
#include "report/compare.hpp"
#include "report/compare_output.hpp"
#include "report/scene_info.hpp"
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

/// The keywords of a comparison besides the options of a picture.
struct CompareKeywords {
  CompareRequest request;
  std::vector<const Method*> methods;
  std::string html;  ///< file, or empty
  py::dict others;
};

CompareKeywords compare_keywords(const py::dict& keywords) {
  CompareKeywords given;
  for_each_option(keywords, [&](const std::string& name, py::handle value) {
    if (name == "methods") {
      given.methods = parse_methods(text_of(name, value));
    } else if (name == "time-limit") {
      given.request.limit_seconds = parse_within(text_of(name, value), 0, kMostLimitSeconds, "seconds");
    } else if (name == "html") {
      given.html = parse_file_name(text_of(name, value));
    } else {
      given.others[name.c_str()] = value;
    }
  });
  return given;
}

std::string compare(const SceneArgument& scene, const py::dict& keywords, const py::dict& parameters,
                    const py::object& progress) {
  CompareKeywords given = compare_keywords(keywords);
  Options options;
  options.take(given.others);
  adapt(options, *scene);
  CompareRequest& request = given.request;
  request.picture = options.request();
  request.picture.compiled = nullptr;  // each method prepares the scene itself
  std::vector<std::pair<std::string, std::string>> of_methods;
  for_each_option(parameters,
                  [&](const std::string& name, py::handle value) { of_methods.emplace_back(name, text_of(name, value)); });
  request.methods = compared_methods(given.methods, of_methods);
  refuse_inputs(scene->inputs(), "html", given.html);
  std::string text;
  run(progress, options.threads, [&](const Progress& report) {
    request.progress = report;
    const MethodComparison comparison = compare_methods(scene->scene(), scene->topology(), request);
    std::vector<std::string> files;
    for (const ModelFile& file : scene->models.files) files.push_back(file.name);
    text = compare_json(comparison, files);
    if (!given.html.empty()) write_output(given.html, compare_page(comparison, files.front()));
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
  refuse_inputs(scene->inputs(), "file", file);
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
  for (const std::string& name : names) refuse_inputs(scene->inputs(), "file", name);
  run(progress, options.threads, [&](const Progress& report) {
    request.progress = report;
    RunReport run;
    OutputFiles files;
    std::size_t frame = 0;
    draw_frames(scene->scene(), request, {count, turn_degrees, as_pages}, run, scene->topology(),
                [&](Picture picture) { files.add(names[frame++], std::move(picture.bytes)); });
    files.commit();
  });
  return names;
}

}  // namespace

void add_model_work(py::module_& module) {
  module.def("info", &info, py::arg("scene"), py::arg("options"));
  module.def("compare", &compare, py::arg("scene"), py::arg("options"), py::arg("parameters"), py::arg("progress"));
  module.def("compile", &compile, py::arg("scene"), py::arg("file"), py::arg("method"), py::arg("parameters"),
             py::arg("threads"));
  module.def("draw_frames", &frames, py::arg("scene"), py::arg("file"), py::arg("frames"), py::arg("turn"),
             py::arg("options"), py::arg("progress"));
}

}  // namespace ligne::python
