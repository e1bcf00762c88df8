#pragma once
/// Reads a file as the fuzzers and the replay of their corpus do.

#include "support/standard.hpp"

namespace ligne {

/// Ends the program where an invariant does not hold.
inline void need(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "broken invariant: %s\n", what);
  std::abort();
}

/// Reads the bytes as a model of the kind "gltf", "glb", "obj", "stl" (text and binary), "ply", "asc" or "scene", cleans it
/// and merges its faces; or as a grid of heights, "grid", or as points, "points", or as a formula, "formula", and reads rows
/// of them; or as a drawing, "svg" or "drawing" (JSON), and orders its strokes; or makes areas of them, "areas". An
/// InputError of one line is a right answer; anything else that is thrown goes on to the caller, and a scene that breaks its
/// invariants aborts.
void read_as_fuzzer(std::string_view kind, std::span<const std::byte> bytes);

/// Areas that hide and clip each other, made of bytes. The first byte chooses between rectangles that abut, polygons with
/// common corners, and any contours at all. Of the first two the plotted borders must be those of a sampled picture; the
/// last ones must be lines at all.
void hide_areas_as_fuzzer(std::span<const std::byte> bytes);

}  // namespace ligne
