#pragma once
/// Options for the models of a command line.

#include "cli/run_files.hpp"
#include "picture/models/memory.hpp"
#include "picture/models/models.hpp"

namespace CLI {
class App;
}

namespace ligne {

void add_model_options(CLI::App& app, ModelRequest& request);

/// Adds the options that distinguish parts in the picture.
void add_part_drawing_options(CLI::App& app, OutputRequest& request);

/// The stage of reading the models.
Stage reading_of(const ModelRequest& request);

/// Reads all files and records them in `files`. Writes one line per kind of warning unless `quiet`; `with_areas` as in
/// Warnings::lines(). Throws InputError, UsageError.
LoadedModels load_models(const ModelRequest& request, bool quiet, RunFiles& files, bool with_areas = false);

}  // namespace ligne
