#pragma once
/// The plotter and the pens of a picture, found by their names.

#include <string>

#include "files/input_file.hpp"
#include "picture/requests.hpp"

namespace ligne {

/// Pens and plotter as they are named: devices by their names, files by their paths.
struct PlotterChoice {
  PlotterRequest request;           ///< all but `device`; the pens go before those of the file
  std::string device, device_file;  ///< empty: not given
  std::string pens_file;            ///< empty: none
};

/// The request with the device found and the files read, which are added to `files`. Without a name, HPGL and G-code have a
/// standard device. Throws RequestError for what does not go with the format or with each other, std::runtime_error for a
/// bad file.
PlotterRequest plotter_request(const PlotterChoice& choice, OutputFormat format, InputFiles& files);

}  // namespace ligne
