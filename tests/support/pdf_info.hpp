#pragma once
/// Facts about a PDF file as poppler's pdfinfo reads them: since version 1.18 Cairo compresses what they stand in.

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include <unistd.h>

namespace ligne {

inline bool pdf_info_is_there() { return std::system("command -v pdfinfo >/dev/null 2>&1") == 0; }

inline std::string pdf_info(const std::string& pdf) {
  const std::filesystem::path file = std::filesystem::temp_directory_path() / ("ligne-" + std::to_string(getpid()) + ".pdf");
  std::ofstream(file, std::ios::binary) << pdf;
  const std::string info = file.string() + ".txt";
  const int status = std::system(("pdfinfo '" + file.string() + "' >'" + info + "' 2>&1").c_str());
  std::ifstream in(info);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  std::filesystem::remove(file);
  std::filesystem::remove(info);
  if (status != 0) throw std::runtime_error("pdfinfo: " + text);
  return text;
}

}  // namespace ligne
