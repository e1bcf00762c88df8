#include "cli/commands.hpp"

#include "cli/options/options.hpp"
#include "plotting/writers/output_file.hpp"
#include "report/listing.hpp"

namespace ligne {

void setup_devices(CLI::App& app, DevicesOptions& options) {
  CLI::App* command =
      add_command(app, "devices", "List the plotters: language, papers, limits, speed", "Example:\n  ligne devices --json");
  OptionGroup(*command, "Options").add_flag("--json", options.json, "write JSON");
}

void run_devices(const DevicesOptions& options) { write_output("-", options.json ? devices_json() : devices_text()); }

}  // namespace ligne
