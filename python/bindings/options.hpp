#pragma once
/// Options as keywords, with the names of the options of the command line.

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <pybind11/pybind11.h>

#include "picture/models/models.hpp"
#include "picture/pages/plotter.hpp"
#include "picture/requests.hpp"
#include "picture/surface/surface_request.hpp"

namespace ligne::python {

/// The keywords of a drawing, converted to a request.
struct Options {
  PictureRequest picture;
  PlotterChoice plotter;
  std::string preview;  ///< file, or empty
  unsigned threads = 0;
  bool edges_given = false;
  bool horizon_given = false;
  std::vector<std::pair<std::string, std::string>> parameters;  ///< parameters of methods: name, value

  /// Takes the keywords that are not None; underscores in names stand for dashes. Throws RequestError for an unknown
  /// name, with a suggestion from these options or from `others`.
  void take(const pybind11::dict& keywords, const std::vector<std::string_view>& others = {});
  /// Returns the request for a file of the format. Reads files of pens and devices. Throws RequestError.
  PictureRequest request() const;
};

/// Options for reading a model.
ModelRequest model_request(const pybind11::dict& keywords);

/// Returns the surfaces of the keywords: "formulas", "grids", "heights" (name, x, y, z) and "parametric" as lists, and
/// the options of surfaces, except those of Options.
SurfaceRequest surface_request(const pybind11::dict& keywords);

/// Names of the options of surface_request().
std::vector<std::string_view> names_of_surface_options();

/// Returns the keywords, with the format of the file's suffix if they have no format.
pybind11::dict with_format(const pybind11::dict& keywords, const std::string& file);

/// Calls set(name, value) for each keyword that is not None, with dashes for underscores in its name. A
/// std::invalid_argument of set() becomes a RequestError of that name.
void for_each_option(const pybind11::dict& keywords,
                     const std::function<void(const std::string& name, pybind11::handle value)>& set);

/// Threads of "threads" and bytes of "max_memory".
unsigned threads_of(pybind11::handle value);

}  // namespace ligne::python
