#pragma once
/// A finished scene in the binary form of files of ours.

#include "files/bytes.hpp"
#include "scene/model/scene.hpp"

namespace ligne {

void write_scene(ByteWriter& bytes, const Scene& scene);

/// Throws InputError for what write_scene() does not write: indices that lead nowhere, coordinates that are no numbers.
Scene read_scene(ByteReader& bytes);

}  // namespace ligne
