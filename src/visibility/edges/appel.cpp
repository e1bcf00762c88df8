#include "visibility/edges/appel.hpp"

#include "visibility/edges/counted_visibility.hpp"
#include "visibility/edges/edge_visibility.hpp"

namespace ligne {
namespace {

enum class Carried : std::uint8_t { off, test, count, nature, path };
constexpr std::string_view kCarriedNames[] = {"off", "test", "count", "nature", "path"};
constexpr MethodParameter kParameters[] = {
    experiment(
        {"propagate", "off|test|count|nature|path",
         "count the faces in front of each edge part. test: one test per edge; count, nature: propagate their number or "
         "their set from vertex to vertex; path: propagate along a path of edges",
         "off", kCarriedNames}),
};

}  // namespace

const MethodTraits& AppelMethod::traits() const {
  static const MethodTraits traits{
      "appel",
      "each edge tested against the faces that can hide it, by exact intervals; the default for line drawings",
      kStrokes,
      true,
      true,
      "A. Appel, The notion of quantitative invisibility, 1967; R. Galimberti, U. Montanari, An algorithm for hidden line "
      "elimination, 1969",
      MethodTraits{}.tolerance_mm,
      kParameters};
  return traits;
}

VisibilityResult AppelMethod::compute_visibility(const ProjectedScene& scene, const VisibilityOptions& options) const {
  switch (options.settings.choice("propagate", Carried::off)) {
    case Carried::off:
      break;
    case Carried::test:
      return counted_visibility(scene, options, {});
    case Carried::count:
      return counted_visibility(scene, options, Propagation::count);
    case Carried::nature:
      return counted_visibility(scene, options, Propagation::nature);
    case Carried::path:
      return counted_visibility(scene, options, Propagation::path);
  }
  return edge_visibility(scene, options);
}

}  // namespace ligne
