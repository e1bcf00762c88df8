#pragma once
/// The options of ligne surface.

#include <optional>
#include <string>

#include "cli/options/output_options.hpp"
#include "cli/options/run_options.hpp"
#include "picture/surface/surface_mesh_picture.hpp"
#include "picture/surface/surface_request.hpp"

namespace CLI {
class App;
}

namespace ligne {

struct SurfaceOptions {
  SurfaceRequest request;
  bool horizon_given = false;  ///< true if the method horizon is requested
  bool as_mesh = false;
  bool pixels = false;
  std::optional<unsigned> resolution;
  std::string axes_style;  ///< text of the option; empty: no axes, "true": the flag alone
  OutputOptions output;
  PlotterOptions plotter;
  RunOptions run;
};

/// Adds the command with its options.
CLI::App* add_surface_command(CLI::App& app, SurfaceOptions& options);

/// The request that the options make. Throws UsageError and RequestError for options that exclude each other.
SurfaceRequest checked_request(const SurfaceOptions& options, const MemoryLimit& memory);

/// Mesh format of --as-mesh, from the file suffix. Throws UsageError.
MeshFormat mesh_format_of(const OutputOptions& options);

}  // namespace ligne
