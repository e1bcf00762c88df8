#include "scene/readers/obj/obj_tags.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "base/no_index.hpp"
#include "scene/model/polygon_faces.hpp"
#include "scene/readers/text_lines.hpp"
#include "scene/subdivision/subdivision_mesh.hpp"

namespace ligne {
namespace {

/// Sharpness from which an edge is sharp at every level, as in OpenSubdiv, which defines these tags.
constexpr double kSharpest = 10;

/// Reads "2/1/0": numbers of integers, of values and of texts.
std::optional<std::array<std::size_t, 3>> tag_counts(std::string_view word) {
  std::array<std::size_t, 3> counts{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t slash = k < 2 ? word.find('/') : word.size();
    if (slash == std::string_view::npos) return std::nullopt;
    const std::optional<std::int64_t> count = parse_integer(word.substr(0, slash));
    if (!count || *count < 0) return std::nullopt;
    counts[k] = static_cast<std::size_t>(*count);
    word.remove_prefix(std::min(slash + 1, word.size()));
  }
  return counts;
}

struct Tag {
  std::vector<std::uint32_t> vertices;
  std::vector<float> sharpness;
};

std::optional<Tag> tag_values(std::string_view words) {
  const auto counts = tag_counts(take_word(words));
  if (!counts) return std::nullopt;
  Tag tag;
  while (tag.vertices.size() < (*counts)[0]) {
    const std::optional<std::int64_t> vertex = parse_integer(take_word(words));
    if (!vertex || *vertex < 0 || *vertex >= kNone) return std::nullopt;
    tag.vertices.push_back(static_cast<std::uint32_t>(*vertex));
  }
  while (tag.sharpness.size() < (*counts)[1]) {
    const std::optional<double> value = number_in(take_word(words));
    if (!value) return std::nullopt;
    tag.sharpness.push_back(*value >= kSharpest ? kAlwaysSharp : static_cast<float>(std::max(*value, 0.0)));
  }
  return tag;
}

}  // namespace

void take_tag(std::string_view words, CreaseTags& tags, Warnings& warnings, std::string& cause) {
  const std::string_view kind = take_word(words);
  const bool is_crease = kind == "crease";
  if (!is_crease && kind != "corner") return warnings.leave_out("tags " + shown(kind));
  const std::optional<Tag> tag = tag_values(words);
  const std::size_t named = !tag ? 0 : is_crease ? tag->vertices.size() - !tag->vertices.empty() : tag->vertices.size();
  if (named == 0 || (tag->sharpness.size() != 1 && tag->sharpness.size() != named)) {
    cause =
        "tag that is not of the form t " + std::string(kind) + (is_crease ? " 2/1/0 V V SHARPNESS" : " 1/1/0 V SHARPNESS");
    return;
  }
  for (std::size_t i = 0; i < named; ++i) {
    const float sharpness = tag->sharpness[tag->sharpness.size() == 1 ? 0 : i];
    if (!(sharpness > 0)) continue;
    const std::uint32_t v = tag->vertices[i];
    if (!is_crease) {
      tags.corners.push_back({v, sharpness});
      continue;
    }
    const auto [low, high] = std::minmax(v, tag->vertices[i + 1]);
    tags.edges.push_back({low, high, sharpness});
  }
}

}  // namespace ligne
