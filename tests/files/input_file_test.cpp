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

TEST(MessageText, OneIsSingular) {
  EXPECT_EQ(counted(2, "faces with holes"), "2 faces with holes");
  EXPECT_EQ(counted(0, "vertices"), "0 vertices");
  const char* const singular[][2] = {{"faces with holes", "1 face with holes"},
                                     {"missing libraries 'a b'", "1 missing library 'a b'"},
                                     {"vertices", "1 vertex"},
                                     {"meshes with EXT_foo", "1 mesh with EXT_foo"},
                                     {"self-referring <use> elements", "1 self-referring <use> element"},
                                     {"values of x that are not known", "1 value of x that is not known"},
                                     {"column of words", "1 column of words"},
                                     {"@supports rules", "1 @supports rule"},
                                     {"ambiguous number format", "1 ambiguous number format"}};
  for (const auto& [plural, text] : singular) EXPECT_EQ(counted(1, plural), text);
}

TEST(MessageText, PlainTextStaysAsItIs) {
  EXPECT_EQ(printable(""), "");
  EXPECT_EQ(printable("a b\\n'\"?"), "a b\\n'\"?");
  EXPECT_EQ(printable("caf\xc3\xa9 \xe2\x82\xac \xf0\x9f\x96\x8b"), "caf\xc3\xa9 \xe2\x82\xac \xf0\x9f\x96\x8b");
  EXPECT_EQ(shown("x"), "'x'");
  EXPECT_EQ(shown("x", '"'), "\"x\"");
}

TEST(MessageText, WhatDoesNotShowIsEscaped) {
  EXPECT_EQ(printable("a\nb\rc\td"), "a\\nb\\rc\\td");
  EXPECT_EQ(printable(std::string_view("\0\x1b[31m\x7f", 7)), "\\x00\\x1b[31m\\x7f");
  EXPECT_EQ(printable("\xc2\x85"), "\\xc2\\x85") << "next line, of the second row of controls";
  EXPECT_EQ(printable("\xe2\x80\xa8"), "\\xe2\\x80\\xa8") << "line separator";
  EXPECT_EQ(printable("\xe2\x80\xae"), "\\xe2\\x80\\xae") << "turns the direction of what follows";
}

TEST(MessageText, WhatIsNotUtf8IsEscaped) {
  EXPECT_EQ(printable("\x80\xff"), "\\x80\\xff");
  EXPECT_EQ(printable("\xc3"), "\\xc3") << "cut off";
  EXPECT_EQ(printable("\xc3 "), "\\xc3 ");
  EXPECT_EQ(printable("\xc0\xaf"), "\\xc0\\xaf") << "written longer than need be";
  EXPECT_EQ(printable("\xe0\x80\xaf"), "\\xe0\\x80\\xaf");
  EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80") << "half of a pair";
  EXPECT_EQ(printable("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80") << "beyond Unicode";
}

TEST(MessageText, LongTextIsCutBetweenCharacters) {
  const std::string most(kLongestShown, 'x');
  EXPECT_EQ(printable(most), most);
  std::string cut = most;
  cut.append("...");
  EXPECT_EQ(printable(most + "x"), cut);
  EXPECT_EQ(printable("12\xc3\xa9", 3), "12...");
  EXPECT_EQ(printable("12\n", 3), "12...");
  EXPECT_EQ(printable(std::string(5'000'000, '\x01')).size(), kLongestShown + 3);
}

TEST(MessageText, AMessageIsOneLineAndLosesItsMiddle) {
  EXPECT_EQ(message_line("file:3: cause\n"), "file:3: cause");
  EXPECT_EQ(message_line("a\nb"), "a\\nb");
  const std::string long_line = message_line("file: " + std::string(5'000'000, 'x') + ": the cause");
  EXPECT_EQ(long_line.size(), kLongestMessage);
  EXPECT_TRUE(long_line.starts_with("file: xxx"));
  EXPECT_TRUE(long_line.ends_with("xxx: the cause"));
  EXPECT_EQ(message_line(long_line), long_line);
  for (std::size_t n = 480; n < 500; ++n) {
    std::string odd(n, 'x');
    for (int i = 0; i < 300; ++i) odd += "\xe2\x82\xac";
    const std::string line = message_line(odd);
    EXPECT_LE(line.size(), kLongestMessage);
    EXPECT_EQ(line.find("\\x"), std::string::npos) << "a character was cut: " << line;
    EXPECT_EQ(message_line(line), line);
  }
}

TEST(MessageText, ErrorsOfInputAreSuchLines) {
  EXPECT_STREQ(InputError("a\nb", "is odd").what(), "a\\nb: is odd");
  EXPECT_EQ(std::string(InputError("f", std::string(1000, 'x')).what()).size(), kLongestMessage);
}

TEST(Omissions, OneLineNamesKindsInTheirOrder) {
  Omissions omitted;
  EXPECT_TRUE(omitted.empty());
  EXPECT_EQ(omitted.text(), "");
  omitted.count("textures");
  omitted.count("primitives with EXT_foo", 2);
  omitted.count("textures", 3);
  omitted.count("nothing", 0);
  EXPECT_EQ(omitted.text(), "left out: 4 textures, 2 primitives with EXT_foo");
  EXPECT_EQ(omitted.of("textures"), 4u);
  EXPECT_EQ(omitted.of("nothing"), 0u);
}

TEST(Omissions, NamesOfTheFileAreMadePrintable) {
  Omissions omitted;
  omitted.count("statements \x1b[2J\nligne: all is well");
  EXPECT_EQ(omitted.list(), "1 statement \\x1b[2J\\nligne: all is well");
}

TEST(Omissions, AMillionKindsAreAFew) {
  Omissions omitted;
  for (int i = 0; i < 1'000'000; ++i) omitted.count("statements " + std::to_string(i));
  EXPECT_EQ(omitted.counts().size(), 17u);
  EXPECT_EQ(omitted.of("other items"), 999'984u);
}

const std::vector<std::string_view> kNames{"--hide", "--hidden", "--view", "-x", "--x-ray", "--edges"};
const std::vector<std::string_view> kViews{"front", "bottom", "iso", "dimetric", "trimetric"};

std::string_view meant(std::string_view word, const std::vector<std::string_view>& names = kNames) {
  return closest_name(word, names).value_or("");
}

TEST(ClosestName, IsWhatSlipsOfTheKeysMakeOf) {
  EXPECT_EQ(meant("--veiw"), "--view");      // exchanged
  EXPECT_EQ(meant("--vieww"), "--view");     // added
  EXPECT_EQ(meant("--wiew=top"), "--view");  // replaced
  EXPECT_EQ(meant("--hiden"), "--hidden");   // left out, sooner than added to --hide
  EXPECT_EQ(meant("--x"), "-x");
  EXPECT_EQ(meant("-hidden"), "--hidden");
  EXPECT_EQ(meant("--hyddin"), "--hidden");
}

TEST(ClosestName, IsWhatIsWrittenShorterOrLonger) {
  EXPECT_EQ(meant("isometric", kViews), "iso");
  EXPECT_EQ(meant("trim", kViews), "trimetric");
  EXPECT_EQ(meant("bot", kViews), "bottom");
  EXPECT_EQ(meant("is", kViews), "");  // two letters begin too much
  EXPECT_EQ(meant("hid"), "--hide");
}

TEST(ClosestName, IsNoneWhereNoneIsNear) {
  EXPECT_EQ(meant("--y"), "");
  EXPECT_EQ(meant("--veeew"), "");
  EXPECT_EQ(meant("--frobnicate"), "");
  EXPECT_EQ(meant("--"), "");
  EXPECT_EQ(meant(""), "");
  EXPECT_EQ(meant(std::string(100'000, 'x')), "");
  EXPECT_EQ(closest_name("--view", {}), std::nullopt);
}

}  // namespace
}  // namespace ligne
