#pragma once
/// Tags of OBJ files that speak of subdivision.

#include <string>
#include <string_view>

#include "scene/model/diagnostics.hpp"
#include "scene/subdivision/crease_tags.hpp"

namespace ligne {

/// Takes the words behind a `t`, the tags of OpenSubdiv's examples: `crease I/F/S v0 v1 ... sharpness ...` and
/// `corner I/F/S v ... sharpness ...` with I vertices, numbered from 0, and F values of sharpness, one for all or one each.
/// A sharpness of 10 or more is that of an edge that stays sharp. Other tags are counted as left out. `cause` says what is
/// wrong, or stays empty.
void take_tag(std::string_view words, CreaseTags& tags, Warnings& warnings, std::string& cause);

}  // namespace ligne
