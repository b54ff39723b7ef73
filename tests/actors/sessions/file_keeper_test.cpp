#include <map>

#include "actors/sessions/file_keeper.hpp"
#include "tests/actors/bench.hpp"

namespace parlour::actors {
namespace {

TEST(FileKeeper, TellsTheSession) {
  Bench bench;
  const FileAccess files = [](const FileRequest& request) -> Expected<Value> {
    if (request.name == "bad")
      throw std::runtime_error("disk gone");
    return Value(request.name + "!");
  };
  auto keeper = bench.spawn(file_keeper, files, ActorTrace());
  auto session = bench.session_probe("s1");
  for (auto name : {"a", "bad"})
    bench.send(
        keeper,
        file_order{1, {FileAction::read, name, "", 10}, session, bench.work()});
  EXPECT_THAT(bench.seen,
              ElementsAre("s1 has of a file a!", "s1 has of a file disk gone"));
}

TEST(FileKeeper, HasNothingToKeepWithoutAFolder) {
  Bench bench;
  auto keeper = bench.spawn(file_keeper, FileAccess(), ActorTrace());
  bench.send(keeper,
             file_order{1, {}, bench.session_probe("s1"), bench.work()});
  EXPECT_THAT(bench.seen, ElementsAre(HasSubstr("has no data folder")));
}

class FilesTest : public NodeFixture {
protected:
  FilesTest() {
    options.files = [this](const FileRequest& request) -> Expected<Value> {
      if (request.action == FileAction::append)
        return Value(disk[request.name] += request.text);
      if (!disk.contains(request.name))
        return fail(ErrorKind::file, "there is no " + request.name);
      return Value(disk[request.name]);
    };
  }

  std::map<std::string, std::string> disk;
};

constexpr const char* visitors = R"(
  <handler name="Pipeline"><messages><component>
    <ASR><RecognitionResult>
      <try>
        <readfile name="visitors/{_LPARAM1}" return="text"/>
        <speak param="Again: {text}"/>
        <catch name="e"><speak param="{e.kind}: {e.message}"/></catch>
      </try>
      <appendfile name="visitors/{_LPARAM1}" param="{_LPARAM1} was here."/>
    </RecognitionResult></ASR>
  </component></messages></handler>)";

TEST_F(FilesTest, AreReadAndWrittenForEverySession) {
  start(visitors);
  EXPECT_THAT(say({"Ann", "Ben"}),
              ElementsAre("File: there is no visitors/Ann",
                          "File: there is no visitors/Ben"));
  open_seat();
  EXPECT_THAT(say({"Ann"}), ElementsAre("Again: Ann was here."));
  EXPECT_EQ(disk["visitors/Ann"], "Ann was here.Ann was here.");
  EXPECT_THAT(errors, IsEmpty());
}

TEST_F(FilesTest, AreWaitedForInRealTime) {
  options.virtual_start.reset();
  start(visitors);
  EXPECT_THAT(say({"Ann"}), ElementsAre("File: there is no visitors/Ann"));
  EXPECT_THAT(say({"Ann"}), ElementsAre("Again: Ann was here."));
}

} // namespace
} // namespace parlour::actors
