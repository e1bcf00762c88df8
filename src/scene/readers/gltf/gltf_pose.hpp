#pragma once
/// A moment of an animation of a glTF file.

#include <string>

#include "scene/readers/gltf/gltf_document.hpp"
#include "scene/readers/read_report.hpp"

namespace ligne {

/// Gives the nodes the translations, rotations, scales and weights that they have then. Before the first key of a channel
/// its first value holds, after the last key its last. Throws InputError when the file has no such animation.
/// Source: Khronos glTF 2.0, section 3.11 and appendix C.
void apply_pose(GltfDocument& document, const ScenePose& pose);

}  // namespace ligne
