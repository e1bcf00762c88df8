#pragma once
/// Reads the subdivision tags of OBJ files.

#include <string>
#include <string_view>

#include "scene/model/diagnostics.hpp"
#include "scene/subdivision/crease_tags.hpp"

namespace ligne {

/// Reads the words after a `t`, the tags of OpenSubdiv's examples: `crease I/F/S v0 v1 ... sharpness ...` and `corner
/// I/F/S v ... sharpness ...` with I vertices, numbered from 0, and F values of sharpness, one for all or one each. An
/// edge with a sharpness of 10 or more stays sharp. Other tags are counted as left out. Sets `cause` to a phrase if the
/// words are wrong; it stays empty otherwise.
void take_tag(std::string_view words, CreaseTags& tags, Warnings& warnings, std::string& cause);

}  // namespace ligne
