#include "picture/clear/clear_creases.hpp"

#include "contours/shape_lines.hpp"

namespace ligne {

bool asks_for_creases(LineClasses classes) { return classes.has(LineClass::crease) || has_shape_lines(classes); }

EdgeSelection select_edges(const Scene& scene, const Topology& topology, const LineRequest& request, LineClasses classes,
                           Creases& creases, RunReport& run) {
  EdgeSelection selection{classes, request.crease_degrees};
  if (request.quality == Quality::exact || !asks_for_creases(classes)) return selection;
  creases = find_creases(scene, topology, request.crease_degrees);
  const auto count = [&](const char* name, std::size_t n) {
    if (n > 0) run.clear.count(name, n);
  };
  count("creases smooth by the file", creases.smooth_by_file);
  count("creases sharp by the file", creases.sharp_by_file);
  count("creases on no clean line", creases.untraced);
  count("creases traced", creases.traced);
  count("creases continued", creases.continued);
  count("creases standing out", creases.spurs);
  count("creases too short", creases.short_chains);
  count("creases of straight sheets", creases.straight_sheets);
  selection.creases = &creases.is_crease;
  return selection;
}

}  // namespace ligne
