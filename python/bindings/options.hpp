#pragma once
/// Options as keywords, with the names of the command line's.

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

/// The keywords of a drawing, in the words of a request.
struct Options {
  PictureRequest picture;
  PlotterChoice plotter;
  std::string preview;  ///< file, or empty
  unsigned threads = 0;
  bool edges_given = false;
  bool horizon_given = false;
  std::vector<std::pair<std::string, std::string>> parameters;  ///< of methods, by their names

  /// Takes the keywords that are not None; an underscore in a name stands for a dash. Throws RequestError, which suggests a
  /// name where one is not known: one of these options, or of `others`.
  void take(const pybind11::dict& keywords, const std::vector<std::string_view>& others = {});
  /// The request for a file of that format. Reads files of pens and devices. Throws RequestError.
  PictureRequest request() const;
};

/// Options that say what is read of a model.
ModelRequest model_request(const pybind11::dict& keywords);

/// The surfaces that the keywords tell: "formulas", "grids", "heights" (name, x, y, z) and "parametric" as lists, and the
/// options of surfaces, but for those of Options.
SurfaceRequest surface_request(const pybind11::dict& keywords);

/// Names of the options that surface_request() takes.
std::vector<std::string_view> names_of_surface_options();

/// The keywords with the format of the file's suffix, where they name none.
pybind11::dict with_format(const pybind11::dict& keywords, const std::string& file);

/// Calls set(name, value) for every keyword that is not None, its name with dashes for underscores. What that throws as
/// std::invalid_argument becomes a RequestError of that name.
void for_each_option(const pybind11::dict& keywords,
                     const std::function<void(const std::string& name, pybind11::handle value)>& set);

/// Threads of "threads" and bytes of "max_memory".
unsigned threads_of(pybind11::handle value);

}  // namespace ligne::python
