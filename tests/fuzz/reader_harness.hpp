#pragma once
/// Reads a file as the fuzzers and the replay of their corpus do.

#include "support/standard.hpp"

namespace ligne {

/// Reads the bytes as a model of the kind "gltf", "glb", "obj", "stl" (text and binary), "ply", "asc" or "scene", cleans it
/// and merges its faces; or as a grid of heights, "grid", or as points, "points", or as a formula, "formula", and reads rows
/// of them; or as a drawing, "svg" or "drawing" (JSON), and orders its strokes; or makes areas of them, "areas". An
/// InputError of one line is a right answer; anything else that is thrown goes on to the caller, and a scene that breaks its
/// invariants aborts.
void read_as_fuzzer(std::string_view kind, std::span<const std::byte> bytes);

}  // namespace ligne
