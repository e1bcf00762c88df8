#include "scene/heal/face_key.hpp"

#include <algorithm>
#include <span>

#include "base/no_index.hpp"

namespace ligne {
namespace {

/// Start of the least rotation of a cyclic word (Shiloach 1981: two candidates are compared; the one that loses at its
/// letter k can not begin before k + 1).
std::size_t least_rotation(std::span<const std::uint32_t> word) {
  const std::size_t n = word.size();
  std::size_t i = 0, j = 1, k = 0;
  while (i < n && j < n && k < n) {
    const std::uint32_t a = word[(i + k) % n], b = word[(j + k) % n];
    if (a == b) {
      ++k;
      continue;
    }
    (a > b ? i : j) += k + 1;
    if (i == j) ++j;
    k = 0;
  }
  return std::min(i, j);
}

/// Replaces a cyclic contour by its least word, read in either direction.
void make_canonical(std::vector<std::uint32_t>& contour) {
  if (contour.size() == 3) {  // rotations and reversal give all orders of three
    std::sort(contour.begin(), contour.end());
    return;
  }
  const auto rotate = [](std::vector<std::uint32_t>& word) {
    std::rotate(word.begin(), word.begin() + static_cast<std::ptrdiff_t>(least_rotation(word)), word.end());
  };
  std::vector<std::uint32_t> reverse(contour.rbegin(), contour.rend());
  rotate(contour);
  rotate(reverse);
  if (reverse < contour) contour = std::move(reverse);
}

}  // namespace

void face_key(const Scene& scene, std::uint32_t face, FunctionRef<std::uint32_t(std::uint32_t)> name,
              std::vector<std::uint32_t>& key) {
  const auto take_contour = [&](std::size_t c, std::vector<std::uint32_t>& contour) {
    for (const std::uint32_t v : scene.faces.contour(face, c)) contour.push_back(name(v));
    make_canonical(contour);
  };
  key.clear();
  take_contour(0, key);
  std::vector<std::vector<std::uint32_t>> holes(scene.faces.contour_count(face) - 1);
  for (std::size_t c = 1; c <= holes.size(); ++c) take_contour(c, holes[c - 1]);
  std::sort(holes.begin(), holes.end());
  for (const auto& hole : holes) {
    key.push_back(kNone);  // a separator that is not a vertex
    key.insert(key.end(), hole.begin(), hole.end());
  }
}

}  // namespace ligne
