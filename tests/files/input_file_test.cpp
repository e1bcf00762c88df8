#include "files/input_file.hpp"

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>
#include <csignal>
#include <thread>

#include "files/closest_name.hpp"
#include "files/input_error.hpp"
#include "files/message_text.hpp"
#include "files/omissions.hpp"
#include "files/utf16.hpp"
#include "main/script.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

namespace fs = std::filesystem;

class InputFile : public ::testing::Test {
 protected:
  void SetUp() override { std::signal(SIGPIPE, SIG_IGN); }  // of the writers, whose reader may go first

  /// The bytes of the file, or the error without the name.
  static std::string read(const fs::path& file, std::uintmax_t most = kLargestInput) {
    InputFiles opened;
    try {
      const std::vector<std::byte> bytes = read_input(file, "F", opened, most);
      EXPECT_EQ(opened, InputFiles{file});
      return std::string(as_characters(bytes));
    } catch (const InputError& error) {
      return error.what();
    }
  }

  const test::TemporaryFolder folder_;
};

TEST_F(InputFile, ReadsWholeFiles) {
  const std::string text(3'000'001, 'x');
  std::ofstream(folder_ / "large") << text;
  std::ofstream(folder_ / "empty");
  EXPECT_EQ(read(folder_ / "large"), text);
  EXPECT_EQ(read(folder_ / "empty"), "");
  EXPECT_FALSE(read("/proc/self/stat").empty()) << "tells no size";
  EXPECT_EQ(read(folder_ / "large", 1 << 20), "F: is larger than 1 MiB");
}

TEST_F(InputFile, ReadsTheSameBytesWithAllThreads) {
  for (const std::size_t size : {(1u << 23) - 1, 1u << 23, 9'500'001u, (1u << 24) + 5}) {
    std::string text(size, 0);
    for (std::size_t i = 0; i < size; ++i) text[i] = static_cast<char>(i * 2654435761u >> 24);
    std::ofstream(folder_ / "large", std::ios::binary) << text;
    EXPECT_TRUE(read(folder_ / "large") == text) << size;
  }
}

TEST_F(InputFile, NamesPointersOfGitLfs) {
  std::ofstream(folder_ / "pointer") << "version https://git-lfs.github.com/spec/v1\noid sha256:4d7a2146\nsize 12345\n";
  EXPECT_EQ(read(folder_ / "pointer"), "F: is a pointer of Git LFS, not the file: git lfs pull fetches that");
}

TEST_F(InputFile, RefusesWhatIsNoFile) {
  EXPECT_EQ(read(folder_ / "none"), "F: there is no such file");
  EXPECT_EQ(read(folder_), "F: is a directory, not a file");
  for (const char* device : {"/dev/zero", "/dev/urandom", "/dev/full", "/dev/null"})
    EXPECT_EQ(read(device), "F: is a device or a socket, not a file") << device;
  const fs::path closed = folder_.write("closed", "x");
  fs::permissions(closed, fs::perms::none);
  EXPECT_EQ(read(closed), ::geteuid() == 0 ? "x" : "F: can not be opened for reading");
  EXPECT_EQ(read(closed / "below"), "F: there is no such file");
  const int listening = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  (folder_ / "socket").string().copy(address.sun_path, sizeof address.sun_path - 1);
  ASSERT_EQ(::bind(listening, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  EXPECT_EQ(read(folder_ / "socket"), "F: is a device or a socket, not a file");
  ::close(listening);
}

TEST_F(InputFile, ReadsPipesOfWhichSomebodyHasTheOtherEnd) {
  const fs::path pipe = folder_ / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(read(pipe), "F: is a pipe without a writer");
  const std::string text(200'000, 'y');  // more than a pipe holds
  std::thread writer([&] { std::ofstream(pipe) << text; });
  EXPECT_EQ(read(pipe), text);
  writer.join();
}

TEST_F(InputFile, EndlessPipesEnd) {
  const fs::path pipe = folder_ / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::thread writer([&] {
    std::ofstream out(pipe);
    const std::string block(1 << 16, '\0');
    for (int i = 0; i < 64 && out; ++i) out << block;
  });
  EXPECT_EQ(read(pipe, 1 << 20), "F: is larger than 1 MiB, the limit for an input of unknown size");
  writer.join();
}

/// "2 textures; 1 texture": the line about what was left out.
std::string omitted(const std::string& text) {
  Omissions omissions;
  for (const std::string& part : test::parts_of(text, ';')) {
    const std::size_t number = std::stoul(part), end = part.find_first_not_of(" 0123456789");
    omissions.count(part.substr(end), number);
  }
  EXPECT_EQ(omissions.empty(), omissions.text().empty());
  return omissions.text();
}

std::string meant(const std::string& word, std::initializer_list<std::string_view> names) {
  return std::string(closest_name(word, std::vector(names)).value_or("none"));
}

std::string utf8(const std::string& text) {
  const auto bytes = std::as_bytes(std::span(text));
  return std::string(as_characters(as_utf8({bytes.begin(), bytes.end()})));
}

/// Words of messages and texts of files: the folder values.
[[maybe_unused]] const bool values_are_added =
    test::add_function_scripts(LIGNE_SOURCE_DIR "/tests/files/values",
                               {{"counted", [](auto& t) { return counted(std::stoul(t), t.substr(t.find(' ') + 1)); }},
                                {"printable", [](auto& t) { return printable(t); }},
                                {"printable-3", [](auto& t) { return printable(t, 3); }},
                                {"shown", [](auto& t) { return shown(t); }},
                                {"shown-in-marks", [](auto& t) { return shown(t, '"'); }},
                                {"message", [](auto& t) { return message_line(t); }},
                                {"input-error", [](auto& t) { return std::string(InputError(t, "is odd").what()); }},
                                {"omitted", omitted},
                                {"utf8", utf8},
                                {"option",
                                 [](auto& t) {
                                   return meant(t, {"--hide", "--hidden", "--view", "-x", "--x-ray", "--edges"});
                                 }},
                                {"view", [](auto& t) {
                                   return meant(t, {"front", "bottom", "iso", "dimetric", "trimetric"});
                                 }}});

TEST(MessageText, LongTextIsCutBetweenCharacters) {
  const std::string most(kLongestShown, 'x');
  EXPECT_EQ(printable(most), most);
  std::string cut = most;
  cut.append("...");
  EXPECT_EQ(printable(most + "x"), cut);
  EXPECT_EQ(printable(std::string(5'000'000, '\x01')).size(), kLongestShown + 3);
}

TEST(MessageText, ALongMessageLosesItsMiddle) {
  const std::string long_line = message_line("file: " + std::string(5'000'000, 'x') + ": the cause");
  EXPECT_EQ(long_line.size(), kLongestMessage);
  EXPECT_TRUE(long_line.starts_with("file: xxx"));
  EXPECT_TRUE(long_line.ends_with("xxx: the cause"));
  EXPECT_EQ(message_line(long_line), long_line);
  EXPECT_EQ(std::string(InputError("f", std::string(1000, 'x')).what()).size(), kLongestMessage);
  for (std::size_t n = 480; n < 500; ++n) {
    std::string odd(n, 'x');
    for (int i = 0; i < 300; ++i) odd += "\xe2\x82\xac";
    const std::string line = message_line(odd);
    EXPECT_LE(line.size(), kLongestMessage);
    EXPECT_EQ(line.find("\\x"), std::string::npos) << "a character was cut: " << line;
    EXPECT_EQ(message_line(line), line);
  }
}

TEST(Omissions, AMillionKindsAreAFew) {
  Omissions omitted;
  for (int i = 0; i < 1'000'000; ++i) omitted.count("statements " + std::to_string(i));
  EXPECT_EQ(omitted.counts().size(), 17u);
  EXPECT_EQ(omitted.of("other items"), 999'984u);
}

TEST(ClosestName, IsNoneForLongWordsOrWithoutNames) {
  EXPECT_EQ(meant(std::string(100'000, 'x'), {"--view"}), "none");
  EXPECT_EQ(closest_name("--view", {}), std::nullopt);
}

}  // namespace
}  // namespace ligne
