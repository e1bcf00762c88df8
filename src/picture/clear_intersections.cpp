#include "picture/clear_intersections.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/geometric.hpp>
#include <utility>
#include <vector>

#include "geometry/disjoint_sets.hpp"
#include "scene/clean/near_cells.hpp"
#include "scene/contacts/chord_errors.hpp"
#include "scene/contacts/face_contact.hpp"

namespace ligne {
namespace {

/// Ends of segments that continue each other are rounded to the lattice one by one: so many steps apart at the most.
constexpr double kSameEndSteps = 4;
/// Adjustable: connected intersections of whose length less than this part lies in contacts stay whole.
constexpr double kTangentPart = 0.25;

double object_precision(const Scene& scene, std::uint32_t face) {
  const auto after = std::upper_bound(scene.objects.begin(), scene.objects.end(), face,
                                      [](std::uint32_t f, const Object& o) { return f < o.face_begin; });
  return after[-1].precision;
}

/// Segments that hang together by their ends.
DisjointSets connect(const std::vector<SourceEdge>& segments, double distance) {
  DisjointSets sets(segments.size());
  std::size_t slots = 1;
  while (slots < 4 * segments.size()) slots *= 2;
  std::vector<std::vector<std::uint32_t>> ends(slots);  // by the cell of the end: twice the segment, plus which end
  const auto place = [&](std::uint32_t end) { return segments[end / 2].ends[end % 2]; };
  for (std::uint32_t end = 0; end < 2 * segments.size(); ++end) {
    const NearCells cells(place(end), distance);
    if (!cells.finite()) continue;
    std::array<std::size_t, 8> looked_at{};
    for (unsigned k = 0; k < 8; ++k) {
      looked_at[k] = cells.slot(k, slots);
      if (std::find(looked_at.begin(), looked_at.begin() + k, looked_at[k]) != looked_at.begin() + k) continue;
      for (const std::uint32_t other : ends[looked_at[k]]) {
        if (glm::distance(place(end), place(other)) <= distance) sets.join(end / 2, other / 2);
      }
    }
    // One end stands for all that coincide with it.
    auto& own = ends[looked_at[0]];
    const bool stands = std::any_of(own.begin(), own.end(), [&](std::uint32_t other) { return place(other) == place(end); });
    if (!stands) own.push_back(end);
  }
  return sets;
}

std::vector<bool> find_contacts(const Scene& scene, const std::vector<SourceEdge>& segments, double smooth_degrees) {
  std::vector<std::uint32_t> faces;
  for (const SourceEdge& s : segments) {
    if (s.intersection) faces.insert(faces.end(), s.faces.begin(), s.faces.end());
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  const ChordErrors errors(scene, std::move(faces), smooth_degrees);
  std::vector<bool> contact(segments.size(), false);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const SourceEdge& s = segments[i];
    if (!s.intersection) continue;
    const double error = errors.of(s.faces[0]) + errors.of(s.faces[1]);
    if (error == 0) continue;
    const double precision = object_precision(scene, s.faces[0]) + object_precision(scene, s.faces[1]);
    contact[i] = within_distance(scene, s.faces, s.ends, error + precision);
  }
  return contact;
}

}  // namespace

void drop_contacts(StrokeModel& model, const Scene& scene, const ProjectedScene& projected, const LineRequest& request,
                   RunReport& run) {
  const std::vector<SourceEdge>& segments = model.intersections;
  if (request.quality == Quality::exact || segments.empty()) return;
  std::vector<bool> contact = find_contacts(scene, segments, request.crease_degrees);
  if (std::find(contact.begin(), contact.end(), true) == contact.end()) return;

  DisjointSets chains = connect(segments, kSameEndSteps * projected.lattice.step_mm / projected.view.scale);
  std::vector<std::array<double, 2>> lengths(segments.size(), {0, 0});  // by chain: all, and in contacts
  for (std::uint32_t i = 0; i < segments.size(); ++i) {
    const double length = glm::distance(segments[i].ends[0], segments[i].ends[1]);
    auto& [all, in_contact] = lengths[chains.find(i)];
    all += length;
    if (contact[i]) in_contact += length;
  }
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < segments.size(); ++i) {
    const auto [all, in_contact] = lengths[chains.find(i)];
    if (in_contact < kTangentPart * all) contact[i] = false;
    count += contact[i];
  }
  if (count == 0) return;
  std::erase_if(model.strokes,
                [&](const Stroke& s) { return s.source >= model.edge_count && contact[s.source - model.edge_count]; });
  run.clear.count("intersections of surfaces that touch", count);
}

}  // namespace ligne
