/// ligne.sh in a tree that is not built and where nothing can be written.

#include <grp.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "program.hpp"

namespace ligne::test {
namespace {

namespace fs = std::filesystem;

TEST_F(ProgramTest, LigneShInAReadOnlyTreeSaysSoInOneLine) {
  const fs::path tree = file("tree");
  fs::create_directories(tree / "scripts");
  for (const char* folder : {"src", "plotting", "cmake"}) fs::create_directory(tree / folder);
  for (const char* name : {"ligne.sh", "CMakeLists.txt", "scripts/setup.sh"})
    fs::copy_file(fs::path(LIGNE_SOURCE_DIR) / name, tree / name);
  for (const auto& entry : fs::recursive_directory_iterator(tree))
    fs::permissions(entry.path(), fs::perms::owner_write, fs::perm_options::remove);
  fs::permissions(tree, fs::perms::owner_write, fs::perm_options::remove);
  fs::permissions(folder_, fs::perms::all);

  const std::string script = (tree / "ligne.sh").string(), messages = file("messages").string();
  const pid_t child = fork();
  if (child == 0) {
    // Permissions stop nobody who is root.
    constexpr uid_t kNobody = 65534;
    if (geteuid() == 0 && (setgroups(0, nullptr) != 0 || setgid(kNobody) != 0 || setuid(kNobody) != 0)) _exit(126);
    if (!freopen(messages.c_str(), "w", stderr)) _exit(125);
    execl("/bin/bash", "bash", script.c_str(), "--version", nullptr);
    _exit(127);
  }
  int status = 0;
  waitpid(child, &status, 0);
  fs::permissions(tree, fs::perms::owner_write, fs::perm_options::add);
  for (const auto& entry : fs::recursive_directory_iterator(tree))
    fs::permissions(entry.path(), fs::perms::owner_write, fs::perm_options::add);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 1);
  EXPECT_EQ(contents(messages), "ligne.sh: " + fs::canonical(tree).string() +
                                    "/build/release: can not be written, and the program in it is not built; build it as "
                                    "somebody who may, or in a copy\n");
}

}  // namespace
}  // namespace ligne::test
