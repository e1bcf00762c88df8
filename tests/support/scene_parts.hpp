#pragma once
/// Small scenes for tests, made of faces and boxes.

#include "scene/model/scene_parts.hpp"

namespace ligne::test {

using ligne::add_box;
using ligne::add_face;
using ligne::Basis;
using ligne::begin_object;
using ligne::end_object;
using ligne::kUpright;
using ligne::rotation;

}  // namespace ligne::test
