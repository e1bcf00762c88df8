#include "scene/tables/unpack.hpp"

#include <algorithm>

#include <zlib.h>

#include "files/input_error.hpp"
#include "files/message_text.hpp"
#include "scene/readers/format_readers.hpp"
#include "scene/readers/zip_archive.hpp"
#include "scene/tables/data_array.hpp"

namespace ligne {
namespace {

constexpr ForeignFormat kForeignDataFormats[] = {
    {"\x89HDF\r\n\x1a\n", "an HDF5 or netCDF-4 file", "nccopy -k classic IN OUT.nc, or gdal_translate -of GTiff IN OUT.tif"},
    {"MATLAB 7.3", "a MATLAB file of version 7.3", "save it again in MATLAB: save('OUT.mat', '-v7')"},
    {"PAR1", "a Parquet file", "python3 -c \"import pandas; pandas.read_parquet('IN').to_csv('OUT.csv')\""},
    {"ARROW1", "an Arrow file", "python3 -c \"import pandas; pandas.read_feather('IN').to_csv('OUT.csv')\""},
    {"FEA1", "a Feather file", "python3 -c \"import pandas; pandas.read_feather('IN').to_csv('OUT.csv')\""},
    {"\xD0\xCF\x11\xE0", "a file of Microsoft Office", "save it as CSV"},
    {"SQLite format 3", "an SQLite database", "sqlite3 -csv IN 'SELECT x, y, z FROM ...' > OUT.csv"},
    {"RDX2\n", "a file of R", "in R: load('IN'), then write.csv(..., 'OUT.csv')"},
    {"RDX3\n", "a file of R", "in R: load('IN'), then write.csv(..., 'OUT.csv')"},
    {{"X\n\0\0\0", 5}, "an object of R (RDS)", "in R: write.csv(readRDS('IN'), 'OUT.csv')"},
    {"\x80\x03", "a pickle of Python", "save the array with numpy.save"},
    {"\x80\x04", "a pickle of Python", "save the array with numpy.save"},
    {"\x80\x05", "a pickle of Python", "save the array with numpy.save"},
    {{"\xFD"
      "7zXZ\0",
      6},
     "an xz archive",
     "xz -d IN"},
    {"BZh", "a bzip2 archive", "bzip2 -d IN"},
    {"\x28\xB5\x2F\xFD", "a Zstandard archive", "zstd -d IN"},
    {"\x1F\x9D", "a compress archive", "gzip -d IN"},
    {"7z\xBC\xAF\x27\x1C", "a 7z archive", "7z x IN"},
    {"Rar!", "a RAR archive", "unrar x IN"},
    {"\xFF\xD8\xFF", "a JPEG image", "convert IN -colorspace Gray OUT.png, if its grey is height"},
    {"GIF8", "a GIF image", "convert IN -colorspace Gray OUT.png, if its grey is height"},
    {"BM", "a BMP image", "convert IN -colorspace Gray OUT.png, if its grey is height"},
    {{"\0\0\0\x0CjP  ", 8}, "a JPEG 2000 image", "gdal_translate -of GTiff IN OUT.tif"},
    {"GRIB", "a GRIB file", "gdal_translate -of GTiff -b 1 IN OUT.tif"},
    {"# .PCD", "a point cloud (PCD)", "pcl_pcd2ply IN OUT.ply"},
    {"LASF", "a cloud of laser points (LAS)", "las2txt --parse xyz IN OUT.txt"},
    {"EHFA_HEADER_TAG", "an ERDAS Imagine file", "gdal_translate -of GTiff IN OUT.tif"},
    {"%PDF", "a PDF document", "it holds pages"},
    {"<VRTDataset", "a virtual raster of GDAL", "gdal_translate -of GTiff IN OUT.tif"},
};

constexpr std::size_t kWindowBits = 15, kGzipToo = 16;

std::vector<std::byte> inflate_all(std::span<const std::byte> bytes, std::size_t window, const std::string& name) {
  z_stream stream{};
  const auto fail = [&](const std::string& cause) {
    inflateEnd(&stream);
    return InputError(name, cause);
  };
  if (inflateInit2(&stream, static_cast<int>(window)) != Z_OK) throw InputError(name, "can not be unpacked");
  constexpr std::size_t kStep = std::size_t{1} << 20;
  std::vector<std::byte> out;
  std::size_t used = 0;
  int state = Z_OK;
  while (true) {
    if (stream.avail_in == 0 && used < bytes.size()) {
      const std::size_t part = std::min(bytes.size() - used, kStep);
      stream.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(bytes.data() + used));
      stream.avail_in = static_cast<uInt>(part);
      used += part;
    }
    const std::size_t before = out.size(), room = std::min(kStep, std::max<std::size_t>(before, 4096));
    try {
      out.resize(before + room);
    } catch (...) {
      inflateEnd(&stream);
      throw;
    }
    stream.next_out = reinterpret_cast<Bytef*>(out.data() + before);
    stream.avail_out = static_cast<uInt>(room);
    state = inflate(&stream, Z_NO_FLUSH);
    out.resize(out.size() - stream.avail_out);
    if (out.size() > kMostUnpacked) throw fail("unpacks to more than " + std::to_string(kMostUnpacked) + " bytes");
    if (state == Z_STREAM_END) {
      // A gzip file may have several consecutive members.
      const bool more = stream.avail_in > 0 || used < bytes.size();
      if (!more || window == kWindowBits || inflateReset(&stream) != Z_OK) break;
      continue;
    }
    if (state != Z_OK && state != Z_BUF_ERROR) {
      // Zeros or other bytes after the last member do not belong to it.
      if (!out.empty() && stream.total_out == 0) break;
      throw fail("is a damaged archive");
    }
    if (state == Z_BUF_ERROR && stream.avail_in == 0 && used == bytes.size()) throw fail("is a truncated archive");
  }
  inflateEnd(&stream);
  return out;
}

bool is_office(const ZipArchive& archive) {
  return archive.find("xl/workbook.xml") || archive.find("content.xml") || archive.find("word/document.xml");
}

std::optional<UnpackedFile> unzipped(std::span<const std::byte> bytes, const std::string& name) {
  const ZipArchive archive(bytes, name);
  if (is_office(archive))
    throw InputError(
        name, "is a spreadsheet or document, which is not read: save it as CSV, or with: libreoffice --convert-to csv IN");
  const ZipEntry* alone = nullptr;
  std::size_t files = 0;
  for (const ZipEntry& entry : archive.entries()) {
    if (entry.name.ends_with('/')) continue;
    ++files;
    alone = &entry;
  }
  const auto is_npy_file = [](const ZipEntry& entry) { return entry.name.ends_with(kNpySuffix); };
  if (files > 1 && std::ranges::all_of(archive.entries(), is_npy_file)) return {};
  if (files != 1)
    throw InputError(name, "is a ZIP archive of " + std::to_string(files) + " files: unpack it, and take one of them");
  if (alone->size > kMostUnpacked)
    throw InputError(name, "unpacks to more than " + std::to_string(kMostUnpacked) + " bytes");
  return UnpackedFile{archive.read(*alone), alone->name};
}

}  // namespace

std::optional<UnpackedFile> unpacked(std::span<const std::byte> bytes, const std::string& name) {
  const std::string_view chars(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (chars.starts_with("PK\x03\x04")) return unzipped(bytes, name);
  if (!chars.starts_with("\x1F\x8B")) return {};
  const bool has_suffix = lower_case(name).ends_with(".gz");
  return UnpackedFile{inflate_all(bytes, kWindowBits + kGzipToo, name), has_suffix ? name.substr(0, name.size() - 3) : name};
}

std::vector<std::byte> inflated(std::span<const std::byte> bytes, const std::string& name) {
  return inflate_all(bytes, kWindowBits, name);
}

std::optional<std::string> foreign_data_format(std::string_view bytes) { return foreign_format(bytes, kForeignDataFormats); }

}  // namespace ligne
