/// ligne.sh in a tree where nothing can be written, and in one whose programs are built when they are first asked for.

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

/// A project with the two programs as scripts that say their names.
constexpr std::string_view kTwoPrograms = R"(cmake_minimum_required(VERSION 3.25)
project(two NONE)
foreach(name ligne ligne-study)
  file(WRITE ${CMAKE_BINARY_DIR}/${name}.sh "#!/bin/sh\necho ${name} $*\n")
  file(CHMOD ${CMAKE_BINARY_DIR}/${name}.sh PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)
  add_custom_target(${name} ALL COMMAND ${CMAKE_COMMAND} -E make_directory src/cli
                    COMMAND ${CMAKE_COMMAND} -E copy ${name}.sh src/cli/${name})
endforeach()
add_dependencies(ligne-study ligne)
)";

TEST_F(ProgramTest, LigneShBuildsTheStudyWhenItIsFirstAskedFor) {
  const fs::path tree = file("tree");
  for (const char* folder : {"src", "plotting", "cmake", "studies", "scripts"}) fs::create_directories(tree / folder);
  for (const char* name : {"ligne.sh", "scripts/setup.sh"}) fs::copy_file(fs::path(LIGNE_SOURCE_DIR) / name, tree / name);
  write("tree/CMakeLists.txt", kTwoPrograms);
  const auto said_by = [&](const std::string& arguments) {
    const std::string command =
        "bash '" + (tree / "ligne.sh").string() + "' " + arguments + " >'" + file("said").string() + "'";
    EXPECT_EQ(std::system(command.c_str()), 0) << arguments;
    return contents(file("said"));
  };
  const fs::path study = tree / "build/release/src/cli/ligne-study";
  EXPECT_EQ(said_by("draw a"), "ligne draw a\n");
  EXPECT_FALSE(fs::exists(study)) << "whoever draws does not wait for it";
  EXPECT_EQ(said_by("study --list"), "ligne study --list\n") << "the program runs the other one";
  ASSERT_TRUE(fs::exists(study));
  fs::remove(study);
  EXPECT_EQ(said_by("draw a"), "ligne draw a\n");
  EXPECT_FALSE(fs::exists(study));
}

}  // namespace
}  // namespace ligne::test
