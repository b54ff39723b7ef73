#include <future>

#include "adapters/process/component_process.hpp"
#include "tests/adapters/process/process_fixture.hpp"

namespace parlour::adapters {
namespace {

// What makes a shell say it to us.
std::string says(const IpcMessage& message) {
  const auto bytes = ipc_bytes(message).value();
  std::string octal;
  for (const char one : bytes) {
    const int byte = one & 0xff;
    octal += '\\';
    for (const int shift : {6, 3, 0})
      octal += static_cast<char>('0' + (byte >> shift & 7));
  }
  return "printf '" + octal + "' >&3;";
}

class ComponentProcessTest : public testing::Test {
protected:
  void start(const ProcessOrder& order) {
    process.emplace(
        order,
        [this](ComponentProcess&, const IpcMessage& message) -> Expected<void> {
          taken.push_back(std::string(name_of(message.kind)));
          if (message.kind == IpcKind::failed)
            return fail(ErrorKind::network, "not to be taken");
          return {};
        },
        [this](const std::string& line) { printed.push_back(line); });
  }
  Expected<IpcMessage> start_trial() {
    start(trial());
    if (auto hello = process->hello(patience); !hello)
      return hello;
    return call(IpcKind::start, {0, false, Map{}});
  }
  Expected<IpcMessage> call(IpcKind kind, List fields) {
    return process->call({kind, std::move(fields)}, patience);
  }

  std::vector<std::string> taken;
  std::vector<std::string> printed; // once it is over
  std::optional<ComponentProcess> process;
};

TEST_F(ComponentProcessTest, HearsHelloFirst) {
  start(trial());
  const auto hello = process->hello(patience).value();
  EXPECT_EQ(hello.at(0), Value(ipc_protocol));
  EXPECT_EQ(hello.at(1), Value("Trial"));
}

TEST_F(ComponentProcessTest, CarriesOutWhatIsSaidBeforeACallReturns) {
  ASSERT_TRUE(start_trial());
  const auto done =
      call(IpcKind::handle,
           {0, List{0, 0, "", "Flood", List{1000}, List{}, "", 0}})
          .value();
  EXPECT_TRUE(done.at(0).is_unknown());
  EXPECT_EQ(taken.size(), 1000u);
}

TEST_F(ComponentProcessTest, EndsWhoSaysWhatIsNotToBeTaken) {
  ASSERT_TRUE(start_trial());
  const auto done =
      call(IpcKind::handle, {0, List{0, 0, "", "Broken", List{}, List{}}});
  ASSERT_TRUE(done || done.error().message == "not to be taken");
  const auto again = call(IpcKind::stop, {0});
  ASSERT_FALSE(again);
  EXPECT_EQ(again.error().message, "not to be taken");
}

TEST_F(ComponentProcessTest, TellsOnceThatItIsOver) {
  ASSERT_TRUE(start_trial());
  EXPECT_FALSE(
      call(IpcKind::handle, {0, List{0, 0, "", "Exit", List{}, List{}}}));
  std::promise<std::string> first;
  process->when_over([&](const std::string& why) { first.set_value(why); });
  EXPECT_EQ(first.get_future().get(), "its process ended with status 1");
  std::promise<std::string> second;
  process->when_over([&](const std::string& why) { second.set_value(why); });
  EXPECT_EQ(second.get_future().get(), "its process ended with status 1");
}

TEST_F(ComponentProcessTest, SaysWhatItPrintsToTheLast) {
  start(shell("echo 'cannot open the device' >&2; printf 'so I'; kill -9 $$"));
  const auto hello = process->hello(patience);
  ASSERT_FALSE(hello);
  EXPECT_EQ(hello.error().message,
            "its process was killed by signal 9 (Killed)");
  EXPECT_THAT(printed, ElementsAre("cannot open the device", "so I"));
}

// Nobody waits for it to have printed all, and the log stays readable.
TEST_F(ComponentProcessTest, MayPrintAsMuchAsItLikes) {
  start(shell("yes | head -c 10000000"));
  EXPECT_FALSE(process->hello(patience));
  EXPECT_LT(printed.size(), 10'000u);
}

// What is being taken may take its time: it talks to the process until the
// destructor hangs up, while the owner has none any more.
TEST_F(ComponentProcessTest, IsThereForWhatIsBeingTakenToTheLast) {
  std::promise<void> taking;
  std::promise<std::string> refused;
  process.emplace(
      shell(says({IpcKind::hello, {}}) + "head -c 1 <&3 >/dev/null;" +
            says({IpcKind::column, {1, "db:a.b"}}) + "cat <&3 >/dev/null"),
      [&](ComponentProcess& self, const IpcMessage& question) {
        taking.set_value();
        auto told = self.tell({IpcKind::reply, {question.at(0)}});
        while (told)
          told = self.tell({IpcKind::reply, {question.at(0)}});
        refused.set_value(told.error().message);
        return told;
      },
      [](const std::string&) {});
  ASSERT_TRUE(process->hello(patience));
  ASSERT_TRUE(process->tell({IpcKind::log, {}})); // "ask, nobody calls you"
  taking.get_future().wait();
  process.reset();
  EXPECT_EQ(refused.get_future().get(), "it has closed its connection");
}

TEST_F(ComponentProcessTest, IsEndedAtOnceWhereNobodyWantsItAnyMore) {
  start(shell("kill -STOP $$")); // before or after it is there
  process.reset();
}

} // namespace
} // namespace parlour::adapters
