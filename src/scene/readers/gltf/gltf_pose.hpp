#pragma once
/// Applies a moment of an animation of a glTF file.

#include <string>

#include "scene/readers/gltf/gltf_document.hpp"
#include "scene/readers/read_report.hpp"

namespace ligne {

/// Sets the translations, rotations, scales and weights of the nodes at that time. Before the first key of a channel
/// its first value applies, after the last key its last value. Throws InputError if the file has no such animation.
/// Source: Khronos glTF 2.0, section 3.11 and appendix C.
void apply_pose(GltfDocument& document, const ScenePose& pose);

}  // namespace ligne
