// Archives that are known and not read: the message says what they are and what to do.

#include "reader_tools.hpp"
#include "zip_builder.hpp"

namespace ligne::reader_test {
namespace {

std::string message(const std::string& bytes) {
  return error_line([&] { detect_format(bytes_of(bytes), "", "M"); });
}

TEST(Strangers, AreNamedWithWhatToDo) {
  const std::string blender = ", which is not read: open it in Blender and export glTF";
  EXPECT_EQ(message(zip_test::zip({{"scene.usdc", "PXR-USDC"}}, false)), "M: is a USD file" + blender);
  EXPECT_EQ(message(zip_test::zip({{"readme.txt", "hello"}})), "M: is a ZIP archive, not a model");
  EXPECT_TRUE(message(zip_test::zip({{"duck.dae", "<COLLADA>"}})).starts_with("M: is an archive with a COLLADA file, "));
  EXPECT_TRUE(message(zip_test::zip({{"a.3DRep", "<x/>"}})).starts_with("M: is a 3DXML file, which is not read: "));
}

}  // namespace
}  // namespace ligne::reader_test
