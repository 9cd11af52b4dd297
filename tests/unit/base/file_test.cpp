#include "base/file.hpp"

#include <catch2/catch.hpp>

#include "base/text.hpp"
#include "support/temporary_folder.hpp"

using namespace manifuzz;
namespace fs = std::filesystem;

TEST_CASE("A path is resolved to one spelling") {
  const test::TemporaryFolder folder;
  const fs::path file = folder.write("file", "");
  fs::create_directory(folder.path() / "below");
  fs::create_symlink("file", folder.path() / "link");
  fs::create_symlink("below", folder.path() / "link-below");
  fs::create_symlink("nothing", folder.path() / "dangling");
  CHECK(resolved(folder.path() / "below" / ".." / "file") == resolved(file));
  CHECK(resolved(fs::proximate(file)) == resolved(file));
  CHECK(resolved(folder.path() / "link") == resolved(file));
  CHECK(resolved(folder.path() / "link-below" / "new") ==
        resolved(folder.path() / "below" / "new"));
  CHECK(resolved(folder.path() / "dangling") == resolved(folder.path() / "nothing"));
  CHECK(resolved(folder.path() / "new") != resolved(file));
  CHECK(resolved("-") == "-");
}

TEST_CASE("A link to itself is resolved to something") {
  const test::TemporaryFolder folder;
  fs::create_symlink("round", folder.path() / "round");
  CHECK_NOTHROW(resolved(folder.path() / "round"));
}

TEST_CASE("A path is within a folder by where it is, not by its spelling") {
  const test::TemporaryFolder folder;
  fs::create_directory(folder.path() / "below");
  fs::create_symlink("below", folder.path() / "link");
  CHECK(is_within(folder.path() / "link" / "new.json", folder.path() / "below"));
  CHECK(is_within(folder.path(), folder.path()));
  CHECK_FALSE(is_within(folder.path() / "below" / ".." / "new.json", folder.path() / "below"));
  CHECK_FALSE(is_within(folder.path() / "below2", folder.path() / "below"));
}

TEST_CASE("A new folder is gone again unless it is kept") {
  const test::TemporaryFolder folder;
  const fs::path path = folder.path() / "new" / "folder";
  {
    const NewFolder unkept(path, "there");
    fs::create_directories(unkept.path());
    folder.write("new/folder/file", "");
  }
  CHECK(fs::is_empty(folder.path()));
  {
    NewFolder kept(path, "there");
    fs::create_directories(kept.path());
    folder.write("new/folder/file", "");
    kept.keep();
  }
  CHECK(fs::exists(path / "file"));
  CHECK_THROWS_WITH(NewFolder(path, "there"),
                    "there is there already; a new or an empty folder is expected");
}

TEST_CASE("An empty folder stays, and is empty again unless it is kept") {
  const test::TemporaryFolder folder;
  {
    const NewFolder unkept(folder.path(), "there");
    folder.write("file", "");
  }
  CHECK(fs::is_empty(folder.path()));
}
