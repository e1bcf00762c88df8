#include "cli/surface.hpp"

#include <utility>

#include "cli/messages.hpp"
#include "cli/progress.hpp"
#include "picture/surface_picture.hpp"

namespace ligne {
namespace {

void run(const SurfaceOptions& options, SurfaceRequest request) {
  RunFiles files;
  files.will_write("--output", *options.output.file);
  files.will_write("--preview", options.plotter.preview);
  files.will_write("--stats-json", options.run.stats_json);
  RunReport report;
  Picture picture;
  if (options.as_mesh) {
    picture.bytes = write_surface_mesh(request, mesh_format_of(options.output), report);
  } else {
    request.picture.plotter = plotter_request(options.plotter.choice, request.picture.output.format, report.files);
    request.picture.plotter.fit_drawing = !request.picture.page.scale;
    files.were_read(report.files);
    ProgressBar bar(options.run);
    request.picture.progress = bar.callback();
    picture = draw_surface(request, report);
  }
  deliver(std::move(picture), *options.output.file, options.as_mesh ? "" : options.plotter.preview,
          place_of_warnings(request), options.run, report, files);
}

}  // namespace

void setup_surface(CLI::App& app, SurfaceOptions& options) { add_surface_command(app, options); }

void run_surface(const SurfaceOptions& options) {
  const MemoryLimit memory = options.run.memory();
  run_within(memory, options.run.threads, [&] { run(options, checked_request(options, memory)); });
}

}  // namespace ligne
