#include "report/traits_text.hpp"

#include <nlohmann/json.hpp>

#include "picture/parse/parse.hpp"

namespace ligne {
namespace {

std::string text_of(const BoundedCount& count) { return (count.complete ? "" : "at least ") + std::to_string(count.n); }

nlohmann::ordered_json json_of(const BoundedCount& count) {
  if (count.complete) return count.n;
  return {{"at_least", count.n}};
}

std::string plural(std::size_t n, const char* one) { return std::to_string(n) + " " + one + (n == 1 ? "" : "s"); }

}  // namespace

std::vector<std::pair<std::string, std::string>> lines_of(const SceneTraits& traits) {
  return {
      {"faces", std::to_string(traits.faces) + " with area on the page, " + std::to_string(traits.front_faces) +
                    " facing the viewer, " + std::to_string(traits.transparent_faces) + " transparent"},
      {"objects", std::to_string(traits.convex_objects) + " convex"},
      {"zones", std::to_string(traits.zones) + ", the largest of " + plural(traits.largest_zone, "face")},
      {"overlap", rounded(traits.mean_overlap, 3) + " faces over a point of the page on average, " +
                      std::to_string(traits.most_overlap) + " at most"},
      {"conflicts", text_of(traits.conflicts) + " pairs of faces overlap on the page"},
      {"penetrations", text_of(traits.penetrations) + " pairs of faces pass through each other"},
      {"turns", std::to_string(traits.turning_vertices) + " vertices where a contour turns back (nbsom')"},
      {"height field", traits.height_field ? "yes" : "no"},
  };
}

nlohmann::ordered_json json_of(const SceneTraits& traits) {
  nlohmann::ordered_json json;
  json["faces"] = traits.faces;
  json["front_faces"] = traits.front_faces;
  json["transparent_faces"] = traits.transparent_faces;
  json["convex_objects"] = traits.convex_objects;
  json["zones"] = traits.zones;
  json["largest_zone"] = traits.largest_zone;
  json["mean_overlap"] = traits.mean_overlap;
  json["most_overlap"] = traits.most_overlap;
  json["conflicts"] = json_of(traits.conflicts);
  json["penetrations"] = json_of(traits.penetrations);
  json["turning_vertices"] = traits.turning_vertices;
  json["height_field"] = traits.height_field;
  return json;
}

}  // namespace ligne
