// The cursor over JSON text, and the order of painting that is read with it.

#include "plotting/readers/json_cursor.hpp"
#include "files/input_error.hpp"
#include "plotting/readers/order_reader.hpp"
#include "support/test.hpp"

namespace ligne::test {
namespace {

TEST(JsonCursor, PassesOverWhateverIsInside) {
  JsonCursor cursor(R"( {"a": [1, {"}]": "\"]}"}], "b" :-2.5e1 , "c":true,"d":{}} )");
  std::vector<std::string> names, values;
  double b = 0;
  cursor.for_each_member([&](std::string_view name) {
    names.emplace_back(name);
    if (name == "b") {
      b = cursor.number();
    } else {
      values.emplace_back(cursor.value());
    }
  });
  EXPECT_TRUE(cursor.at_end());
  EXPECT_EQ(names, (std::vector<std::string>{"a", "b", "c", "d"}));
  EXPECT_EQ(values, (std::vector<std::string>{R"([1, {"}]": "\"]}"}])", "true", "{}"}));
  EXPECT_EQ(b, -25);
}

TEST(JsonCursor, RefusesWhatIsNone) {
  for (const char* text : {"", "{", "{\"a\"}", "{\"a\":}", "{\"a\":[}", "{\"a\":1", "{\"a", "[1]", "{\"a\":\"b}"}) {
    JsonCursor cursor(text);
    EXPECT_THROW(cursor.for_each_member([&](std::string_view) { cursor.value(); }), JsonSyntaxError) << text;
  }
  for (const char* text : {"", "nan", "inf", "-inf", "+1", ".5", "1e999", "x"}) {
    EXPECT_THROW(JsonCursor(text).number(), JsonSyntaxError) << text;
  }
}

TEST(OrderReader, CutsOutWhatIsLong) {
  const std::string text = R"({"page":{"order":1}, "order": [ {"a":1} ] ,"regions":[2],"strokes":[]})";
  const SplitDrawing split = split_drawing(text, "a.json");
  EXPECT_EQ(split.rest, R"({"page":{"order":1}, "order": [],"regions":[],"strokes":[]})");
  EXPECT_EQ(split.order, R"([ {"a":1} ] )");
}

TEST(OrderReader, ReadsPieces) {
  ReadOrder order;
  read_pieces(
      R"([{"face":3,"outer":[[0,0],[8,0],[8,8.5]],"holes":[[[2,2],[2,4],[4,4]]],"plane":[0,0,1],"material":1,"light":2}])",
      "a.json", order);
  ASSERT_EQ(order.pieces.size(), 1u);
  EXPECT_EQ(order.pieces[0].face, 3u);
  EXPECT_EQ(order.pieces[0].material, 1u);
  EXPECT_EQ(order.pieces[0].light, 1);
  ASSERT_EQ(order.order.pieces[0].contours.size(), 2u);
  EXPECT_EQ(order.order.pieces[0].contours[0][2], Point2(8, 8.5));
  EXPECT_FALSE(order.tells_hidden);
  read_pieces(R"([{"hidden":true ,"face":"none","outer":0}])", "a.json", order);
  EXPECT_EQ(order.pieces.size(), 1u) << "nothing of a hidden piece is looked at";
  EXPECT_TRUE(order.tells_hidden);
  for (const char* text : {"[{}]", "[1]", R"([{"face":1,"material":0,"outer":[[1,2],[3,4]]}])",
                           R"([{"face":-1,"material":0,"outer":[[1,2],[3,4],[5,6]]}])",
                           R"([{"face":1,"material":0.5,"outer":[[1,2],[3,4],[5,6]]}])",
                           R"([{"face":1,"material":0,"outer":[[1,2],[3,4],[5,1e9]]}])",
                           R"([{"face":1,"material":0,"outer":[[1,2],[3,4],[5]]}])"}) {
    ReadOrder other;
    EXPECT_THROW(read_pieces(text, "a.json", other), InputError) << text;
  }
}

}  // namespace
}  // namespace ligne::test
