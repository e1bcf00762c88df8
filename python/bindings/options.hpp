#pragma once
/// Options as keywords, with the names of the command line's.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/pybind11.h>

#include "picture/models.hpp"
#include "picture/plotter.hpp"
#include "picture/requests.hpp"
#include "picture/surface_request.hpp"

namespace ligne::python {

/// What the keywords of a drawing say, in the words of a request.
struct Options {
  PictureRequest picture;
  PlotterChoice plotter;
  std::string preview;  ///< file, or empty
  unsigned threads = 0;
  bool edges_given = false;
  bool horizon_given = false;
  std::vector<std::pair<std::string, std::string>> parameters;  ///< of methods, by their names

  /// Takes the keywords that are not None; an underscore in a name stands for a dash. Throws RequestError.
  void take(const pybind11::dict& keywords);
  /// The request for a file of that format. Reads files of pens and devices. Throws RequestError.
  PictureRequest request() const;
};

/// Options that say what is read of a model.
ModelRequest model_request(const pybind11::dict& keywords);

/// Options of surfaces, but for those of Options.
void take_surface_options(SurfaceRequest& surface, const pybind11::dict& keywords);

/// Threads of "threads" and bytes of "max_memory".
unsigned threads_of(pybind11::handle value);

}  // namespace ligne::python
