#pragma once
/// Scenes of the plates that no generator makes, as ligne-scene JSON. The pictures of [Boulle1980] are not available: the
/// scenes follow the text.

#include <string_view>

namespace ligne::studies {

/// Figure 2.2: a stepped block in front of a wedge.
inline constexpr std::string_view kSteppedBlock = R"({"format": "ligne-scene", "version": 1, "objects": [
{"name": "stepped block", "vertices": [[0,3,5], [3,3,5], [3,3,2], [6,3,2], [6,3,0], [0,3,0], [0,0,0], [6,0,0], [6,0,2],
[3,0,2], [3,0,5], [0,0,5]], "faces": [{"outer": [0,1,2,3,4,5]}, {"outer": [6,7,8,9,10,11]}, {"outer": [5,4,7,6]},
{"outer": [4,3,8,7]}, {"outer": [3,2,9,8]}, {"outer": [2,1,10,9]}, {"outer": [1,0,11,10]}, {"outer": [0,5,6,11]}]},
{"name": "wedge", "vertices": [[2,8,4], [2,8,0], [2,4,0], [9,4,0], [9,8,0], [9,8,4]], "faces": [{"outer": [0,1,2]},
{"outer": [3,4,5]}, {"outer": [2,1,4,3]}, {"outer": [1,0,5,4]}, {"outer": [0,2,3,5]}]}]})";

/// Figure 2.30: a house with a door, windows and a chimney.
inline constexpr std::string_view kHouse = R"({"format": "ligne-scene", "version": 1, "objects": [
{"name": "walls", "vertices": [[0,0,0], [12,0,0], [12,0,7], [6,0,11], [0,0,7], [2,0,5], [4,0,5], [4,0,0.5], [2,0,0.5],
[6,0,5], [9,0,5], [9,0,2], [6,0,2], [0,10,7], [6,10,11], [12,10,7], [12,10,0], [0,10,0], [12,2,5], [12,4,5], [12,4,2],
[12,2,2], [12,6,5], [12,8,5], [12,8,2], [12,6,2]], "faces": [{"outer": [0,1,2,3,4], "holes": [[5,6,7,8], [9,10,11,12]]},
{"outer": [13,14,15,16,17]}, {"outer": [1,16,15,2], "holes": [[18,19,20,21], [22,23,24,25]]}, {"outer": [4,13,17,0]}]},
{"name": "roof", "vertices": [[-1.5,-1,6], [6,-1,11], [6,11,11], [-1.5,11,6], [13.5,-1,6], [13.5,11,6]],
"faces": [{"outer": [0,1,2,3]}, {"outer": [1,4,5,2]}]}, {"name": "chimney", "vertices": [[8,8,8], [10,8,8], [10,6,8],
[8,6,8], [8,6,13], [10,6,13], [10,8,13], [8,8,13]], "faces": [{"outer": [0,1,2,3]}, {"outer": [4,5,6,7]},
{"outer": [3,2,5,4]}, {"outer": [2,1,6,5]}, {"outer": [1,0,7,6]}, {"outer": [0,3,4,7]}]}]})";

/// Figure 2.62: a face with its outer contour, two holes and details of other colours.
inline constexpr std::string_view kDetailedFace = R"({"format": "ligne-scene", "version": 1, "materials": [
{"name": "face", "color": [0.86, 0.86, 0.82]}, {"name": "red", "color": [0.85, 0.35, 0.3]},
{"name": "blue", "color": [0.35, 0.5, 0.75]}], "objects": [{"name": "face", "vertices": [[0,0,0], [14,0,0], [17,0,5],
[12,0,10], [6,0,7], [1,0,10], [2,0,2], [5,0,2], [5,0,5], [9,0,6], [13,0,7], [11,0,8]], "faces": [{"outer": [0,1,2,3,4,5],
"holes": [[6,7,8], [9,10,11]], "material": 0, "details": [{"material": 1, "contour": [[7,0,1], [13,0,1], [13,0,4],
[10,0,2.5], [7,0,4]]}, {"material": 2, "contour": [[1.5,0,6], [3.5,0,6.5], [2,0,8]]}]}]}]})";

/// Figure 2.71: a face F with details, and in front of it a glass pane and a plate that hides part of F and casts a shadow.
inline constexpr std::string_view kDetailsAndShadow = R"({"format": "ligne-scene", "version": 1, "materials": [
{"name": "face", "color": [0.9, 0.9, 0.86]}, {"name": "red", "color": [0.85, 0.35, 0.3]},
{"name": "glass", "color": [0.5, 0.7, 0.9], "opacity": 0.35}, {"name": "plate", "color": [0.75, 0.7, 0.5]}], "objects": [
{"name": "F", "vertices": [[0,8,0], [16,8,0], [16,8,10], [0,8,10]], "faces": [{"outer": [0,1,2,3], "material": 0,
"details": [{"material": 1, "contour": [[2,8,1], [9,8,1], [9,8,6], [5,8,3], [2,8,6]]}]}]},
{"name": "plate", "vertices": [[5,4,3], [10,4,3], [10,4,8], [5,4,8]], "faces": [{"outer": [0,1,2,3], "material": 3}]},
{"name": "pane", "vertices": [[9,0,1], [15,0,1], [15,0,7], [9,0,7]], "faces": [{"outer": [0,1,2,3], "material": 2}]}],
"lights": [{"kind": "parallel", "direction": [1, 2, -0.6]}]})";

/// Figure 2.72: two faces in a valid order.
inline constexpr std::string_view kTwoFaces = R"({"format": "ligne-scene", "version": 1, "objects": [
{"name": "F1", "vertices": [[0,4,0], [8,4,0], [8,4,6], [0,4,6]], "faces": [{"outer": [0,1,2,3]}]},
{"name": "F2", "vertices": [[4,0,2], [12,0,3], [7,0,9]], "faces": [{"outer": [0,1,2]}]}]})";

/// Figure 2.73: two faces that hide each other.
inline constexpr std::string_view kMutualFaces = R"({"format": "ligne-scene", "version": 1, "objects": [
{"name": "F1", "vertices": [[0,0,0], [10,0,0], [10,0,8], [8,0,8], [8,0,2], [2,0,2], [2,0,8], [0,0,8]],
"faces": [{"outer": [0,1,2,3,4,5,6,7]}]}, {"name": "F2", "vertices": [[-2,-3.5,4], [12,3.5,4], [12,3.5,6], [-2,-3.5,6]],
"faces": [{"outer": [0,1,2,3]}]}]})";

}  // namespace ligne::studies
