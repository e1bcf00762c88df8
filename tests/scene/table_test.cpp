// Cells, styles and tables, before anybody asks what they mean.

#include "scene/tables/table.hpp"
#include "height_tools.hpp"
#include "scene/tables/column_names.hpp"

namespace ligne {
namespace {

double number(std::string_view cell, NumberStyle style = {}) {
  const CellValue value = cell_value(cell, style);
  EXPECT_EQ(value.kind, CellKind::number) << cell;
  return value.value;
}

CellKind kind(std::string_view cell, NumberStyle style = {}) { return cell_value(cell, style).kind; }

TEST(Cell, Numbers) {
  EXPECT_EQ(number(" 1.5 "), 1.5);
  EXPECT_EQ(number("\"1.5\""), 1.5);
  EXPECT_EQ(number("'+2'"), 2);
  EXPECT_EQ(number("1.4370D+01"), 14.37);
  EXPECT_EQ(number("2d-3"), 0.002);
  EXPECT_EQ(number("\u22123"), -3);
  for (const char* word : {"1,5", "12:30", "d3", "1.5m", "1 2", "0x10", "2/3", "1e999"})
    EXPECT_EQ(kind(word), CellKind::word) << word;
}

TEST(Cell, DecimalCommasAndThousands) {
  const NumberStyle comma{true, '\0'}, english{false, ','}, german{true, '.'}, french{true, ' '}, swiss{false, '\''};
  EXPECT_EQ(number("0,5", comma), 0.5);
  EXPECT_EQ(number("-1,25e3", comma), -1250);
  EXPECT_EQ(number("1,234,567.5", english), 1234567.5);
  EXPECT_EQ(number("12", english), 12);
  EXPECT_EQ(number("1.234,5", german), 1234.5);
  EXPECT_EQ(number("1 234,5", french), 1234.5);
  EXPECT_EQ(number("1\u00A0234", french), 1234);
  EXPECT_EQ(number("1'234.5", swiss), 1234.5);
  EXPECT_EQ(kind("1,2,3", comma), CellKind::word);
  EXPECT_EQ(kind("12,34", english), CellKind::word);
  EXPECT_EQ(kind("1.5", german), CellKind::word) << "neither 1.5 nor 15";
}

TEST(Cell, SignsOfNoValue) {
  for (const char* sign :
       {"",   "nan", "NaN",  "-nan", "NA", "N/A", "#N/A",      "#DIV/0!", "null",    "NULL", "None",   "nil",   "-",
        "--", "*",   "****", "?",    ".",  "inf", "-Infinity", "1.#QNAN", "-1.#IND", "<NA>", "\"NA\"", "nodata"}) {
    EXPECT_EQ(kind(sign), CellKind::missing) << sign;
  }
  for (const char* word : {"nano", "-1-", "none at all", "#1"}) EXPECT_EQ(kind(word), CellKind::word) << word;
}

TEST(Style, SeparatorsAndDecimalMarks) {
  struct Case {
    const char* text;
    char separator;
    bool decimal_comma;
    char thousands;
  };
  for (const Case& c : {Case{"0\t14,37\t2\n1\t2,5\t3\n", '\t', true, '\0'}, Case{"1,2\n3,4\n", ',', false, '\0'},
                        Case{"0,5;0,5;Bonn\n-1;1;Hof\n", ';', true, '\0'}, Case{"14,37 27,9\n1,5 2\n", ' ', true, '\0'},
                        Case{"a,\"1,234\",2.5\nb,\"12,345\",3\n", ',', false, ','},
                        Case{"1.234,5;2\n5.678,25;3\n", ';', true, '.'}, Case{"1 234;2\n5 678;1\n", ';', false, ' '},
                        Case{"1|2\n3|4\n", '|', false, '\0'}, Case{"1;2\n3;4\n", ';', false, '\0'},
                        Case{"1, 2\n3 ,4\n", ',', false, '\0'}, Case{"  1  2 \n\t3\t 4\n", ' ', false, '\0'}}) {
    SCOPED_TRACE(c.text);
    const CellStyle style = cell_style(c.text);
    EXPECT_EQ(style.separator, c.separator);
    EXPECT_EQ(style.numbers.decimal_comma, c.decimal_comma);
    EXPECT_EQ(style.numbers.thousands, c.thousands);
    EXPECT_FALSE(style.doubtful_comma);
  }
  EXPECT_TRUE(cell_style("1,234;2\n5,678;3\n").doubtful_comma);
  EXPECT_FALSE(cell_style("1,234;2.5\n5,678;3\n").doubtful_comma) << "the point is the decimal mark";
}

TEST(Style, CommentsAndQuotes) {
  EXPECT_EQ(without_comment("1,2 # two", ','), "1,2");
  EXPECT_EQ(without_comment("# all", ','), "");
  EXPECT_EQ(without_comment("1,2,Trail #5", ','), "1,2,Trail #5");
  EXPECT_EQ(without_comment("1,#N/A,3", ','), "1,#N/A,3");
  EXPECT_EQ(without_comment("1,\"a # b\"", ','), "1,\"a # b\"");
  EXPECT_EQ(cells_of("1,\"a, \"\"b\"\"\",3", ',').size(), 3u);
  EXPECT_EQ(cell_text("\"a, \"\"b\"\"\""), "a, \"b\"");
  EXPECT_EQ(cells_of("5' 7\",2", ',').size(), 2u) << "a quote within a cell is a character";
  EXPECT_EQ(cells_of("\"open,2", ',').size(), 2u) << "and so is one that is not closed";
}

Table table_of(const std::string& text, Warnings& warnings) { return read_table(text, "M", warnings); }

TEST(Table, HeadsNamesBlocksAndDataSets) {
  Warnings warnings;
  const std::string text = "Made by hand, in 2020\nx,\"y, north\",z\n1,2,3\n4,5,6\n\n7,8,9\n\n\nx,y,z\n1,2,3\n";
  const Table table = table_of(text, warnings);
  EXPECT_EQ(table.names(), (std::vector<std::string>{"x", "y, north", "z"}));
  EXPECT_EQ(table.rows(), 4u);
  EXPECT_EQ(table.blocks().size(), 3u);
  ASSERT_EQ(table.data_sets().size(), 2u);
  EXPECT_EQ(table.data_sets()[1].begin, 3u);
  EXPECT_EQ(table.line(2), 6u);
  EXPECT_EQ(warnings.left_out().text(), "left out: 1 lines above the first row, 1 head rows of data sets");
}

TEST(Table, NamesOfOneColumnLessThanTheRows) {
  Warnings warnings;
  const Table table = table_of("\"V1\" \"V2\"\n\"a\" 1 2\n\"b\" 3 4\n", warnings);
  EXPECT_TRUE(table.has_unnamed_first());
  EXPECT_EQ(table.names(), (std::vector<std::string>{"", "V1", "V2"}));
  EXPECT_TRUE(table.column(0).is_text());
}

TEST(Table, ACommentNamesTheColumns) {
  Warnings warnings;
  EXPECT_EQ(table_of("# made today\n# lon lat height\n1 2 3\n", warnings).names(),
            (std::vector<std::string>{"lon", "lat", "height"}));
  EXPECT_TRUE(table_of("# a comment of many words\n1 2 3\n", warnings).names().empty());
}

TEST(Names, RolesUnitsAndSeries) {
  const NamedColumns found = named_columns({"id", "Longitude (deg)", "LAT", "elevation_m", "Station"});
  EXPECT_EQ(found.x, 1u);
  EXPECT_EQ(found.y, 2u);
  EXPECT_EQ(found.z, 3u);
  EXPECT_EQ(found.label, 4u);
  EXPECT_EQ(positions_in_names({"Jan", "Feb", "mar"}), (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(positions_in_names({"X1990", "X1991"}), (std::vector<double>{1990, 1991}));
  EXPECT_FALSE(positions_in_names({"3", "1", "2"}));
  EXPECT_FALSE(positions_in_names({"a", "b"}));
  EXPECT_TRUE(are_numbered({"V1", "V2", "V10"}));
  EXPECT_FALSE(are_numbered({"V1", "W2"}));
  Warnings warnings;
  const Table table = table_of("a,b\n1,2\n", warnings);
  EXPECT_EQ(column_of(table, "B", "M"), 1u);
  EXPECT_EQ(column_of(table, "1", "M"), 0u);
  EXPECT_EQ(height_test::error_line([&] { column_of(table, "c", "M"); }), "M: has no column 'c': there are a, b");
}

TEST(TableFiles, OneTerrainInThirteenHabits) {
  // All files hold these 16 x 12 heights; two are missing in some.
  const auto plain = height_test::heights_of(*height_test::grid(height_test::corpus_file("csv_quoted.csv")));
  ASSERT_EQ(plain.size(), 12u);
  for (const char* file :
       {"fortran_d.txt", "gp_blocks4.dat", "gp_nonuniform.dat", "json_nested.json", "miss_null.csv", "r_unquoted_header.csv",
        "surfer_dsaa.grd", "tsv_comma.tsv", "xyz_xtz.csv", "z.npy", "csv_quoted.csv.gz"}) {
    SCOPED_TRACE(file);
    Warnings warnings;
    const auto found = height_test::heights_of(*height_test::grid(height_test::corpus_file(file), warnings));
    ASSERT_EQ(found.size(), plain.size());
    std::size_t holes = 0;
    for (std::size_t j = 0; j < plain.size(); ++j) {
      ASSERT_EQ(found[j].size(), plain[j].size());
      for (std::size_t i = 0; i < plain[j].size(); ++i) {
        holes += std::isnan(found[j][i]);
        const double height = std::isnan(found[j][i]) ? plain[j][i] : found[j][i];
        EXPECT_NEAR(height, plain[j][i], 1e-6);
      }
    }
    EXPECT_LE(holes, 12u);
  }
}

}  // namespace
}  // namespace ligne
