#pragma once
/// Scenes made of bytes, for the fuzzer of the visibility and the replay of its corpus.

#include "support/standard_views.hpp"

namespace ligne::test {

struct ByteScene {
  Scene scene;  ///< finished (scene/clean.hpp); no face: the bytes make none
  StandardView view;
};

/// Any bytes make a scene. Corners are whole numbers from 0 to 4, holes and so on at quarters between them, so that
/// touching, coplanar and aligned things abound; every fourth scene or so is turned, after which they touch but for the last
/// digits. A scene ends with the bytes or with about a dozen faces.
///   byte 0        view: one of the standard ones, along a small whole vector, or from a point of the grid
///   byte 1        whether the scene is turned
///   then          elements: kind, then its coordinates (byte_scene.cpp); bytes that are not there count as 0
ByteScene scene_of_bytes(std::span<const std::uint8_t> bytes);

/// Draws the scene with the default method, all edges and features only, and holds it against the oracle. Empty when it is
/// right; otherwise the faults, the scene as ligne-scene JSON and the command that draws it.
std::string faults_of(const ByteScene& scene);

}  // namespace ligne::test
