#include "picture/clear_creases.hpp"

#include <utility>

#include "scene/creases/find_creases.hpp"

namespace ligne {

EdgeSelection select_edges(const Scene& scene, const Topology& topology, const LineRequest& request, LineClasses classes,
                           std::vector<std::uint8_t>& creases, RunReport& run) {
  EdgeSelection selection{classes, request.crease_degrees};
  if (request.quality == Quality::exact || !classes.has(LineClass::crease)) return selection;
  Creases found = find_creases(scene, topology, request.crease_degrees);
  const auto count = [&](const char* name, std::size_t n) {
    if (n > 0) run.clear.count(name, n);
  };
  count("creases smooth by the file", found.smooth_by_file);
  count("creases sharp by the file", found.sharp_by_file);
  count("creases on no clean line", found.untraced);
  count("creases traced", found.traced);
  count("creases continued", found.continued);
  count("creases standing out", found.spurs);
  count("creases too short", found.short_chains);
  count("creases of straight sheets", found.straight_sheets);
  creases = std::move(found.is_crease);
  selection.creases = &creases;
  return selection;
}

}  // namespace ligne
