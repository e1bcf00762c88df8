/// Tables, numbers and names in text files, and thinned grids.

#include "height_tools.hpp"
#include "main/script.hpp"
#include "scene/model/precision.hpp"
#include "scene/readers/text_lines.hpp"
#include "scene/surfaces/height_filters.hpp"
#include "scene/surfaces/surface_mesh.hpp"
#include "scene/tables/column_names.hpp"
#include "scene/tables/table.hpp"

namespace ligne {
namespace {

using test::as_text;

// Tables of files, and thinned ones; cells, styles and names of columns: values/tables.txt.

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

// Grids of more samples than a page has places for.

using namespace height_test;

/// Heights that tell their place: the number of the row before the comma, that of the column behind it.
class CountedHeights : public HeightSource {
 public:
  CountedHeights(std::size_t columns, std::size_t rows) : HeightSource(counted(columns), counted(rows)) {}
  void read_row(std::size_t j, std::span<double> z) const override {
    for (std::size_t i = 0; i < z.size(); ++i) z[i] = static_cast<double>(j) + static_cast<double>(i) / 65536;
  }

 private:
  static std::vector<double> counted(std::size_t n) {
    std::vector<double> positions(n);
    for (std::size_t i = 0; i < n; ++i) positions[i] = 0.5 * static_cast<double>(i);
    return positions;
  }
};

GridChoice thinning(std::optional<unsigned> every = {}) { return {{}, every, true}; }

TEST(ThinnedHeights, AreThoseOfTheGrid) {
  Warnings warnings;
  auto whole = std::make_unique<CountedHeights>(9001, 3000);
  whole->set_unit(GroundUnit::degrees);
  const auto thinned = thinned_heights(std::move(whole), thinning(), warnings);
  EXPECT_EQ(thinned->thinned_by(), 2u);
  EXPECT_EQ(thinned->unit(), GroundUnit::degrees);
  ASSERT_EQ(thinned->x().size(), 4501u);
  ASSERT_EQ(thinned->y().size(), 1501u);
  EXPECT_EQ(thinned->y().back(), 0.5 * 2999);
  std::vector<double> row(4501);
  thinned->read_row(1500, row);
  EXPECT_EQ(row[4500], 2999 + 9000.0 / 65536);
  thinned->read_row(7, row);
  EXPECT_EQ(row[3], 14 + 6.0 / 65536);
  ASSERT_EQ(warnings.counts().size(), 1u);
  EXPECT_EQ(warnings.counts().begin()->first,
            "grid of 9001 x 3000 samples thinned: 1 of 2 rows and columns is drawn; -x and -y choose a part");
}

TEST(ThinnedHeights, SmallGridsStayWhatTheyAre) {
  EXPECT_EQ(thinning_step(10'000, 10'000, {}), 1u) << "nobody allows it";
  Warnings warnings;
  auto whole = std::make_unique<CountedHeights>(90, 30);
  const HeightSource* const before = whole.get();
  EXPECT_EQ(thinned_heights(std::move(whole), thinning(), warnings).get(), before);
  EXPECT_TRUE(warnings.counts().empty());
}

TEST(ThinnedHeights, PicturesAreThinnedWhileTheyAreRead) {
  constexpr std::size_t kColumns = 6000, kRows = 5000;
  std::string text = "P5 6000 5000 255\n";
  for (std::size_t row = 0; row < kRows; ++row)
    for (std::size_t column = 0; column < kColumns; ++column) text += static_cast<char>((row * 7 + column * 3) % 251);
  Warnings warnings;
  const auto heights = read_grid(reader_test::bytes_of(text), "M", warnings, {}, nullptr, thinning());
  EXPECT_EQ(heights->thinned_by(), 2u);
  EXPECT_EQ(heights->x().size(), 3001u);
  EXPECT_EQ(heights->y().size(), 2501u);
  EXPECT_EQ(warnings.counts().size(), 1u);
  std::vector<double> row(3001);
  for (const std::size_t j : {std::size_t{0}, std::size_t{1}, std::size_t{1300}, std::size_t{2500}}) {
    heights->read_row(j, row);
    const auto y = static_cast<std::size_t>(heights->y()[j]);
    EXPECT_EQ(y, j == 2500 ? kRows - 1 : 2 * j);
    for (const std::size_t i : {std::size_t{0}, std::size_t{17}, std::size_t{3000}}) {
      const auto x = static_cast<std::size_t>(heights->x()[i]);
      EXPECT_EQ(row[i], static_cast<double>(((kRows - 1 - y) * 7 + x * 3) % 251));
    }
  }
}

// Functions of texts that the readers of models, tables and formulas are made of: the folder values.

std::function<std::string(const std::string&)> cell(const NumberStyle& style) {
  return [style](const std::string& text) -> std::string {
    const CellValue value = cell_value(text, style);
    return value.kind == CellKind::number ? as_text(value.value) : value.kind == CellKind::word ? "word" : "missing";
  };
}

/// The separator, and behind it the signs within numbers: "; 1.000,5".
std::string style_of(const std::string& text) {
  const CellStyle style = cell_style(text);
  const std::string thousands = style.numbers.thousands ? std::string(1, style.numbers.thousands) : "";
  return std::string(1, style.separator) + " 1" + thousands + "000" + (style.numbers.decimal_comma ? ",5" : ".5") +
         (style.doubtful_comma ? " doubtful" : "");
}

/// "COLUMNS ROWS [EVERY]": every so manieth curve is asked for.
std::string thinned_step(const std::string& text) {
  const std::vector<std::string> words = test::words_of(text);
  const GridChoice choice{{}, words.size() > 2 ? std::optional<unsigned>(std::stoul(words[2])) : std::nullopt, true};
  return std::to_string(thinning_step(std::stoul(words.at(0)), std::stoul(words.at(1)), choice));
}

std::string kept(const std::string& text) {
  std::string places;
  for (const std::size_t place : kept_places(std::stoul(text), std::stoul(text.substr(text.find(' ')))))
    places += (places.empty() ? "" : " ") + std::to_string(place);
  return places;
}

std::string parametric(const std::string& text) {
  const std::vector<std::string> parts = test::parts_of(text, ';');
  parametric_points({parts.at(0), parts.at(1), parts.at(2)}, {0, 1}, {0, 1});
  return "read";
}

/// Describes a table: names, lines of rows, blocks, rows at which data sets begin, and what is left out.
std::string table(const std::string& text) {
  Warnings warnings;
  const Table table = read_table(text, "M", warnings);
  std::string all = "names ";
  for (const std::string& name : table.names()) all += "[" + name + "]";
  all += "; lines";
  for (std::size_t row = 0; row < table.rows(); ++row) all += " " + std::to_string(table.line(row));
  all += "; blocks " + std::to_string(table.blocks().size()) + "; sets";
  for (const auto& set : table.data_sets()) all += " " + std::to_string(set.begin);
  if (table.has_unnamed_first()) all += "; first unnamed";
  if (table.column(0).is_text()) all += "; first of text";
  return all + (warnings.left_out().text().empty() ? "" : "; " + warnings.left_out().text());
}

/// "NAME; TABLE": the number of the column of a name.
std::string column(const std::string& text) {
  Warnings warnings;
  const std::size_t end = text.find("; ");
  return std::to_string(column_of(read_table(text.substr(end + 2), "M", warnings), text.substr(0, end), "M"));
}

std::string roles(const std::string& text) {
  const NamedColumns found = named_columns(test::parts_of(text, '|'));
  const auto number = [](const std::optional<std::size_t>& n) { return n ? std::to_string(*n) : "none"; };
  return "x " + number(found.x) + " y " + number(found.y) + " z " + number(found.z) + " label " + number(found.label);
}

std::string positions(const std::string& text) {
  const auto found = positions_in_names(test::words_of(text));
  if (!found) return "none";
  std::string all;
  for (const double position : *found) all += (all.empty() ? "" : " ") + as_text(position);
  return all;
}

std::string precision(const std::string& text) {
  DecimalPrecision precision;
  for (const std::string& word : test::words_of(text)) precision.add(word.c_str(), *number_in(word));
  return as_text(precision.value());
}

const test::TextFunctions kFunctions{
    {"cell", cell({})},
    {"cell-comma", cell({true, '\0'})},
    {"cell-english", cell({false, ','})},
    {"cell-german", cell({true, '.'})},
    {"cell-french", cell({true, ' '})},
    {"cell-swiss", cell({false, '\''})},
    {"style", style_of},
    {"table", table},
    {"column", column},
    {"roles", roles},
    {"positions", positions},
    {"numbered", [](auto& t) { return are_numbered(test::words_of(t)) ? "yes" : "no"; }},
    {"precision", precision},
    {"half-ulp-32", [](auto& t) { return as_text(half_ulp_float32(test::value_of(t))); }},
    {"half-ulp-64", [](auto& t) { return as_text(half_ulp_double(test::value_of(t))); }},
    {"without-comment", [](auto& t) { return std::string(without_comment(t, ',')); }},
    {"cells", [](auto& t) { return std::to_string(cells_of(t, ',').size()); }},
    {"cell-text", [](auto& t) { return std::string(cell_text(t)); }},
    {"thinning", thinned_step},
    {"kept", kept},
    {"parametric", parametric},
    {"constant", [](auto& t) { return as_text(constant_of(t)); }},
    {"number", [](auto& t) { return as_text(number_in(t).value()); }},
    {"integer", [](auto& t) { return std::to_string(parse_integer(t).value()); }},
};

[[maybe_unused]] const bool values_are_added =
    test::add_function_scripts(LIGNE_SOURCE_DIR "/tests/scene/values", kFunctions);

}  // namespace
}  // namespace ligne
