#include "report/traits_text.hpp"

#include <array>
#include <nlohmann/json.hpp>

#include "picture/parse/parse.hpp"

namespace ligne {
namespace {

std::string text_of(const BoundedCount& count) { return (count.complete ? "" : "at least ") + std::to_string(count.n); }

nlohmann::ordered_json json_of(const BoundedCount& count) {
  if (count.complete) return count.n;
  return {{"at_least", count.n}};
}

constexpr std::array<const char*, 3> kAxes{"x", "y", "z"};

std::string percent(double part) { return rounded(100 * part, 3) + " %"; }

/// The shares of pairs that the axes tell apart, and the privileged axis.
std::string text_of(const FaceSpread& spread) {
  std::string text = "pairs of faces apart ";
  for (std::size_t axis = 0; axis < 3; ++axis) {
    text += std::string(axis > 0 ? ", " : "") + "by " + kAxes[axis] + " " + percent(spread.apart[axis]);
  }
  return text + (spread.privileged ? "; privileged: " + std::string(kAxes[static_cast<std::size_t>(*spread.privileged)])
                                   : "; none is privileged");
}

std::string plural(std::size_t n, const char* one) { return std::to_string(n) + " " + one + (n == 1 ? "" : "s"); }

}  // namespace

std::vector<std::pair<std::string, std::string>> lines_of(const SceneTraits& traits) {
  return {
      {"faces", std::to_string(traits.faces) + " with area on the page, " + std::to_string(traits.front_faces) +
                    " facing the viewer, " + std::to_string(traits.transparent_faces) + " transparent"},
      {"visible", text_of(traits.visible_faces) + " faces in front somewhere, each of " + percent(traits.mean_visible_part) +
                      " of the picture on average"},
      {"area", percent(traits.covered_part) + " of the picture has a face"},
      {"corners", rounded(traits.mean_corners, 3) + " of a face on average, " + std::to_string(traits.most_corners) +
                      " at most; " + plural(traits.nonconvex_faces, "face") + " not convex"},
      {"directions", text_of(traits.spread)},
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
  json["visible_faces"] = json_of(traits.visible_faces);
  json["mean_visible_part"] = traits.mean_visible_part;
  json["covered_part"] = traits.covered_part;
  json["mean_corners"] = traits.mean_corners;
  json["most_corners"] = traits.most_corners;
  json["nonconvex_faces"] = traits.nonconvex_faces;
  json["pairs_apart"] = traits.spread.apart;
  const auto& privileged = traits.spread.privileged;
  json["privileged_direction"] =
      privileged ? nlohmann::ordered_json(kAxes[static_cast<std::size_t>(*privileged)]) : nlohmann::ordered_json(nullptr);
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
