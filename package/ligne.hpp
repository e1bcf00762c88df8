#pragma once
/// Ligne Claire as a library: a model or a surface goes in with a request, and a picture, or its strokes, come out.
///
///   ligne::LoadedModels models = ligne::load_models({.files = {"gearbox.obj"}});
///   ligne::PictureRequest request;  // isometric, A4, outlines and creases
///   ligne::RunReport report;
///   ligne::write_output("gearbox.svg", ligne::draw_scene(models.scene, request, report).bytes);
///
/// What these headers name is the library's interface; docs/architecture.md tells how it hangs together, and
/// examples/library_use has programs. All lengths are in mm, all angles in degrees, unless a name says otherwise.

#include "base/parallel.hpp"
#include "files/input_error.hpp"
#include "picture/draw_scene.hpp"
#include "picture/drawn_scene.hpp"
#include "picture/errors.hpp"
#include "picture/models/memory.hpp"
#include "picture/models/models.hpp"
#include "picture/pages/plotter.hpp"
#include "picture/pages/write_picture.hpp"
#include "picture/parse/parse.hpp"
#include "picture/prepared_scene.hpp"
#include "picture/raster/zbuffer_picture.hpp"
#include "picture/requests.hpp"
#include "picture/run_report.hpp"
#include "picture/scene_visibility.hpp"
#include "picture/surface/surface_picture.hpp"
#include "plotting/writers/output_file.hpp"
#include "scene/readers/reader.hpp"
#include "visibility/registry.hpp"
