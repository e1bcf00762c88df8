// Files that are known and not read: the message says what they are and what to do.

#include "reader_tools.hpp"
#include "zip_builder.hpp"

namespace ligne::reader_test {
namespace {

std::string message(const std::string& bytes) {
  try {
    detect_format(bytes_of(bytes), "", "M");
  } catch (const InputError& error) {
    return error.what();
  }
  return "known";
}

TEST(Strangers, AreNamedWithWhatToDo) {
  const std::string assimp = ", which is not read: convert it, for example with: assimp export IN OUT.glb";
  const std::string freecad = ", which is not read: open it in FreeCAD and export STL, OBJ or glTF";
  const std::string blender = ", which is not read: open it in Blender and export glTF";
  EXPECT_EQ(message("<?xml version=\"1.0\"?>\n<COLLADA xmlns=\"x\">"), "M: is a COLLADA file" + assimp);
  EXPECT_EQ(message("\xEF\xBB\xBF<?xml version=\"1.0\"?>\n<!-- made by -->\n<X3D>"), "M: is an X3D file" + assimp);
  EXPECT_TRUE(message("<?xml version=\"1.0\"?><amf unit=\"mm\">").starts_with("M: is an AMF file, which is not read: "));
  EXPECT_EQ(message("<?xml version=\"1.0\"?><other/>"), "M: is an XML file, not a model");
  EXPECT_EQ(message("ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('AUTOMOTIVE_DESIGN'));"), "M: is a STEP file" + freecad);
  EXPECT_TRUE(
      message("ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('IFC4'));").starts_with("M: is an IFC file, which is not read: "));
  EXPECT_EQ(message(std::string(72, ' ') + "S      1\n"), "M: is an IGES file" + freecad);
  EXPECT_EQ(message("Kaydara FBX Binary  \0"), "M: is an FBX file" + assimp);
  EXPECT_EQ(message("; FBX 7.4.0 project file\n"), "M: is an FBX file" + assimp);
  EXPECT_EQ(message("PXR-USDC\1"), "M: is a USD file" + blender);
  EXPECT_EQ(message("#usda 1.0\n"), "M: is a USD file" + blender);
  EXPECT_EQ(message(zip_test::zip({{"scene.usdc", "PXR-USDC"}}, false)), "M: is a USD file" + blender);
  EXPECT_EQ(message(zip_test::zip({{"readme.txt", "hello"}})), "M: is a ZIP archive, not a model");
  EXPECT_TRUE(message(zip_test::zip({{"duck.dae", "<COLLADA>"}})).starts_with("M: is an archive with a COLLADA file, "));
  EXPECT_TRUE(message(zip_test::zip({{"a.3DRep", "<x/>"}})).starts_with("M: is a 3DXML file, which is not read: "));
  EXPECT_EQ(message("0.5 1 2 255 0 0\n"),
            "M: is a table of numbers, not a model; to draw it as heights: ligne surface --grid");
  EXPECT_EQ(message("MeshVersionFormatted 1\n"),
            "M: is a Medit mesh, which is not read: convert it with: gmsh IN -0 -o OUT.stl");
  EXPECT_EQ(message("BLENDER-v300"), "M: is a Blender file" + blender);
  EXPECT_EQ(message("  0\nSECTION\n  2\nHEADER\n"), "M: is a DXF file" + freecad);
  EXPECT_EQ(message("AC1027\0"), "M: is a DWG file" + freecad);
  EXPECT_TRUE(message("#VRML V2.0 utf8\n").starts_with("M: is a VRML file, which is not read: "));
  EXPECT_TRUE(
      message(std::string("\xFF\xFE\xFF\x0ES\0k\0e\0t\0c\0h\0U\0p\0", 20) + "x").starts_with("M: is a SketchUp file, "));
  EXPECT_EQ(message("\x89PNG\r\n"), "M: is a PNG image, not a model");
}

}  // namespace
}  // namespace ligne::reader_test
