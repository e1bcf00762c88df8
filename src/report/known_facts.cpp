#include "report/known_facts.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "picture/parse/parse.hpp"
#include "scene/clean/check_facts.hpp"
#include "scene/model/bounds.hpp"

namespace ligne {
namespace {

std::string_view name_of(StatedFact fact) { return kStatedFactNames[static_cast<std::size_t>(fact)]; }

KnownFact no_penetration(const Scene& scene, const Topology& topology, const SceneTraits& traits) {
  KnownFact known;
  known.fact = StatedFact::no_penetration;
  known.why_not = why_false(scene, topology, known.fact);
  if (known.why_not.empty() && traits.penetrations.n > 0) {
    known.why_not = std::to_string(traits.penetrations.n) + " pairs of faces pass through each other";
  }
  known.certain = !known.why_not.empty() || tests_all_pairs(topology);
  return known;
}

/// Planes across the axes of the model that have no object on both sides. O(n log n).
std::vector<SeparatingPlane> planes_between(const Scene& scene) {
  std::vector<Bounds> boxes;
  for (const Object& object : scene.objects) {
    if (object.vertex_begin < object.vertex_end) boxes.push_back(bounds_of(scene, object.vertex_begin, object.vertex_end));
  }
  std::vector<SeparatingPlane> planes;
  for (int axis = 0; axis < 3; ++axis) {
    std::sort(boxes.begin(), boxes.end(), [&](const Bounds& a, const Bounds& b) { return a.low[axis] < b.low[axis]; });
    for (std::size_t i = 0; i + 1 < boxes.size() && planes.size() < kMostSeparatingPlanes; ++i) {
      // From here on, the upper bound of this box is that of all boxes so far.
      if (boxes[i + 1].low[axis] >= boxes[i].high[axis]) {
        SeparatingPlane plane{{0, 0, 0}, {0, 0, 0}};
        plane.point[axis] = boxes[i].high[axis] + (boxes[i + 1].low[axis] - boxes[i].high[axis]) / 2;
        plane.normal[axis] = 1;
        planes.push_back(plane);
      }
      boxes[i + 1].high[axis] = std::max(boxes[i + 1].high[axis], boxes[i].high[axis]);
    }
  }
  return planes;
}

std::string text_of(const SeparatingPlane& plane) {
  for (int axis = 0; axis < 3; ++axis) {
    if (plane.normal[axis] == 1) return std::string(1, "xyz"[axis]) + " = " + rounded(plane.point[axis]);
  }
  return "through " + rounded(plane.point.x) + ", " + rounded(plane.point.y) + ", " + rounded(plane.point.z);
}

}  // namespace

std::string KnownFacts::assumable() const {
  std::string names;
  for (const KnownFact& f : facts) {
    if (f.why_not.empty() && f.certain) names += (names.empty() ? "" : ",") + std::string(name_of(f.fact));
  }
  return names;
}

KnownFacts known_facts(const Scene& scene, const Topology& topology, const SceneTraits& traits) {
  KnownFacts known;
  known.facts.push_back(no_penetration(scene, topology, traits));
  for (const StatedFact fact : {StatedFact::convex, StatedFact::adjacency}) {
    known.facts.push_back({fact, false, why_false(scene, topology, fact), true});
  }
  for (KnownFact& f : known.facts) f.stated = scene.stated.has(f.fact);
  known.planes_stated = !scene.stated.planes.empty();
  known.planes = known.planes_stated ? scene.stated.planes : planes_between(scene);
  return known;
}

std::vector<std::pair<std::string, std::string>> lines_of(const KnownFacts& known) {
  std::vector<std::pair<std::string, std::string>> lines;
  for (const KnownFact& f : known.facts) {
    const std::string value = !f.why_not.empty() ? "no: " + f.why_not
                              : f.certain        ? "yes"
                                                 : "none found, not all pairs tested";
    lines.emplace_back(name_of(f.fact), value + (f.stated ? " (stated)" : ""));
  }
  constexpr std::size_t kMostListed = 6;
  std::string planes = std::to_string(known.planes.size()) + (known.planes_stated ? " stated" : " between objects");
  for (std::size_t i = 0; i < std::min(kMostListed, known.planes.size()); ++i) {
    planes += (i == 0 ? ": " : ", ") + text_of(known.planes[i]);
  }
  lines.emplace_back("planes", planes + (known.planes.size() > kMostListed ? " and more" : ""));
  if (const std::string names = known.assumable(); !names.empty()) lines.emplace_back("to state", "--assume " + names);
  return lines;
}

nlohmann::ordered_json json_of(const KnownFacts& known) {
  nlohmann::ordered_json json;
  for (const KnownFact& f : known.facts) {
    nlohmann::ordered_json& entry = json[std::string(name_of(f.fact))];
    entry["holds"] = !f.why_not.empty() ? nlohmann::ordered_json(false)
                     : f.certain        ? nlohmann::ordered_json(true)
                                        : nlohmann::ordered_json(nullptr);
    entry["stated"] = f.stated;
    if (!f.why_not.empty()) entry["why_not"] = f.why_not;
  }
  json["assume"] = known.assumable();
  json["separating_planes"] = nlohmann::ordered_json::array();
  for (const SeparatingPlane& plane : known.planes) {
    const auto list = [](const Point3& p) { return nlohmann::ordered_json::array({p.x, p.y, p.z}); };
    json["separating_planes"].push_back({{"point", list(plane.point)}, {"normal", list(plane.normal)}});
  }
  return json;
}

}  // namespace ligne
