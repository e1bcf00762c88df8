#pragma once
/// A finished scene in our binary format.

#include "files/bytes.hpp"
#include "scene/model/scene.hpp"

namespace ligne {

void write_scene(ByteWriter& bytes, const Scene& scene);

/// Throws InputError for data that write_scene() never writes: indices out of range, coordinates that are not numbers.
Scene read_scene(ByteReader& bytes);

}  // namespace ligne
