#pragma once
/// ligne devices: lists the known plotters.

namespace CLI {
class App;
}

namespace ligne {

struct DevicesOptions {
  bool json = false;
};

void setup_devices(CLI::App& app, DevicesOptions& options);
void run_devices(const DevicesOptions& options);

}  // namespace ligne
