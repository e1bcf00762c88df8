/// Tests of healed meshes and creases that are written as text: the folder scripts.

#include "support/mesh_script.hpp"

[[maybe_unused]] static const bool scripts_are_added = ligne::test::add_mesh_scripts(LIGNE_SOURCE_DIR "/tests/heal/scripts");
