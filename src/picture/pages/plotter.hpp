#pragma once
/// Finds the plotter and the pens of a picture by their names.

#include <string>

#include "files/input_file.hpp"
#include "picture/requests.hpp"

namespace ligne {

/// Pens and plotter by name: devices by their names, files by their paths.
struct PlotterChoice {
  PlotterRequest request;           ///< everything except `device`; its pens take precedence over those of the file
  std::string device, device_file;  ///< empty: not given
  std::string pens_file;            ///< empty: none
};

/// Returns the request with the device and the files read, which are added to `files`. HPGL and G-code have a default
/// device. Throws RequestError for options that contradict the format or each other, std::runtime_error for a bad file.
PlotterRequest plotter_request(const PlotterChoice& choice, OutputFormat format, InputFiles& files);

}  // namespace ligne
