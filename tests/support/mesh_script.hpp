#pragma once
/// Tests of meshes that are written as text. The steps of a test make a mesh (mesh_text.hpp), or read one, or measure it:
///
///     read FORMAT <<         the text of a model, also with repetitions; and read FORMAT LINES, with \n for their ends
///     corpus NAME            a scene of the corpus
///     mesh                   begins anew
///     patches [without-loose]   surfaces that are recognised, and edges: sharp, tangent, inside, unknown; without tangent
///                            ones that are dropped as loose
///     surfaces               the list of surfaces
///     facets                 sets of faces in one plane
///     circles                the circles at which surfaces end
///     repetitions            of each object N the object original-N that it repeats
///     fillets WIDTH          lines along the middle of fillets that are no wider
///     creases [DEGREES [SURFACES]]   edges that are creases; loose: lines of creases from their free ends to a junction
///     healed [DISTANCE]      edges of border, and what was changed
///     refined DISTANCE       edges of the mesh that is made finer where it lies farther from its surfaces
///
/// A measure makes sets of things, with places and numbers, and single numbers. Checks, where OP is = != < > <= or >=, and
/// = may be followed by "+- TOLERANCE":
///
///     SET [where FORMULA] OP N         how many there are. The formula holds at all places of a thing, where they are x, y
///                                      and z, `above` the plane of the last line "below", and of its length, cosine of
///                                      the angle between its faces, size and area
///     SET.NUMBER [where FORMULA] OP N  holds for each of them, and there are any; also "sum SET.NUMBER", "most SET.NUMBER"
///     NAME OP N                        a single number
///     keep NAME WHAT                   a number that later ones name as $NAME
///
/// N is a formula of numbers. Surfaces are cylinders, cones, spheres, tori, extruded, revolved; all of them: surfaces.

#include <filesystem>

namespace ligne::test {

/// Makes tests of all scripts of the folder.
bool add_mesh_scripts(const std::filesystem::path& folder);

}  // namespace ligne::test
