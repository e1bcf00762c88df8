#pragma once
/// Short ways to strokes for tests. The lattice has a step of one millimetre, so that lattice points are page points.

#include "linework/map/line_map.hpp"
#include "linework/rules/rules.hpp"
#include "linework/stroke_geometry.hpp"
#include "support/test.hpp"

namespace ligne {

inline Stroke stroke(LatticePoint from, LatticePoint to, LineClass line_class = LineClass::mesh, std::uint32_t source = 0) {
  Stroke s;
  s.from = from;
  s.to = to;
  s.line_class = line_class;
  s.source = source;
  return s;
}

inline Stroke hidden(Stroke s) {
  s.visible = false;
  return s;
}

inline Stroke at_depth(Stroke s, float z_from, float z_to) {
  s.z_from = z_from;
  s.z_to = z_to;
  return s;
}

inline StrokeModel model(std::vector<Stroke> strokes) {
  StrokeModel m;
  m.strokes = std::move(strokes);
  return m;
}

/// Strokes in words, points in mm: "outline 0,0 300,0 320,5; hidden crease#7 0,9 9,9" are two outlines that follow each
/// other, and a hidden crease of source 7. Without these words a stroke is visible, of class `usual`, and of source 0.
/// Depths are "z=0:1000", and "plain" is a stroke that is not held against others that are.
inline StrokeModel sketch(const std::string& text, LineClass usual = LineClass::mesh, double step_mm = 1) {
  StrokeModel m;
  m.lattice.step_mm = step_mm;
  std::istringstream pieces(text);
  for (std::string piece; std::getline(pieces, piece, ';');) {
    Stroke s = stroke({}, {}, usual);
    std::size_t points = 0;
    std::istringstream words(piece);
    for (std::string word; words >> word;) {
      Point2 p;
      if (std::sscanf(word.c_str(), "%lf,%lf", &p.x, &p.y) == 2) {
        s.from = std::exchange(s.to, m.lattice.snap(p));
        if (points++ > 0) m.strokes.push_back(s);
        continue;
      }
      if (std::sscanf(word.c_str(), "z=%f:%f", &s.z_from, &s.z_to) == 2) continue;
      if (word == "plain") {
        s.needs_overlap_check = false;
        continue;
      }
      const std::size_t hash = std::min(word.find('#'), word.size());
      if (hash < word.size()) s.source = static_cast<std::uint32_t>(std::stoul(word.substr(hash + 1)));
      const std::string_view name = std::string_view(word).substr(0, hash);
      const auto known = std::find(kLineClassNames.begin(), kLineClassNames.end(), name);
      if (known != kLineClassNames.end()) s.line_class = static_cast<LineClass>(known - kLineClassNames.begin());
      if (name == "hidden") s.visible = false;
      if (known == kLineClassNames.end() && name != "hidden" && !name.empty()) throw std::invalid_argument(text);
    }
  }
  return m;
}

inline SourceEdge no_source(const Stroke&) { return {}; }

inline bool is_no_mesh(const Stroke& s) { return s.line_class != LineClass::mesh; }

/// Makes the map of the strokes, with contacts within `reach_mm`, applies the rule, and writes the map back, with hidden
/// strokes in the ink cleared.
template <class Rule>
std::size_t apply_rule(StrokeModel& m, double reach_mm, const Rule& rule, double ink_mm = 0) {
  const double step = m.lattice.step_mm;
  LineMap map(m, is_no_mesh, {.reach = reach_mm / step}, std::max(4.0, 4 * reach_mm / step));
  const std::size_t changes = rule(map);
  const std::vector<Stroke> added(map.added().begin(), map.added().end());
  map.commit();
  clear_hidden(m.strokes, added, ink_mm / step);
  return changes;
}

}  // namespace ligne
