#pragma once
/// The models of a command line.

#include "cli/run_files.hpp"
#include "picture/models/memory.hpp"
#include "picture/models/models.hpp"

namespace CLI {
class App;
}

namespace ligne {

void add_model_options(CLI::App& app, ModelRequest& request);

/// How parts are told apart in the picture.
void add_part_drawing_options(CLI::App& app, OutputRequest& request);

/// Reading them, as a stage.
Stage reading_of(const ModelRequest& request);

/// Reads all files, and notes them in `files`. Unless `quiet`, writes a line for each kind of warning. Throws InputError,
/// UsageError.
LoadedModels load_models(const ModelRequest& request, bool quiet, RunFiles& files);

}  // namespace ligne
