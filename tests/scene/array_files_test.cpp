// Binary files of arrays, JSON, grids of Surfer and archives, made here byte by byte.

#include "array_builder.hpp"
#include "deflated.hpp"
#include "height_tools.hpp"
#include "scene/surfaces/grids/point_table.hpp"
#include "zip_builder.hpp"

namespace ligne {
namespace {

using namespace array_test;
using test::deflated;
using namespace height_test;
using namespace std::string_literals;

const std::vector<std::vector<double>> kHeights{{1, 2, 3}, {4, 5, 6}};

GridSurface read(const std::string& text, Warnings& warnings, const GridChoice& choice = {}) {
  auto surfaces = read_surfaces(reader_test::bytes_of(text), "M", warnings, {}, nullptr, choice);
  EXPECT_EQ(surfaces.size(), 1u);
  return std::move(surfaces[0]);
}
std::unique_ptr<HeightSource> heights(const std::string& text, const GridChoice& choice = {}) {
  Warnings warnings;
  return read(text, warnings, choice).heights;
}
std::string error_of(const std::string& text, const GridChoice& choice = {}) {
  return error_line([&] { heights(text, choice); });
}

TEST(Npy, TypesOrdersAndVersions) {
  const auto expect = [](const std::string& text) { expect_grid(*heights(text), {0, 1, 2}, {0, 1}, kHeights); };
  expect(npy("<f8", "2, 3", numbers<double>({1, 2, 3, 4, 5, 6})));
  expect(npy(">f4", "2, 3", numbers<float>({1, 2, 3, 4, 5, 6}, std::endian::big), 2));
  expect(npy("<i2", "2, 3,", numbers<std::int16_t>({1, 2, 3, 4, 5, 6}), 3));
  expect(npy("|u1", "2, 3", numbers<std::uint8_t>({1, 2, 3, 4, 5, 6})));
  expect(npy("<f2", "2, 3", numbers<std::uint16_t>({0x3c00, 0x4000, 0x4200, 0x4400, 0x4500, 0x4600})));
  expect(npy("<i8", "2, 3", numbers<std::int64_t>({1, 4, 2, 5, 3, 6}), 1, "True"));
  expect(npy("<i4", "1, 2, 3", numbers<std::int32_t>({1, 2, 3, 4, 5, 6})));
}

TEST(Npy, LayersPointsAndErrors) {
  const std::string layers = npy("|u1", "2, 2, 3", numbers<std::uint8_t>({0, 0, 0, 0, 0, 9, 1, 2, 3, 4, 5, 6}));
  Warnings warnings;
  read(layers, warnings);
  EXPECT_EQ(warnings.left_out().text(), "left out: 1 layer of its array");
  GridChoice second;
  second.data_set = 1;
  expect_grid(*heights(layers, second), {0, 1, 2}, {0, 1}, kHeights);
  second.data_set = 2;
  EXPECT_NE(error_of(layers, second).find("has 2 layers"), std::string::npos);
  const auto points = numbers<double>({0, 0, 1, 1, 0, 2, 0, 1, 3, 1, 1, 4});
  expect_grid(*heights(npy("<f8", "4, 3", points)), {0, 1}, {0, 1}, {{1, 2}, {3, 4}});
  EXPECT_EQ(error_of(npy("<f8", "2, 3", numbers<double>({1, 2}))),
            "M: is truncated: its header declares more than the 16 remaining bytes");
  EXPECT_EQ(error_of(npy("<c16", "2, 3", "")),
            "M: holds numpy's type 'c16'; heights are integers or floats of up to 64 bits");
  EXPECT_EQ(error_of(npy("<f8", "9223372036854775807, 9223372036854775807", "")),
            "M: is truncated: its header declares more than the 0 remaining bytes");
  EXPECT_EQ(error_of("\x93NUMPY"), "M: is truncated: the numpy header ends early");
}

TEST(Npy, PositionsInTheFirstColumn) {
  std::string values;
  for (int row = 0; row < 9; ++row) values += numbers<double>({400. - row, row * row * 0.25, row % 2 + 0., 1});
  const auto source = heights(npy("<f8", "9, 4", values));
  EXPECT_EQ(source->x().size(), 3u);
  EXPECT_EQ(source->y().front(), 392);
  GridChoice matrix;
  matrix.layout = TableLayout::matrix;
  EXPECT_EQ(heights(npy("<f8", "9, 4", values), matrix)->x().size(), 4u);
}

/// A classic file with the coordinates lon and lat (descending), and z of two bytes with a scale and a fill value; over
/// (lat, lon), or over (lon, lat).
std::string netcdf(char version, const std::vector<float>& lon = {5, 6, 7}, bool lon_first = false) {
  const auto name = [](const std::string& text) {
    return big(static_cast<std::uint32_t>(text.size())) + text + std::string((4 - text.size() % 4) % 4, '\0');
  };
  const auto text_attribute = [&](const std::string& key, const std::string& value) {
    return name(key) + big(2) + name(value);
  };
  const std::string dims = big(10) + big(2) + name("lat") + big(2) + name("lon") + big(3);
  const auto offset = [&](std::uint32_t at) { return version == 1 ? big(at) : big(0) + big(at); };
  const auto build = [&](std::uint32_t begin) {
    std::string vars = big(11) + big(3);
    vars += name("lat") + big(1) + big(0) + big(12) + big(1) + text_attribute("units", "degrees_north") + big(6) + big(16) +
            offset(begin);
    vars += name("lon") + big(1) + big(1) + big(12) + big(1) + text_attribute("units", "degrees_east") + big(5) + big(12) +
            offset(begin + 16);
    vars += name("z") + big(2) + big(lon_first ? 1 : 0) + big(lon_first ? 0 : 1) + big(12) + big(2) + name("scale_factor") +
            big(6) + big(1) + raw(0.5, std::endian::big) + name("_FillValue") + big(3) + big(1) +
            raw(std::int16_t{-1}, std::endian::big) + "\0\0"s + big(3) + big(12) + offset(begin + 28);
    return "CDF"s + version + big(0) + dims + big(0) + big(0) + vars;
  };
  const std::string head = build(static_cast<std::uint32_t>(build(0).size()));
  return head + numbers<double>({50, 40}, std::endian::big) + numbers<float>({lon[0], lon[1], lon[2]}, std::endian::big) +
         (lon_first ? numbers<std::int16_t>({8, 2, 10, 4, -1, 6}, std::endian::big)
                    : numbers<std::int16_t>({8, 10, -1, 2, 4, 6}, std::endian::big));
}

TEST(Netcdf, CoordinatesScalesAndFillValues) {
  for (const char version : {'\1', '\2'}) {
    const auto source = heights(netcdf(version));
    expect_grid(*source, {5, 6, 7}, {40, 50}, {{1, 2, 3}, {4, 5, kNaN}});
    EXPECT_EQ(source->unit(), GroundUnit::degrees);
  }
  const std::string whole = netcdf('\1');
  EXPECT_EQ(error_of(whole.substr(0, whole.size() - 4)), "M: is truncated: variable 'z' extends past the end of the file");
  for (std::size_t size = 4; size < whole.size(); size += 7) error_of(whole.substr(0, size));
  GridChoice choice;
  choice.using_columns = {"height"};
  EXPECT_EQ(error_of(whole, choice), "M: has no array 'height': there are lat, lon, z");
}

TEST(Netcdf, AxesInAnyOrderAreNotMirrored) {
  const std::vector<std::vector<double>> z{{1, 2, 3}, {4, 5, kNaN}};
  expect_grid(*heights(netcdf('\1', {5, 6, 7}, true)), {5, 6, 7}, {40, 50}, z);
}

TEST(Netcdf, LongitudesGoOnPastTheLastDegree) {
  const std::vector<std::vector<double>> z{{1, 2, 3}, {4, 5, kNaN}};
  expect_grid(*heights(netcdf('\1', {359, 359.5, 0.25})), {359, 359.5, 360.25}, {40, 50}, z);
  expect_grid(*heights(netcdf('\1', {179, -180, -179})), {179, 180, 181}, {40, 50}, z);
  EXPECT_EQ(error_of(netcdf('\1', {5, 7, 6})), "M: positions x do not ascend: number 3 is not above the one before it");
}

TEST(Matlab, MatricesPlainAndCompressed) {
  const std::string z = mat_matrix("dem", 2, 3, numbers<double>({1, 4, 2, 5, 3, 6}));
  const std::string x = mat_matrix("X", 2, 3, numbers<double>({5, 5, 6, 6, 7, 7}));
  const std::string y = mat_matrix("Y", 2, 3, numbers<double>({9, 8, 9, 8, 9, 8}));
  expect_grid(*heights(mat_head() + z), {0, 1, 2}, {0, 1}, kHeights);
  expect_grid(*heights(mat_head() + x + y + z), {5, 6, 7}, {8, 9}, {{4, 5, 6}, {1, 2, 3}});
  const std::string packed = deflated(z, 15);
  expect_grid(*heights(mat_head() + raw(std::uint32_t{15}) + raw(static_cast<std::uint32_t>(packed.size())) + packed),
              {0, 1, 2}, {0, 1}, kHeights);
  EXPECT_EQ(error_of(mat_head() + mat_matrix("s", 1, 1, "", 2)),
            "M: is a MATLAB file without an array of numbers; left out: 1 struct (s): save them as plain matrices: "
            "save('OUT.mat', 'z', 'x', 'y', '-v7')");
  EXPECT_EQ(error_of(mat_head() + z.substr(0, 40)), "M: MATLAB file: is truncated");
}

TEST(JsonGrid, DeepOnesAreRefused) { EXPECT_NE(error_of(std::string(100'000, '[')).find("M: JSON"), std::string::npos); }

TEST(Surfer, ThreeForms) {
  const std::string text = "DSAA\n3 2\n5 7\n8 9\n1 6\n1 2 3\n4 5 1.70141e+38\n";
  const std::vector<std::vector<double>> z{{1, 2, 3}, {4, 5, kNaN}};
  expect_grid(*heights(text), {5, 6, 7}, {8, 9}, z);
  const std::string dsbb = "DSBB" + numbers<std::int16_t>({3, 2}) + numbers<double>({5, 7, 8, 9, 1, 6}) +
                           numbers<float>({1, 2, 3, 4, 5, 1.70141e38});
  expect_grid(*heights(dsbb), {5, 6, 7}, {8, 9}, z);
  const std::string dsrb = "DSRB" + numbers<std::uint32_t>({4, 1}) + "GRID" + numbers<std::uint32_t>({72, 2, 3}) +
                           numbers<double>({5, 8, 1, 1, 1, 6, 0, 1.70141e38}) + "DATA" + numbers<std::uint32_t>({48}) +
                           numbers<double>({1, 2, 3, 4, 5, 1.70141e38});
  expect_grid(*heights(dsrb), {5, 6, 7}, {8, 9}, z);
  EXPECT_EQ(error_of("DSAA\n3 2\n5 7\n8 9\n1 6\n1 2 3\n"), "M: ends after 3 of 6 heights");
  EXPECT_EQ(error_of("DSAA\n30000 20000\n5 7\n"), "M:2: '20000' is not a number of cells, or more than the file can hold");
  EXPECT_EQ(error_of(dsbb.substr(0, 70)), "M: is truncated: 3 x 2 heights do not fit into 14 bytes");
}

TEST(Archives, GzipOfAnyGridAndOthersByName) {
  expect_grid(*heights(deflated("1,2,3\n4,5,6\n", 31)), {0, 1, 2}, {0, 1}, kHeights);
  const std::string packed = deflated("1,2,3\n4,5,6\n", 31);
  EXPECT_EQ(error_of(packed.substr(0, packed.size() - 9)), "M: is a truncated archive");
  EXPECT_EQ(error_of(deflated(packed, 31)), "M: is an archive within an archive: unpack it");
  for (const auto& [bytes, what] : std::map<std::string, std::string>{{"\x89HDF\r\n\x1a\n", "HDF5"},
                                                                      {"PAR1", "Parquet"},
                                                                      {"\xD0\xCF\x11\xE0", "Microsoft Office"},
                                                                      {"RDX3\n", "file of R"},
                                                                      {std::string("\xFD"
                                                                                   "7zXZ\0",
                                                                                   6),
                                                                       "xz -d"},
                                                                      {"BZh91AY", "bzip2 -d"},
                                                                      {"GRIB", "GRIB"}}) {
    EXPECT_NE(error_of(bytes + std::string(100, '\0')).find(what), std::string::npos) << what;
  }
}

// Points and lines in files of arrays and archives.

using height_test::error_line;
using height_test::kNaN;
class PointFiles : public testing::Test {
 protected:
  void write(const std::string& bytes) {
    std::ofstream(file_, std::ios::binary) << bytes;
    warnings_ = {};
  }
  std::vector<LabelledPoint> points(const std::string& bytes) {
    write(bytes);
    InputFiles opened;
    return read_points(file_, opened, warnings_);
  }
  std::vector<std::vector<Point3>> lines(const std::string& bytes) {
    write(bytes);
    InputFiles opened;
    return read_lines(file_, opened, warnings_);
  }
  /// The message behind the name of the file.
  std::string error(const std::string& bytes) {
    const std::string message = error_line([&] { points(bytes); });
    EXPECT_TRUE(message.starts_with(file_ + ": ")) << message;
    return message.substr(std::min(message.size(), file_.size() + 2));
  }
  void expect_two(const std::vector<LabelledPoint>& found, double z, const std::string& label) {
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].at.x, 1);
    EXPECT_EQ(found[0].at.y, 3);
    EXPECT_EQ(found[1].at.x, 2);
    EXPECT_EQ(found[1].at.y, 4);
    EXPECT_TRUE(std::isnan(z) ? std::isnan(found[0].at.z) : found[0].at.z == z);
    EXPECT_EQ(found[0].label, label);
  }

  test::TemporaryFolder folder_;
  std::string file_ = (folder_ / "points").string();
  Warnings warnings_;
};

TEST_F(PointFiles, Archives) {
  const std::string text = "name,x,y\nHof,1,3\nUlm,2,4\n";
  expect_two(points(deflated(text, 31)), kNaN, "Hof");
  expect_two(points(zip_test::zip({{"places.csv", text}})), kNaN, "Hof");
  EXPECT_EQ(error(zip_test::zip({{"a.csv", text}, {"b.csv", text}})),
            "is a ZIP archive of 2 files: unpack it, and take one of them");
  EXPECT_EQ(error(deflated(deflated(text, 31), 31)), "is an archive within an archive: unpack it");
}

TEST_F(PointFiles, Npy) {
  expect_two(points(npy("<f8", "2, 2", numbers<double>({1, 3, 2, 4}))), kNaN, "");
  expect_two(points(npy("<f8", "2, 3", numbers<double>({1, 3, 9, 2, 4, 8}))), 9, "");
  EXPECT_EQ(warnings_.lines(), std::vector<std::string>{"3 columns of the array read as x, y and z"});
  EXPECT_EQ(error(npy("<f8", "2, 4", numbers<double>({1, 3, 9, 2, 4, 8, 0, 0}))),
            "holds no points: arrays x and y, or rows of x, y and perhaps z; there are array of 2 x 4");
}

TEST_F(PointFiles, Matlab) {
  const std::string x = mat_matrix("lon", 2, 1, numbers<double>({1, 2})),
                    y = mat_matrix("lat", 1, 2, numbers<double>({3, 4}));
  expect_two(points(mat_head() + x + y + mat_matrix("z", 2, 1, numbers<double>({9, 8}))), 9, "");
  expect_two(points(mat_head() + x + y + mat_matrix("dem", 2, 2, numbers<double>({9, 8, 7, 6}))), kNaN, "");
  EXPECT_EQ(warnings_.left_out().text(), "left out: 1 array (dem)");
  EXPECT_EQ(error(mat_head() + x + mat_matrix("lat", 1, 3, numbers<double>({3, 4, 5}))),
            "arrays lon and lat have different lengths: they are not positions of points");
}

TEST_F(PointFiles, LinesOfArchives) { EXPECT_EQ(lines(deflated("0 0\n1 0\n\n2 2\n3 3\n", 31)).size(), 2u); }

TEST_F(PointFiles, RecordsOfFewMembersAreRefused) {
  std::string records = "[{";
  for (int k = 0; k < 1000; ++k) records += (k ? "," : "") + std::string("\"k") + std::to_string(k) + "\":1";
  records += "}";
  for (int k = 0; k < 1000; ++k) records += ",{}";
  EXPECT_EQ(error(records + "]"), "is a JSON list of records in which most members are missing");
}

}  // namespace
}  // namespace ligne
